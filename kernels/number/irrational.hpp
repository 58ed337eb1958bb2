// SPDX-License-Identifier: GPL-3.0-or-later
// Real numbers that are no rationals: between two rationals, as sums with a square root, and as
// values of cosine and sine.
//                                                                                [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <optional>
#include <string>

#include "fathom/numbers.hpp"

namespace fathom::kernels {

/// low <= value <= high; equal if the value is known.
struct RationalInterval {
  mpq_class low, high;
};

inline RationalInterval operator+(const RationalInterval& x, const RationalInterval& y) {
  return {x.low + y.low, x.high + y.high};
}
inline RationalInterval operator-(const RationalInterval& x, const RationalInterval& y) {
  return {x.low - y.high, x.high - y.low};
}
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

// More about sums of a rational and square roots than fathom/numbers.hpp offers. With it the judge
// tells how far a claimed number is from a depth, which is a root.

/// Returns the signed root of x, if it is rational.
std::optional<mpq_class> rational_root(const mpq_class& x);

/// Returns the value, if it is rational.
std::optional<mpq_class> rational_value(const Surd& value);

/// "sqrt(2) + 1/2", "-sqrt(2) + 1/2", "3/2".
std::string exact_surd_text(const Surd& value);

/// Returns the exact sign of rational + signed root of x + signed root of y.
int sign_of_sum(const mpq_class& rational, const mpq_class& x, const mpq_class& y);

/// Correctly rounded to nearest, ties to even; infinite beyond binary64. A value that rounds to
/// zero gives +0.
double nearest_binary64(const Surd& value);

/// sqrt(value), rounded in the same way. Throws std::domain_error when the value is negative.
double nearest_root_binary64(const Surd& value);

enum class AngleUnit { degrees, radians };

struct CosineAndSine {
  mpq_class cosine, sine;
};

/// Returns the cosine and the sine of the angle, each rounded to the nearest number of 53 bits,
/// whatever its exponent. They are exact where they can be: at multiples of 30 degrees.
CosineAndSine cosine_and_sine(const mpq_class& angle, AngleUnit unit);

}  // namespace fathom::kernels
