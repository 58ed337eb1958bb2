// SPDX-License-Identifier: GPL-3.0-or-later
// The naive twins: of the whole pipeline the convex hull of all vertex differences, P itself, facet
// by facet; of the stages after the hulls all pairs of features; of the gap all facets of P.
#pragma once

#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/nearest.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {

/// squared: depth^2 in the unit of the input, in lowest terms; 0 unless penetrating. directions:
/// primitive outward normals of the nearest facets of P, sorted lexicographically; empty unless
/// penetrating.
struct NaiveDepth {
  Status status = Status::disjoint;
  mpq_class squared;
  std::vector<Vector> directions;
  friend bool operator==(const NaiveDepth&, const NaiveDepth&) = default;
};

/// Where O lies in P = B (+) (-A) for finite sets of integer points, in the time of a hull of mn
/// points, where m and n count the extreme points. Bodies of any rank. Throws std::invalid_argument
/// when one is empty.
NaiveDepth naive_depth(std::span<const Vector> a, std::span<const Vector> b);

/// The facet planes of P nearest to O, given the hulls of A and of B, with O in the interior of P:
/// facets of A or of B against vertices, and crossing edges. The quadratic twin of the stages from
/// Gaussian diagrams to closest lines: every facet normal against every vertex, every edge against
/// every edge by an exact test of its arcs, all in exact arithmetic. O(mn).
kernels::NearestPlanes nearest_facets_naive(const polytope::Polytope& a, const polytope::Polytope& b);

/// A twin as other libraries would write it: every edge against every edge, with the double filter.
/// O(mn), a few nanoseconds a pair. `exponent` bounds the coordinates: |c| <= 2^exponent.
kernels::NearestPlanes nearest_facets_scan(const polytope::Polytope& a, const polytope::Polytope& b, long exponent);

/// The twin of second_nearest_squared. Looks at all facets of the hull of all vertex differences.
/// Throws std::invalid_argument unless the bodies penetrate.
std::optional<mpq_class> second_nearest_squared_naive(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::depth
