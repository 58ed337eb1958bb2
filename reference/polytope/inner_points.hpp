// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a body.
// Output  how many of its points are not extreme.
// Time    that of a hull, or n log n double operations if all are seen to be extreme without one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "fathom/point.hpp"

namespace fathom::polytope {

/// Counts the points that are not vertices of the hull, nor equal to one. Exact. Returns nullopt if a hull is needed, but the
/// points' denominators share little (place_if_slim). The body must not be empty.
std::optional<std::size_t> count_inner_points(std::span<const Point> body);

}  // namespace fathom::polytope
