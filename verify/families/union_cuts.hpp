// SPDX-License-Identifier: GPL-3.0-or-later
// Convex bodies cut into pieces that abut exactly. Whatever the cut, the union is the body.
#pragma once

#include <vector>

#include "fathom/union.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

/// Whether the points lie in one plane.
bool is_flat(const std::vector<Point>& points);

/// The vertices of the convex hull, in the order of the input; `points` need not be in one plane.
std::vector<Point> hull_vertices(const std::vector<Point>& points);

/// One piece over each facet, from the mean of the vertices.
Pieces cut_into_cones(const std::vector<Point>& body);

/// Each piece that the plane <normal, x> = height meets in its interior, in two.
Pieces cut_by_plane(const Pieces& pieces, const Vector& normal, const mpq_class& height);

/// `count` slabs of equal thickness between planes with this normal.
Pieces cut_into_slabs(const std::vector<Point>& body, const Vector& normal, unsigned count);

/// By random planes through points within, until there are at least `count` pieces.
Pieces cut_by_random_planes(Random& random, const std::vector<Point>& body, unsigned count);

/// The box from `low` to `high` in a grid of `cells` along each axis.
Pieces cut_into_grid(const Point& low, const Point& high, unsigned cells);

}  // namespace fathom::families
