// SPDX-License-Identifier: GPL-3.0-or-later
// Convex bodies that need not be polytopes: spheres, capsules, rounded hulls, cylinders, cones, ellipsoids, half-spaces, and sums of them.
//
// Every body is a core and the ball of a radius around each of its points. A core is a half-space, or a Minkowski sum of terms; a term is the
// convex hull of atoms; an atom is a point, or a disc or ball under an affine map. All numbers are rational, so a body is exactly what its
// numbers say. Lengths are in the unit of the coordinates.                                                             [proofs/shapes.md]
#pragma once

#include <gmpxx.h>

#include <variant>
#include <vector>

#include "fathom/point.hpp"

namespace fathom {

/// The points center + sum of y_i axes[i], for y with |y| <= 1: a point without axes, a disc with two, a ball with three. The axes need not be
/// orthogonal, nor independent: an atom may be flat.
struct Atom {
  Point center;
  std::vector<Point> axes;  ///< none, two or three
  friend bool operator==(const Atom&, const Atom&) = default;
};

/// The convex hull of its atoms, of which there is at least one.
struct Term {
  std::vector<Atom> atoms;
  friend bool operator==(const Term&, const Term&) = default;
};

/// The points x with <normal,x> <= offset. The normal is not zero.
struct HalfSpace {
  Point normal;
  mpq_class offset;
  friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

/// The set of points at most `radius` away from the core.
struct Shape {
  std::variant<std::vector<Term>, HalfSpace> core;  ///< the Minkowski sum of the terms, at least one; or a half-space
  mpq_class radius = 0;                             ///< >= 0
  friend bool operator==(const Shape&, const Shape&) = default;
};

}  // namespace fathom
