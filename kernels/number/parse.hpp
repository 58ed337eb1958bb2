// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people and programs write them, read exactly. Independent of the locale and of the floating-point environment.
//                                                                                                         [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fathom {

/// What a decimal stands for: a number written with '.', 'e' or 'E'.
enum class Decimals {
  exact,    ///< itself
  binary64  ///< the nearest binary64, ties to even: what a program that reads doubles would see
};

/// A number in lowest terms, or one phrase for the user: "expected a number, found '1/0': the denominator is zero".
/// The phrase is printable ASCII and short, whatever the token was.
struct ParsedNumber {
  std::optional<mpq_class> value;
  std::string error;  ///< empty when there is a value
};

/// Limits, so that a few bytes of hostile input cannot ask for unbounded memory.
inline constexpr std::size_t longest_number = 1'000'000;   ///< characters of a token
inline constexpr long largest_decimal_exponent = 100'000;  ///< in magnitude, as written; for exact decimals
inline constexpr long largest_binary_exponent = 400'000;   ///< in magnitude, as written

/// Reads the whole token, with an optional sign first:
///   integer 12; ratio 22/7; decimal 1.5, .5, 1., 1e-3; C99 hex float 0x1.8p-3 (the exponent may be left out, as in strtod).
/// Integers, ratios and hex floats are exact whatever `decimals` says. In binary64 mode a decimal too small becomes the nearest
/// subnormal or 0, with any exponent; one that would round to infinity is an error. Minus zero is 0. Infinities, NaN, blanks and
/// anything left over are errors. Never throws on bad input. Time is quasi-linear in the token's length plus the exponent's size.
ParsedNumber parse_number(std::string_view token, Decimals decimals);

/// The value of a finite double, or of a float through its equal double. Throws std::invalid_argument on NaN and infinities.
mpq_class exact_value(double value);

/// "p/q" in lowest terms, integers without "/1"; parse_number reads it back. `value` must be in lowest terms.
std::string exact_text(const mpq_class& value);

}  // namespace fathom
