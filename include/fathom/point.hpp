// SPDX-License-Identifier: GPL-3.0-or-later
// Exact positions and directions.
#pragma once

#include <gmpxx.h>

#include <cstdint>

namespace fathom {

/// A position with exact rational coordinates, each in lowest terms: what takes points throws
/// std::invalid_argument at others.
struct Point {
  mpq_class x, y, z;  ///< the coordinates
  friend bool operator==(const Point&, const Point&) = default;
};

/// Three components of any ring.
template <class NT>
struct Vec3 {
  NT x, y, z;  ///< the components
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// An exact integer vector: a direction, a facet normal, or a position in multiples of a common
/// unit.
using Vector = Vec3<mpz_class>;

/// The share of an input point in a convex combination of a body's points.
struct Weight {
  std::uint32_t index;  ///< of the point
  mpq_class weight;     ///< > 0

  friend bool operator==(const Weight&, const Weight&) = default;
};

}  // namespace fathom
