// SPDX-License-Identifier: GPL-3.0-or-later
// Convex bodies that need not be polytopes: spheres, capsules, rounded hulls, cylinders, cones,
// ellipsoids, half-spaces, and sums of them.
//
// Every body is a core and the ball of a radius around each of its points. A core is a half-space,
// or a Minkowski sum of terms; a term is the convex hull of atoms; an atom is a point, or a disc or
// ball under an affine map. All numbers are rational, so a body is exactly what its numbers say.
// Lengths are in the unit of the coordinates. Where bodies are put, and how they begin to move, is
// said here too.                                                                 [proofs/shapes.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>
#include <variant>
#include <vector>

#include "fathom/point.hpp"

namespace fathom {

/// The points center + sum of y_i axes[i], for y with |y| <= 1: a point without axes, a disc with
/// two, a ball with three. The axes need not be orthogonal, nor independent: an atom may be flat.
struct Atom {
  Point center;             ///< of the point, disc or ball
  std::vector<Point> axes;  ///< none, two or three
  friend bool operator==(const Atom&, const Atom&) = default;
};

/// The convex hull of its atoms, of which there is at least one.
struct Term {
  std::vector<Atom> atoms;  ///< at least one
  friend bool operator==(const Term&, const Term&) = default;
};

/// The points x with <normal,x> <= offset. The normal is not zero.
struct HalfSpace {
  Point normal;      ///< outward; not 0
  mpq_class offset;  ///< <normal,x> on the plane
  friend bool operator==(const HalfSpace&, const HalfSpace&) = default;
};

/// The set of points at most `radius` away from the core.
struct Shape {
  std::variant<std::vector<Term>, HalfSpace> core;  ///< the Minkowski sum of the terms, at least one; or a half-space
  mpq_class radius = 0;                             ///< >= 0
  friend bool operator==(const Shape&, const Shape&) = default;
};

// ---- bodies by name ----
//
// Each is centred at O and lies along the axis named, unless its points are given. All lengths must
// be > 0, except for a margin, which may be 0, and all numbers in lowest terms:
// std::invalid_argument is thrown otherwise, with a sentence that says what is wrong.

enum class Axis { x, y, z };  ///< of the frame

Shape sphere(const mpq_class& radius);  ///< the ball around O
/// The points at most `radius` away from the segment between -half_length and half_length on the
/// axis: the caps come on top.
Shape capsule(const mpq_class& radius, const mpq_class& half_length, Axis axis = Axis::z);
/// The convex hull of two balls: one around -half_length on the axis, of radius `low`, and one
/// around half_length, of radius `high`.
Shape tapered_capsule(const mpq_class& low, const mpq_class& high, const mpq_class& half_length, Axis axis = Axis::z);
/// The points with |x| <= half.x, |y| <= half.y, |z| <= half.z.
Shape box(const Point& half);
/// Its end faces are at -half_length and half_length on the axis.
Shape cylinder(const mpq_class& radius, const mpq_class& half_length, Axis axis = Axis::z);
/// Its base is at -half_length on the axis, its apex at half_length.
Shape cone(const mpq_class& radius, const mpq_class& half_length, Axis axis = Axis::z);
/// A cone that is cut off: the end face at -half_length has the radius `low`, that at half_length
/// the radius `high`.
Shape frustum(const mpq_class& low, const mpq_class& high, const mpq_class& half_length, Axis axis = Axis::z);
/// The radii are those along x, y and z.
Shape ellipsoid(const Point& radii);
/// The convex hull of one point or more.
Shape hull(std::span<const Point> vertices);
Shape triangle(const Point& p, const Point& q, const Point& r);  ///< its convex hull, flat
/// The points x with <normal,x> <= offset; the normal is not 0.
Shape halfspace(const Point& normal, const mpq_class& offset);

/// The points at most `margin` >= 0 away from the shape: its radius grows by that.
Shape with_margin(Shape shape, const mpq_class& margin);

/// The Minkowski sum. Throws std::invalid_argument if one of the cores is a half-space.
Shape minkowski_sum(const Shape& a, const Shape& b);

/// Returns whether the body has no interior: its core lies in a plane, and its radius is 0. Throws
/// std::invalid_argument as signed_depth does for a shape that is none.
bool is_flat(const Shape& shape);

// ---- poses ----

/// Rows of a 3 x 4 matrix (M | t): x goes to M x + t.
using Pose = std::array<std::array<mpq_class, 4>, 3>;

/// The same in binary64: each number stands for its exact value.
using PoseBinary64 = std::array<std::array<double, 4>, 3>;

/// A rotation v -> q v q^-1. It need not be a unit quaternion.
struct Quaternion {
  mpq_class w, x, y, z;  ///< w: the real part
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// The rotation and then the translation: rational, and exactly orthogonal for every quaternion but
/// 0, as those of doubles are. No root is taken, nothing is normalised. Throws
/// std::invalid_argument if the quaternion is 0 or a number is not in lowest terms.
Pose rigid_pose(const Quaternion& rotation, const Point& translation);

/// The shape with its core mapped by the pose, exactly. The radius is a length in the world, it
/// stays: a capsule is a capsule, whatever a matrix of doubles, which is hardly ever a rotation,
/// does to its segment. Discs and balls of a core are mapped as points are. Throws
/// std::invalid_argument if M is singular or a number is not in lowest terms.
Shape moved(const Shape& shape, const Pose& pose);

// ---- velocities ----

/// A velocity of a body: its point p moves with v + w x p. w is about the origin of the world, in
/// radians per unit of time.
struct Twist {
  Point v, w;  ///< in lowest terms
  friend bool operator==(const Twist&, const Twist&) = default;
};

/// The velocities of two bodies.
struct Motion {
  Twist of_a, of_b;  ///< 0 of a body at rest
  friend bool operator==(const Motion&, const Motion&) = default;
};

}  // namespace fathom
