// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of unions of convex pieces: convex bodies that were cut, and bodies that are not convex.
#pragma once

#include <vector>

#include "fathom/union.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

// ---- convex bodies cut into pieces that abut exactly: whatever the cut, the union is the body
// ----

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

// ---- bodies and pairs ----

// Bodies as unions of convex pieces: clusters, combs, keys, slots, rings; and pairs of them in
// random places. `n` is the number of pieces, or about that.

struct UnionPair {
  Pieces a, b;
};

std::vector<Point> box_from(const Point& low, const Point& high);
Pieces translated(const Pieces& pieces, const Point& by);

/// Hulls of `points` points near spheres of radii near 2/5, the centre of each beside that of the
/// last: multiples of 2^-16.
Pieces cluster(Random& random, unsigned n, unsigned points);
/// Boxes with corners in {0..5}^3.
Pieces lattice_boxes(Random& random, unsigned n);
/// A back and n teeth of width 1 along x, one apart from the next, of the given length along y.
Pieces comb(unsigned n, const mpq_class& tooth_length);
/// A ring of n wedges that abut, at least 3, about the z axis, or about the y axis if `upright`:
/// radii 3/4 and 5/4, height 1/2.
Pieces ring(unsigned n, bool upright);
/// n + 1 walls with slots of the given width between them, along x; each is 2 thick.
Pieces slotted(unsigned n, const mpq_class& width);

UnionPair clusters(Random& random, unsigned n);
UnionPair lattice_clusters(Random& random, unsigned n);
UnionPair box_unions(Random& random, unsigned n);
UnionPair box_unions_touching(Random& random, unsigned n);
UnionPair clusters_apart(Random& random, unsigned n);

/// Convex bodies, both cut, in different ways.
UnionPair cut_cones(Random& random, unsigned n);
UnionPair cut_slabs(Random& random, unsigned n);
UnionPair cut_planes(Random& random, unsigned n);
UnionPair cut_grids(Random& random, unsigned n);
UnionPair cut_repeated(Random& random, unsigned n);
UnionPair cut_same(Random& random, unsigned n);
UnionPair cut_and_whole(Random& random, unsigned n);

UnionPair combs(Random& random, unsigned n);
UnionPair keys(Random& random, unsigned n);
UnionPair slots(Random& random, unsigned n);
UnionPair slots_narrow(Random& random, unsigned n);
UnionPair rings_linked(Random& random, unsigned n);
UnionPair ring_and_rod(Random& random, unsigned n);

}  // namespace fathom::families
