// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text. Read in binary64: by a fast path for short integers and decimals, which are
// nearly all tokens of a large mesh, and decimals of any length, rounded. Written: GMP's functions
// take several times as long for numbers of a few words, and for a word times a power of 2, as
// coordinates in binary64 and their denominators are.
#pragma once

#include <gmpxx.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::kernels {

constexpr bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns the value of parse_number(token, decimals), its naive twin, in binary64; or nullopt, and
/// parse_number has to read the token. Reads decimals only in binary64 mode and while rounding is
/// to nearest.
std::optional<double> quick_number(std::string_view token, Decimals decimals);

/// The nearest binary64 of a decimal of any length, as JSON writes numbers: infinite if it is too
/// large for one, 0 if it is too small.
double nearest_binary64(std::string_view decimal);

/// Reads the number of JSON that begins here; returns where it ends. null if none does, or if it is
/// beyond binary64, or not 0 and too small for it. Call it while rounding is to nearest.
const char* leading_number(const char* begin, const char* end, double& nearest);

/// How many characters put_digits may write.
inline std::size_t most_digits(mpz_srcptr n) { return mpz_size(n) <= 1 ? 21 : mpz_sizeinbase(n, 10) + 2; }
inline std::size_t most_digits(const Dyadic& n) {
  return 21 + (n.exponent < 0 ? 0 : static_cast<std::size_t>(n.exponent) / 3);
}

/// Writes the digits, behind a sign if the number is negative; returns where they end.
inline char* put_digits(char* at, std::uint64_t n) { return std::to_chars(at, at + 20, n).ptr; }
char* put_digits(char* at, mpz_srcptr n);
/// Of an integer: no exponent below 0.
char* put_digits(char* at, const Dyadic& n);

/// Appends the decimal digits to `text`, and exact_text(value).
void append_digits(mpz_srcptr n, std::string& text);
void append_exact(const mpq_class& value, std::string& text);

/// Appends hex_text(value) to `text`.
void append_hex(double value, std::string& text);

}  // namespace fathom::kernels
