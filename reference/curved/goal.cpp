// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/goal.hpp"

#include <algorithm>
#include <utility>

#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::curved {
namespace {

// floor(sqrt(x) * 2^exponent) / 2^exponent, or the ceiling. x >= 0.
mpq_class root(const mpq_class& x, long exponent, bool up) {
  const mpq_class scaled = shifted(x, 2 * exponent);
  const mpz_class whole = up ? rounded_up(scaled) : mpz_class(scaled.get_num() / scaled.get_den());
  mpz_class result, rest;
  mpz_sqrtrem(result.get_mpz_t(), rest.get_mpz_t(), whole.get_mpz_t());
  if (up && rest != 0) ++result;
  return shifted(mpq_class(result), -exponent);
}

}  // namespace

mpq_class shifted(const mpq_class& value, long exponent) {
  mpq_class result = value;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

mpz_class rounded_up(const mpq_class& value) {
  mpz_class result;
  mpz_cdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return result;
}

Goal::Goal(unsigned bits, unsigned status_bits, mpq_class extent, mpq_class rho)
    : status_bits_(status_bits),
      extent_(std::move(extent)),
      rho_(std::move(rho)),
      share_(shifted(15, -static_cast<long>(bits) - 4)),
      status_share_(shifted(15, -static_cast<long>(status_bits) - 4)) {}

long Goal::finest(const mpq_class& x) const {
  if (extent_ == 0 && x == 0) return 0;
  const long order = extent_ == 0 ? kernels::binary_order(x) / 2 - 1 : kernels::binary_order(extent_);
  return static_cast<long>(status_bits_) + 6 - order;
}

mpq_class Goal::from_below(const mpq_class& x) const {
  return rho_ + (x < 0 ? mpq_class(-root(-x, finest(x), true)) : root(x, finest(x), false));
}

mpq_class Goal::from_above(const mpq_class& x) const {
  return rho_ + (x < 0 ? mpq_class(-root(-x, finest(x), false)) : root(x, finest(x), true));
}

mpq_class Goal::exact_or_below(const mpq_class& x) const {
  const auto exact = kernels::rational_root(x);
  return exact ? mpq_class(rho_ + *exact) : from_below(x);
}

mpq_class Goal::exact_or_above(const mpq_class& x) const {
  const auto exact = kernels::rational_root(x);
  return exact ? mpq_class(rho_ + *exact) : from_above(x);
}

bool Goal::met(const mpq_class& low, const mpq_class& high) const {
  const mpq_class width = high - low;
  if (!decided(low, high)) return width <= status_share_ * extent_;
  return width <= share_ * std::max({extent_, std::min(mpq_class(abs(low)), mpq_class(abs(high)))});
}

}  // namespace fathom::curved
