// SPDX-License-Identifier: GPL-3.0-or-later
// How bodies begin to move.
#pragma once

#include "fathom/point.hpp"

namespace fathom {

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
