// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/wide_float.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace fathom::kernels {
namespace {

constexpr int double_bits = 53;

// 2^exponent, for -1022 <= exponent <= 1023.
double power_of_two(std::int64_t exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace

WideFloat::WideFloat(double x) {
  if (x == 0) return;
  int exponent = 0;
  const auto leading = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), double_bits));
  significand_ = static_cast<Signed>(leading) << (bits - double_bits);
  exponent_ = exponent - bits;
}

WideFloat WideFloat::scaled(const mpz_class& c, long exponent) {
  static_assert(GMP_NUMB_BITS == 64);
  const std::size_t size = mpz_size(c.get_mpz_t());
  const auto limb = [&](std::size_t from_top) -> std::uint64_t {
    return from_top < size ? mpz_getlimbn(c.get_mpz_t(), static_cast<mp_size_t>(size - 1 - from_top)) : 0;
  };
  if (size == 0) return {};
  const int zeros = __builtin_clzll(limb(0));
  Unsigned top = (Unsigned{limb(0)} << 64 | limb(1)) << zeros;
  if (zeros > 0) top |= limb(2) >> (64 - zeros);
  return normalised(c < 0, top, 64 * static_cast<std::int64_t>(size) - zeros - 128 - exponent);
}

double WideFloat::leading() const {
  return static_cast<double>(static_cast<std::int64_t>(magnitude(significand_) >> (bits - double_bits))) *
         power_of_two(-double_bits);
}

double WideFloat::truncated(std::int64_t exponent, long least) const {
  const std::int64_t above = exponent_ + bits - exponent;  // |x| < 2^above
  if (significand_ == 0 || above < least) return 0;
  const double size = above > 900 ? std::numeric_limits<double>::infinity() : leading() * power_of_two(above);
  return significand_ < 0 ? -size : size;
}

// Newton's steps from a reciprocal, or the reciprocal of a root, in binary64: each doubles the
// number of digits.
WideFloat operator/(const WideFloat& a, const WideFloat& b) {
  WideFloat x(1 / b.leading());
  x.exponent_ -= b.exponent_ + WideFloat::bits;
  if (b.significand_ < 0) x = -x;
  for (int step = 0; step < 2; ++step) x = x + x * (1 - b * x);
  return a * x;
}

WideFloat sqrt(const WideFloat& a) {
  if (a.significand_ == 0) return a;
  // a = m * 4^half with m in [1/4, 1) or [1/2, 2).
  const std::int64_t half = (a.exponent_ + WideFloat::bits) >> 1;
  WideFloat m = a;
  m.exponent_ -= 2 * half;
  WideFloat x(1 / std::sqrt(m.truncated()));
  for (int step = 0; step < 2; ++step) x = x + x * (1 - m * (x * x)) * 0.5;
  WideFloat root = m * x;
  root.exponent_ += half;
  return root;
}

Leading leading(mpz_srcptr n) {
  Leading result{};
  result.mantissa = mpz_get_d_2exp(&result.exponent, n);
  return result;
}

WideEnclosure::WideEnclosure(const mpz_class& n) : value_(WideFloat::scaled(n, 0)) {
  if (n != 0 && static_cast<std::int64_t>(mpz_scan1(n.get_mpz_t(), 0)) < value_.exponent_) error_ = value_.exponent_;
}

WideEnclosure WideEnclosure::of_difference(const WideEnclosure& near_n, const mpz_class& n, const WideEnclosure& near_m,
                                           const mpz_class& m) {
  const WideEnclosure result = near_n - near_m;
  return result.has_digits() ? result : WideEnclosure(mpz_class(n - m));
}

std::optional<Leading> WideEnclosure::leading() const {
  if (value_.significand_ == 0) return exact() ? std::optional<Leading>{{0, 0}} : std::nullopt;
  constexpr int beyond = WideFloat::bits - double_bits;  // of the significand's bits
  if (!exact()) {
    const std::int64_t units = error_ - value_.exponent_;
    if (units >= beyond) return std::nullopt;
    const WideFloat::Unsigned error = WideFloat::Unsigned{1} << std::max<std::int64_t>(units, 0),
                              whole = WideFloat::Unsigned{1} << beyond,
                              rest = WideFloat::magnitude(value_.significand_) & (whole - 1);
    if (rest < error || rest + error >= whole) return std::nullopt;
  }
  const double size = value_.leading();
  return {{value_.sign() < 0 ? -size : size, static_cast<long>(value_.exponent_ + WideFloat::bits)}};
}

}  // namespace fathom::kernels
