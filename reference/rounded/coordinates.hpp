// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a half-space, and the core of a shape that is a polytope: a sum of hulls of points.
// Output  the one optimal direction, and the support in it. No sum is expanded.  [proofs/shapes.md]
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fathom/signed_depth.hpp"

namespace fathom::rounded {

enum class Side { a, b };

/// The half-space is the body on `side`. Every atom of the other body must be a point.
PlaneSupport plane_support(const HalfSpace& half, Side side, std::span<const Term> other);

// Points, translations and directions by their coordinates, each of which is rational but for one
// root: so they can be rounded correctly.

using Coordinates = std::array<Surd, 3>;

Coordinates coordinates(const Point& p);
Coordinates coordinates(const AlongNormal& vector);
Coordinates coordinates(const RoundedPoint& point);
/// The unit vector in the direction of n, which is not 0.
Coordinates unit(const Vector& n);

/// Points of both bodies.
using CoordinatePair = std::array<Coordinates, 2>;
CoordinatePair coordinates(const Witness& witness);
CoordinatePair coordinates(const RoundedWitness& witness);

/// Each coordinate to the nearest binary64; infinite beyond that.
std::array<double, 3> nearest_binary64(const Coordinates& values);
std::array<double, 3> nearest_binary64(const Point& p);
std::array<double, 3> nearest_binary64(const AlongNormal& vector);
std::array<double, 3> nearest_binary64(const RoundedPoint& point);

/// That of unit(n), without a fraction in lowest terms.
std::array<double, 3> nearest_unit(const Vector& n);

/// The vector or the point, if it is rational.
std::optional<Point> rational_point(const AlongNormal& vector);
std::optional<Point> rational_point(const RoundedPoint& point);

}  // namespace fathom::rounded
