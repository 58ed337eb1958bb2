// SPDX-License-Identifier: GPL-3.0-or-later
// Raw hulls of integer points, as CGAL's algorithms leave them. For convex_hull alone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::polytope {

/// Three indices of points, counter-clockwise seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// Triangles that cover the boundary of the hull of points[id], id in `ids`, once. Exact for integers of any size. No triangle is
/// degenerate; neighbours may be coplanar and corners may lie inside a facet or an edge.
/// `ids` must be distinct points that affinely span space.
std::vector<HullTriangle> hull_triangles(std::span<const Vector> points, std::span<const std::uint32_t> ids);

/// The corners of the hull of points[id], id in `ids`, in the projection that forgets coordinate `axis` (0, 1, 2 for x, y, z):
/// extreme points only, counter-clockwise seen from the positive end of that axis. Exact.
/// `ids` must have distinct projections that affinely span the plane.
std::vector<std::uint32_t> hull_cycle(std::span<const Vector> points, std::span<const std::uint32_t> ids, int axis);

}  // namespace fathom::polytope
