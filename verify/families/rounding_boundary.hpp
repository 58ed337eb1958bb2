// SPDX-License-Identifier: GPL-3.0-or-later
// Depths that are hard to round: within 2^-k ulp of a point where the correctly rounded value changes, or exactly on it.
//                                                                                                     [docs/golden.md]
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// A binary floating-point format: normal numbers 1.f * 2^e with `digits` bits and least_exponent <= e <= greatest_exponent.
struct FloatFormat {
  long digits, least_exponent, greatest_exponent;
};
inline constexpr FloatFormat binary32{24, -126, 127};
inline constexpr FloatFormat binary64{53, -1022, 1023};

/// Lenses whose depth lies near a number of the format (where rd and ru change) or a point halfway between two neighbours (where rn does):
/// 2^-k ulp above or below it, or on it. Half of the cases lie along a coordinate axis, and 1 <= k <= 50: their coordinates are binary64
/// numbers, except in one case of eight, where the depth is at the end of the format's range (subnormal, or about to overflow). In the
/// other half the direction is random and 1 <= k <= 200; there the depth is usually irrational, and its distance about 3/4 of 2^-k ulp.
Bodies rounding_boundary(const FloatFormat& format, Random& random, unsigned n);

}  // namespace fathom::families
