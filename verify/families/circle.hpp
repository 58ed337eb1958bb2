// SPDX-License-Identifier: GPL-3.0-or-later
// Points near a circle, on an integer grid, without the trigonometry of the C library (which differs between machines).
#pragma once

#include <cstdint>
#include <vector>

namespace fathom::families {

/// A grid point near radius * (cos, sin).
struct CirclePoint {
  std::int64_t cosine, sine;
};

/// Returns a grid point within about one unit of 2^bits (cos t, sin t) for t = 2 pi k / n. Exactly symmetric under quarter turns and
/// reflections wherever n allows it. 0 < n <= 2^30, 0 <= k < n, bits <= 52.
CirclePoint circle_point(std::uint64_t k, std::uint64_t n, unsigned bits);

/// A grid fine enough for a regular n-gon to be strictly convex after rounding; at most 52 for n <= 2^20.
unsigned circle_bits(std::uint64_t n);

/// The regular n-gon, counter-clockwise, turned by `phase` / 4 of a step.
std::vector<CirclePoint> regular_polygon(std::uint64_t n, unsigned phase = 0);

}  // namespace fathom::families
