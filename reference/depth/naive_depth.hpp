// SPDX-License-Identifier: GPL-3.0-or-later
// The naive twin of the whole pipeline: the convex hull of all vertex differences, P itself, facet by facet.
// Input   two finite, non-empty sets of integer points.
// Output  where O lies in P = B (+) (-A), the squared depth, and the direction of every optimum.
// Time    that of a hull of mn points, where m and n count the extreme points.
#pragma once

#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/vector.hpp"

namespace fathom::depth {

/// squared: depth^2 in the unit of the input, in lowest terms; 0 unless penetrating. directions: primitive outward normals of the nearest
/// facets of P, sorted lexicographically; empty unless penetrating.
struct NaiveDepth {
  Status status = Status::disjoint;
  mpq_class squared;
  std::vector<Vector> directions;
  friend bool operator==(const NaiveDepth&, const NaiveDepth&) = default;
};

/// Bodies of any rank. Throws std::invalid_argument when one is empty.
NaiveDepth naive_depth(std::span<const Vector> a, std::span<const Vector> b);

}  // namespace fathom::depth
