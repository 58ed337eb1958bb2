// SPDX-License-Identifier: GPL-3.0-or-later
// The square root of a rational to any number of decimal digits, enclosed from both sides.                       [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <string>

namespace fathom {

/// Decimals low <= root <= high. Equal exactly when the root is a decimal of that many digits; then written without trailing
/// zeros. Else neighbours among the decimals of that many significant digits, so that low < root < high.
/// Plain ("0.01234") where that is short, else with an exponent ("1.234e-50"); parse_number reads both, within its limits.
struct Enclosure {
  std::string low, high;
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

inline constexpr std::size_t most_root_digits = 1'000'000;

/// Encloses the square root of `squared` to `digits` significant digits, 1 <= digits <= most_root_digits. MPFR finds the digits, exact
/// squaring of both ends proves them. Throws std::domain_error when `squared` is negative, std::invalid_argument for other digits.
Enclosure enclose_root(const mpq_class& squared, std::size_t digits);

}  // namespace fathom
