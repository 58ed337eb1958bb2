// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal digits of integers. GMP's functions take several times as long for numbers of a few
// words, and for a word times a power of 2, as coordinates in binary64 and their denominators are.
#pragma once

#include <gmpxx.h>

#include <charconv>
#include <cstddef>
#include <cstdint>

#include "kernels/number/rational.hpp"

namespace fathom::kernels {

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

}  // namespace fathom::kernels
