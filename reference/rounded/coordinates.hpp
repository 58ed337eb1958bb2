// SPDX-License-Identifier: GPL-3.0-or-later
// Points, translations and directions by their coordinates, each of which is rational but for one
// root: so they can be rounded correctly.
#pragma once

#include <array>
#include <optional>

#include "fathom/signed_depth.hpp"

namespace fathom::rounded {

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

/// The vector or the point, if it is rational.
std::optional<Point> rational_point(const AlongNormal& vector);
std::optional<Point> rational_point(const RoundedPoint& point);

}  // namespace fathom::rounded
