// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fathom/numbers.hpp"

namespace fathom::harness {

mpq_class scaled(const mpq_class& value, long exponent) {
  mpq_class result;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

long exponent_of(const mpq_class& value) {
  const long guess =
      static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
  return abs(value) < scaled(1, guess) ? guess - 1 : guess;  // 2^(guess-1) < |value| < 2^(guess+1)
}

long lowest_bit(const mpq_class& value) {
  if (value.get_den() != 1) return 1 - static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
  return static_cast<long>(mpz_scan1(value.get_num_mpz_t(), 0));
}

std::optional<mpq_class> rounded(const mpq_class& value, Precision precision) {
  const double nearest =
      precision == Precision::binary32 ? static_cast<double>(round_binary32(value, Rounding::rn)) : round_binary64(value, Rounding::rn);
  if (!std::isfinite(nearest)) return std::nullopt;
  return exact_value(nearest);
}

bool representable(const mpq_class& value, Precision precision) { return rounded(value, precision) == value; }

mpq_class largest_coordinate(const Case& pair) {
  mpq_class largest = 0;
  for_each_coordinate(pair, [&](const mpq_class& value) { largest = std::max(largest, mpq_class(abs(value))); });
  return largest;
}

}  // namespace fathom::harness
