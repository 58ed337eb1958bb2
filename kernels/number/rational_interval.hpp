// SPDX-License-Identifier: GPL-3.0-or-later
// Real numbers that are known between two rationals.                                                            [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <algorithm>

#include "fathom/numbers.hpp"

namespace fathom::kernels {

/// low <= value <= high; equal if the value is known.
struct RationalInterval {
  mpq_class low, high;
};

inline RationalInterval operator+(const RationalInterval& x, const RationalInterval& y) { return {x.low + y.low, x.high + y.high}; }
inline RationalInterval operator-(const RationalInterval& x, const RationalInterval& y) { return {x.low - y.high, x.high - y.low}; }
inline RationalInterval operator-(const RationalInterval& x) { return {-x.high, -x.low}; }
/// min(x, y), and max(x, 0).
inline RationalInterval lesser(const RationalInterval& x, const RationalInterval& y) {
  return {std::min(x.low, y.low), std::min(x.high, y.high)};
}
inline RationalInterval greater(const RationalInterval& x, const RationalInterval& y) {
  return {std::max(x.low, y.low), std::max(x.high, y.high)};
}
inline RationalInterval positive_part(const RationalInterval& x) { return greater(x, {0, 0}); }

/// x / y for y > 0.
RationalInterval quotient(const RationalInterval& x, const RationalInterval& y);

/// Encloses the value, its root to `bits` bits or one more; a rational value is known.
RationalInterval enclosed(const Surd& value, unsigned bits);

}  // namespace fathom::kernels
