// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a finite set of points.
// Output  whether each is seen to be an extreme point of the set, without a hull.
#pragma once

#include <array>
#include <span>

#include "kernels/vector.hpp"

namespace fathom::kernels {

/// True only if every point is extreme, where equal points count as one: for each a direction was
/// found in which it alone is farthest. False says nothing: some point may not be extreme, or no
/// such direction was found soon. About n log n double operations for points all over a round body;
/// no order of the points, no rounding mode and no flushing of small numbers makes it wrong.
bool all_seen_extreme(std::span<const Point> points);
bool all_seen_extreme(std::span<const std::array<double, 3>> points);

}  // namespace fathom::kernels
