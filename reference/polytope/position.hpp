// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets A and B.
// Output  whether O lies inside P = B (+) (-A), on its boundary or outside, with a proof.   [AGHRS, section 2.2, step before the algorithm]
// Time    linear expected in |A| + |B|.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"
#include "kernels/report.hpp"
#include "kernels/vector.hpp"

namespace fathom::polytope {

enum class Position { inside, boundary, outside };

/// Below, h(u) = max_b <u,b> - min_a <u,a> is the support function of P.
struct PositionOfOrigin {
  Position position = Position::outside;
  /// outside: primitive u with h(u) < 0. boundary: primitive u with h(u) = 0. inside: none.
  std::optional<Vector> normal;
  /// inside and boundary: convex weights (each list sums to 1) with sum of weighted a = sum of weighted b. outside: empty.
  std::vector<Weight> a, b;
  /// inside: index pairs (a, b) whose differences b - a have O in the interior of their convex hull. Otherwise empty.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> surrounding;
  std::size_t scans = 0;  ///< linear scans over all points that it took
};

/// The clouds must have the same exponent and be non-empty.
PositionOfOrigin position_of_origin(const kernels::PointCloud& a, const kernels::PointCloud& b);

/// Checks the proof, and nothing but the proof.
[[nodiscard]] kernels::Report validate(const PositionOfOrigin& answer, std::span<const Vector> a, std::span<const Vector> b);

}  // namespace fathom::polytope
