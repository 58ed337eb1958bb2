// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a direction.
// Output  the exact directional depth: how far A must move that way until the interiors are disjoint.            [AGHRS, section 3]
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "reference/approximate/body_pair.hpp"
#include "reference/depth/depth.hpp"

namespace fathom {

struct DirectionalDepth {
  Status status = Status::disjoint;
  mpq_class factor;              ///< of the direction as given; 0 unless penetrating: the interiors are disjoint already
  Point translation;             ///< factor * direction
  mpq_class squared;             ///< |translation|^2
  std::optional<Vector> normal;  ///< penetrating: primitive outward normal of the facet of P that the ray hits; of several facets, one.
                                 ///< Else a primitive u with h(u) <= 0
  std::optional<Contact> contact;
  std::optional<Witness> witness;  ///< points a and b of the contact with b - a = translation
  bool flat_a = false, flat_b = false;
  std::uint64_t steps = 0;  ///< of the ray
};

/// For all statuses and ranks. Throws std::invalid_argument when a body is empty or the direction is zero, and Interrupted.
DirectionalDepth directional_depth(std::span<const Point> a, std::span<const Point> b, const Point& direction,
                                   const ReportProgress& progress = {});

}  // namespace fathom
