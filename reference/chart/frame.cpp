// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "reference/chart/chart.hpp"

namespace fathom {

// v = (a, 1, b), z = (c, -ac - b, 1) with a, b, c multiples of 1/1024 below 1/2 in size, times the common denominators. Consecutive
// attempts take consecutive terms of one linear congruential sequence, so every run tries the same frames in the same order.
Frame chart_frame(unsigned attempt, bool lower) {
  constexpr long unit = 1024;
  std::uint64_t state = 0x9E3779B97F4A7C15ULL * (attempt + 1);
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<long>(state >> 54) - unit / 2;
  };
  const std::array<long, 3> t{next(), next(), next()};
  const long a = t[0] | 1, b = t[1] | 1, c = t[2] | 1;
  const Vector v{a, unit, b};
  const Vector z{c * unit, -a * c - b * unit, unit * unit};
  return {Direction(v), Direction(lower ? -z : z)};
}

}  // namespace fathom
