// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers in and out: reading numbers as people and programs write them, rounding exact
// values and square roots, hence depths; and comparing and rounding sums of a rational and a root,
// hence signed depths of rounded bodies. No function depends on the locale or on the floating-point
// environment, whatever rounding mode is set.                                    [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fathom {

// ---- reading ----

/// What a decimal stands for: a number written with '.', 'e' or 'E'.
enum class Decimals {
  exact,    ///< its own value: 0.1 is 1/10
  binary64  ///< the nearest binary64, ties to even: what a program that reads doubles sees
};

/// A number in lowest terms, or a phrase for the user: "expected a number, found '1/0': the
/// denominator is zero". The phrase is short printable ASCII for any token.
struct ParsedNumber {
  std::optional<mpq_class> value;  ///< nullopt if the token is no number
  std::string error;               ///< empty if there is a value
};

/// Limits, so that a few bytes of hostile input cannot ask for unbounded memory.
inline constexpr std::size_t longest_number = 1'000'000;   ///< characters of a token
inline constexpr long largest_decimal_exponent = 100'000;  ///< in magnitude, as written; for exact decimals
inline constexpr long largest_binary_exponent = 400'000;   ///< in magnitude, as written

/// Reads the whole token, with an optional sign first:
///   integer 12; ratio 22/7; decimal 1.5, .5, 1., 1e-3; C99 hex float 0x1.8p-3 (the exponent may be
///   left out, as in strtod). Integers, ratios and hex floats are exact whatever `decimals` says.
///   In binary64 mode a decimal too small becomes the nearest subnormal or 0, with any exponent;
///   one that would round to infinity is an error. Minus zero is 0. Infinities, NaN, blanks and
///   anything left over are errors. Never throws on bad input. Time is quasi-linear in the token's
///   length plus the exponent's size.
ParsedNumber parse_number(std::string_view token, Decimals decimals);

/// Returns the exact value of a finite double; a float converts to its equal double. Throws
/// std::invalid_argument on NaN and infinities.
mpq_class exact_value(double value);

/// Returns "p/q" in lowest terms, integers without "/1"; parse_number reads it back. `value` must
/// be in lowest terms.
std::string exact_text(const mpq_class& value);

// ---- rounding ----

/// rn: to nearest, ties to even. rd: towards minus infinity. ru: towards plus infinity.
enum class Rounding { rn, rd, ru };

/// Returns `value`, correctly rounded as IEEE 754 defines it: subnormals where they are due; beyond
/// the largest finite number, infinity in the direction of rounding or the largest finite number
/// against it; rn overflows from the largest finite number plus half an ulp on. A negative value
/// that rounds to zero gives -0. The denominator must be positive; lowest terms are not needed.
double round_binary64(const mpq_class& value, Rounding mode = Rounding::rn);
float round_binary32(const mpq_class& value, Rounding mode = Rounding::rn);

/// Returns the square root of `squared`, correctly rounded in the same sense:
/// root_binary64(depth.squared()) is the depth. No root is ever taken in floating point. Throws
/// std::domain_error if `squared` is negative.
double root_binary64(const mpq_class& squared, Rounding mode = Rounding::rn);
float root_binary32(const mpq_class& squared, Rounding mode = Rounding::rn);

/// Returns the number as C99 %a prints it, but in any locale: "0x1.999999999999ap-4", subnormals
/// "0x0.0000000000001p-1022", zero "0x0p+0", "inf", "nan". A float is printed through its equal
/// double, as %a does: its subnormals look normal.
std::string hex_text(double value);

// ---- sums of a rational and a root ----

/// The number rational + signed root of `root`, where the signed root of x is sqrt(x), or -sqrt(-x)
/// for x < 0. Both in lowest terms. One number may have several such forms, {3, 0} and {1, 4}:
/// `compare` tells whether two are equal.
struct Surd {
  mpq_class rational, root;  ///< root: the number under the root
};

/// Returns -1, 0 or 1: the exact sign, found by squaring.
int sign(const Surd& value);

/// Returns the sign of left - right, exactly.
int compare(const Surd& left, const mpq_class& right);
int compare(const Surd& left, const Surd& right);

/// Returns `value`, correctly rounded as the functions above do it, -0 for a negative value
/// included.
double round_binary64(const Surd& value, Rounding mode = Rounding::rn);
float round_binary32(const Surd& value, Rounding mode = Rounding::rn);

// ---- any number of digits ----

/// Decimals low <= value <= high. Equal if and only if the value is a decimal of that many digits;
/// then written without trailing zeros. Otherwise neighbours among the decimals of that many
/// significant digits, so that low < value < high. Plain ("0.01234") where that is short, else with
/// an exponent ("1.234e-50"); parse_number reads both, within its limits.
struct Enclosure {
  std::string low, high;  ///< the two decimals
  friend bool operator==(const Enclosure&, const Enclosure&) = default;
};

inline constexpr std::size_t most_root_digits = 1'000'000;  ///< that are computed

/// Encloses the value by decimals of `digits` significant digits, 1 <= digits <= most_root_digits.
/// MPFR finds the digits, exact squaring proves both ends. Throws std::invalid_argument for other
/// digits.
Enclosure enclose(const Surd& value, std::size_t digits);

/// Encloses the square root of `squared` in the same way. Throws std::domain_error if it is
/// negative too.
Enclosure enclose_root(const mpq_class& squared, std::size_t digits);

}  // namespace fathom
