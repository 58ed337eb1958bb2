// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/rational.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

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

std::optional<Dyadic> dyadic(const mpq_class& value) {
  const mpz_srcptr n = value.get_num_mpz_t(), d = value.get_den_mpz_t();
  if (mpz_size(n) > 1 || mpz_sgn(d) <= 0) return std::nullopt;
  const mp_limb_t magnitude = mpz_getlimbn(n, 0);
  if (magnitude > std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  const auto mantissa = mpz_sgn(n) < 0 ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
  const std::size_t highest = mpz_size(d) - 1;
  const mp_limb_t top = mpz_getlimbn(d, static_cast<mp_size_t>(highest));
  if (!std::has_single_bit(top)) return std::nullopt;
  for (std::size_t i = 0; i < highest; ++i)
    if (mpz_getlimbn(d, static_cast<mp_size_t>(i)) != 0) return std::nullopt;
  const auto shift = static_cast<long>(64 * highest) + std::countr_zero(top);
  if (shift == 0) return normalised(mantissa, 0);
  return magnitude % 2 != 0 ? std::optional(Dyadic{mantissa, -shift}) : std::nullopt;
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
