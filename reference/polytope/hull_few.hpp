// SPDX-License-Identifier: GPL-3.0-or-later
// The twin of hull_triangles for few points: quadratic, and several times as fast there. For convex_hull alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reference/polytope/hull.hpp"

namespace fathom::polytope {

/// Up to so many points it is used: it is quadratic, and near 20 points, as most bodies have, several times as fast.
inline constexpr std::size_t few_points = 64;

/// Returns triangles as hull_triangles states, in general others where points are coplanar.
std::vector<HullTriangle> hull_triangles_of_few(std::span<const Vector> points, std::span<const std::uint32_t> ids);

}  // namespace fathom::polytope
