// SPDX-License-Identifier: GPL-3.0-or-later
// Depths that are hard to round: within 2^-k ulp of a point where the correctly rounded value changes, or exactly on it.
//                                                                                                     [docs/golden.md]
#pragma once

#include "verify/families/placement.hpp"

namespace fathom::families {

/// A binary floating-point format: normal numbers 1.f * 2^e with `digits` bits and least_exponent <= e <= greatest_exponent.
struct FloatFormat {
  long digits, least_exponent, greatest_exponent;
};
inline constexpr FloatFormat binary32{24, -126, 127};
inline constexpr FloatFormat binary64{53, -1022, 1023};

/// Lenses whose depth lies near a number of the format (where rd and ru change) or a point halfway between two neighbours (where rn does):
/// 2^-k ulp above or below it, or on it. Half of the cases lie along a coordinate axis, and 1 <= k <= 50: their coordinates are binary64
/// numbers, unless the depth is at the end of the format's range, as in one case of eight: subnormal, or about to overflow. In the other
/// half the direction is any and 1 <= k <= 200; the depth is irrational as a rule, and 2^-k ulp stands for 3/4 of that, nearly.
Bodies rounding_boundary(const FloatFormat& format, Random& random, unsigned n);

}  // namespace fathom::families
