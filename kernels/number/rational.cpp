// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/rational.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "kernels/vector.hpp"

namespace fathom::kernels {

bool in_lowest_terms(const mpq_class& value) {
  const mpz_class &n = value.get_num(), &d = value.get_den();
  if (sgn(d) <= 0) return false;
  if (d == 1) return true;
  if (mpz_scan1(d.get_mpz_t(), 0) == mpz_sizeinbase(d.get_mpz_t(), 2) - 1)
    return mpz_odd_p(n.get_mpz_t()) != 0;  // a power of 2
  return gcd(n, d) == 1;
}

void require_lowest_terms(const mpq_class& value) {
  if (in_lowest_terms(value)) return;
  if (value.get_den() == 0) throw std::invalid_argument("the denominator of a number is 0");
  throw std::invalid_argument(
      "a number is not in lowest terms over a positive denominator: mpq_class::canonicalize makes it so");
}

namespace {

// What is left of |n|, not zero, without its trailing zeros, and their number; nullopt if that has
// more than 63 bits.
std::optional<std::pair<std::uint64_t, long>> odd_part(mpz_srcptr n) {
  const mp_limb_t* limbs = mpz_limbs_read(n);
  const std::size_t size = mpz_size(n);
  std::size_t i = 0;
  while (limbs[i] == 0) ++i;
  const int shift = std::countr_zero(limbs[i]);
  std::uint64_t odd = limbs[i] >> shift;
  if (i + 1 < size) {
    const mp_limb_t above = limbs[i + 1];
    if (i + 2 < size || shift == 0 || above >> shift != 0) return std::nullopt;
    odd |= above << (64 - shift);
  }
  if (odd >> 63 != 0) return std::nullopt;
  return std::pair(odd, static_cast<long>(64 * i) + shift);
}

}  // namespace

std::optional<ShortRational> short_rational(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_sgn(d) <= 0) return std::nullopt;
  if (mpz_sgn(n) == 0) return mpz_cmp_ui(d, 1) == 0 ? std::optional(ShortRational{}) : std::nullopt;
  const auto above = odd_part(n), below = odd_part(d);
  if (!above || !below || (above->second > 0 && below->second > 0)) return std::nullopt;
  const auto mantissa = static_cast<std::int64_t>(above->first);
  return ShortRational{{mpz_sgn(n) < 0 ? -mantissa : mantissa, above->second - below->second}, below->first};
}

double nearest_binary32(double value) { return static_cast<double>(static_cast<float>(value)); }

long binary_order(const mpq_class& q) { return bit_length(q.get_num()) - bit_length(q.get_den()); }

// Numbers of the format are m 2^e with |m| < 2^53, e >= -1074 and |m 2^e| < 2^1024.
std::optional<double> in_binary64(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_sgn(n) == 0) return 0;
  if (mpz_popcount(d) != 1) return std::nullopt;
  const auto length = static_cast<long>(mpz_sizeinbase(n, 2)), zeros = static_cast<long>(mpz_scan1(n, 0));
  const auto shift = static_cast<long>(mpz_sizeinbase(d, 2)) - 1;
  if (length - zeros > 53 || zeros - shift < -1074 || length - shift > 1024) return std::nullopt;
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, n);
  return std::ldexp(mantissa, static_cast<int>(exponent - shift));
}

}  // namespace fathom::kernels
