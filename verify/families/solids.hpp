// SPDX-License-Identifier: GPL-3.0-or-later
// Named solids with rational vertices, and exact placements of bodies.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fathom/files.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

/// The two bodies of a case that has no name yet.
struct Bodies {
  Body a, b;
};

// ---- placements: translation, scaling, rotation by a rational matrix ----

/// A rotation about O with rational entries, by rows.
using Rotation = std::array<Point, 3>;

/// The rotation of the quaternion w + xi + yj + zk, which need not have unit length but must not be
/// 0.
Rotation rotation(long w, long x, long y, long z);

/// From a quaternion with small integer components.
Rotation random_rotation(Random& random);

Body rotated(const Body& body, const Rotation& rotation);
Body translated(const Body& body, const Point& by);
/// Scaled along the axes, about O.
Body scaled(const Body& body, const mpq_class& x, const mpq_class& y, const mpq_class& z);
Body scaled(const Body& body, const mpq_class& factor);

/// Both bodies by the same rotation.
Bodies rotated(const Bodies& bodies, const Rotation& rotation);

/// Each component a multiple of 2^-20 in [-bound, bound].
Point random_shift(Random& random, long bound);

// ---- points near a circle, on an integer grid, without the trigonometry of the C library (which
// differs between machines) ----

/// A grid point near radius * (cos, sin).
struct CirclePoint {
  std::int64_t cosine, sine;
};

/// Returns a grid point within about one unit of 2^bits (cos t, sin t) for t = 2 pi k / n. Exactly
/// symmetric under quarter turns and reflections wherever n allows it. 0 < n <= 2^30, 0 <= k < n,
/// bits <= 52.
CirclePoint circle_point(std::uint64_t k, std::uint64_t n, unsigned bits);

/// A grid fine enough for a regular n-gon to be strictly convex after rounding; at most 52 for n <=
/// 2^20.
unsigned circle_bits(std::uint64_t n);

/// The regular n-gon, counter-clockwise, turned by `phase` / 4 of a step.
std::vector<CirclePoint> regular_polygon(std::uint64_t n, unsigned phase = 0);

// ---- solids, centred at O, of size about 1 ----

Body box(const mpq_class& half_x, const mpq_class& half_y, const mpq_class& half_z);
Body tetrahedron();  ///< regular: four corners of the cube [-1,1]^3
Body cube();         ///< [-1,1]^3
Body octahedron();   ///< +-e_i
/// Twelve pentagons, exactly planar (a pyritohedron), with 55/89 for the reciprocal of the golden
/// ratio.
Body dodecahedron();
/// Twenty triangles, with 89/55 for the golden ratio.
Body icosahedron();
/// The five above, in this order, by index modulo 5.
Body platonic(unsigned index);

/// On the near-regular n-gon of radius 1 (regular_polygon), along z from -half_height to
/// half_height; turned by `phase` / 4 of a step.
Body prism(unsigned n, const mpq_class& half_height, unsigned phase = 0);
/// The same with the upper polygon turned by half a step: a band of 2n triangles.
Body antiprism(unsigned n, const mpq_class& half_height);

}  // namespace fathom::families
