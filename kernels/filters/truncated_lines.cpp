// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/truncated_lines.hpp"

#include "kernels/filters/support.hpp"

namespace fathom::kernels {
namespace {

constexpr long length = 256;

// c * 2^shift, truncated.
mpz_class shifted(const mpz_class& c, long shift) {
  mpz_class r;
  if (shift >= 0) mpz_mul_2exp(r.get_mpz_t(), c.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
  else mpz_tdiv_q_2exp(r.get_mpz_t(), c.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
  return r;
}

Vector shifted(const Vector& v, long shift) { return {shifted(v.x, shift), shifted(v.y, shift), shifted(v.z, shift)}; }

mpz_class power_of_two(long exponent) { return mpz_class(1) << static_cast<mp_bitcnt_t>(exponent); }

// The bounds on the errors of a component of w and of the height.
const mpz_class& error_of_normal() {
  static const mpz_class error = power_of_two(length + 2);
  return error;
}
const mpz_class& error_of_height() {
  static const mpz_class error = power_of_two(2 * length + 6);
  return error;
}

mpz_class square_from_above(const mpz_class& c) {
  const mpz_class most = abs(c) + error_of_normal();
  return most * most;
}

}  // namespace

void TruncatedLines::push_back(const Vector& point, const Vector& direction) {
  points_.push_back(shifted(point, length - exponent_));
  directions_.push_back(shifted(direction, length - binary_exponent({&direction, 1})));
}

mpz_class TruncatedLines::bound(const mpz_class& numerator, const mpz_class& denominator) const {
  const long shift = 2 * (length - exponent_);
  mpz_class quotient;
  const mpz_class n = shift > 0 ? shifted(numerator, shift) : numerator, d = shift > 0 ? denominator : shifted(denominator, -shift);
  mpz_cdiv_q(quotient.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  return quotient;
}

bool surely_farther(const TruncatedLines& a, std::size_t i, const TruncatedLines& b, std::size_t j, const mpz_class& bound) {
  const Vector w = cross(a.direction(i), b.direction(j));
  const mpz_class height = abs(dot(Vector(b.point(j) - a.point(i)), w)) - error_of_height();
  if (height <= 0) return false;
  return height * height > bound * (square_from_above(w.x) + square_from_above(w.y) + square_from_above(w.z));
}

}  // namespace fathom::kernels
