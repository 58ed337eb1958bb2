// SPDX-License-Identifier: GPL-3.0-or-later
// The naive twin of convex_hull: supporting planes through all triples of points. For tests and
// small inputs: O(n^4) and worse.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::polytope {

/// A hull as sets of input ids (of equal points the lowest), so that it can be compared without
/// regard to numbering.
struct NaiveHull {
  int rank = 0;
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< lower id first
  /// Primitive outward normal and ids of the corners, ascending. Rank 2: the polygon with either
  /// normal.
  std::set<std::pair<std::vector<mpz_class>, std::vector<std::uint32_t>>> facets;
  friend bool operator==(const NaiveHull&, const NaiveHull&) = default;
};

/// By the definitions. Exact. `points` must not be empty.
NaiveHull convex_hull_naive(std::span<const Vector> points);

}  // namespace fathom::polytope
