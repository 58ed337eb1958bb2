// SPDX-License-Identifier: GPL-3.0-or-later
// Exact placements of bodies: translation, scaling, rotation by a rational matrix.
#pragma once

#include <array>

#include "fathom/files.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

/// The two bodies of a case that has no name yet.
struct Bodies {
  Body a, b;
};

/// A rotation about O with rational entries, by rows.
using Rotation = std::array<Point, 3>;

/// The rotation of the quaternion w + xi + yj + zk, which need not have unit length but must not be 0.
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

}  // namespace fathom::families
