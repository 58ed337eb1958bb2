// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a direction.
// Output  the exact directional depth: how far A must move that way until the interiors are disjoint.            [AGHRS, section 3]
#pragma once

#include <cstdint>
#include <span>

#include "fathom/depth.hpp"

namespace fathom {

/// Where the ray leaves P.
struct RayExit {
  mpq_class factor;   ///< > 0, of the direction as given
  Point translation;  ///< factor * direction
  Vector normal;      ///< primitive outward normal of the facet of P that the ray hits; of several facets, one
  Contact contact;    ///< in direction `normal`
  Witness witness;    ///< points of the contact with b - a = translation
  std::uint64_t steps = 0;
};

struct DirectionalDepth : SeparationOr<RayExit> {
  /// 0 unless penetrating: the interiors are disjoint already.
  [[nodiscard]] mpq_class factor() const;
  [[nodiscard]] Point translation() const;
  /// |translation|^2.
  [[nodiscard]] mpq_class squared() const;
  /// Of the exit, or of the separation.
  [[nodiscard]] const Vector& normal() const;
};

/// For all statuses and ranks. Throws std::invalid_argument when a body is empty or the direction is zero, and Interrupted.
DirectionalDepth directional_depth(std::span<const Point> a, std::span<const Point> b, const Point& direction, Monitor* monitor = nullptr);

}  // namespace fathom
