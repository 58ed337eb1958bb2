// SPDX-License-Identifier: GPL-3.0-or-later
// The images of integers in place in binary64: the same values as those of mpz_class, which are their naive twins.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "kernels/filters/rounded_plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/fixed_integer.hpp"

namespace fathom::kernels {

/// c * 2^-exponent, truncated to 53 bits; 0 below 2^-500. |c| < 2^(exponent + 500).
template <unsigned Bits>
double image(const FixedInteger<Bits>& c, long exponent) {
  const int n = c.limb_count();
  if (n == 0) return 0;
  const mp_limb_t* limbs = c.limbs();
  const int zeros = std::countl_zero(limbs[n - 1]);
  mp_limb_t top = limbs[n - 1] << zeros;
  if (n > 1 && zeros > 0) top |= limbs[n - 2] >> (64 - zeros);
  const auto mantissa = static_cast<double>(static_cast<std::int64_t>(top >> 11));  // 53 bits: exact
  const long power = 64L * n - zeros - 53 - exponent;
  if (power + 53 < -500) return 0;
  const double magnitude = mantissa * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + power) << 52);
  return c.size() < 0 ? -magnitude : magnitude;
}

/// The same for a word. `exponent` lies in [0, 400].
inline double image(std::int64_t c, long exponent) {
  const std::uint64_t magnitude = c < 0 ? -static_cast<std::uint64_t>(c) : static_cast<std::uint64_t>(c);
  const int beyond = 11 - std::countl_zero(magnitude);  // bits beyond 53
  const std::int64_t kept = beyond > 0 ? static_cast<std::int64_t>(magnitude >> beyond << beyond) : static_cast<std::int64_t>(magnitude);
  const double scaled = static_cast<double>(kept) * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  return c < 0 ? -scaled : scaled;
}

template <unsigned Bits>
Vec3<double> image(const Vec3<FixedInteger<Bits>>& v, long exponent) {
  return {image(v.x, exponent), image(v.y, exponent), image(v.z, exponent)};
}

/// The least e >= 0 with |c| <= 2^e, for a number; for every component.
template <unsigned Bits>
long binary_exponent(const FixedInteger<Bits>& c) {
  const long bits = c.bit_length();
  return bits > 0 && static_cast<long>(c.trailing_zeros()) == bits - 1 ? bits - 1 : bits;
}
template <unsigned Bits>
long binary_exponent(const Vec3<FixedInteger<Bits>>& v) {
  return std::max({binary_exponent(v.x), binary_exponent(v.y), binary_exponent(v.z)});
}

/// The largest number of bits of a component.
template <unsigned Bits>
long bit_length(const Vec3<FixedInteger<Bits>>& v) {
  return std::max({v.x.bit_length(), v.y.bit_length(), v.z.bit_length()});
}

/// The image of u, not zero, for points of which `exponent` is the exponent.
template <unsigned Bits>
DirectionImage direction_image_for(const Vec3<FixedInteger<Bits>>& u, long exponent) {
  const long bits = bit_length(u);
  const Vec3<double> v = image(u, bits);
  return {v.x, v.y, v.z, slack_of(bits + exponent)};
}

/// Returns an upper bound of sqrt(numerator / denominator) * 2^-exponent, a few roundings above it, as that of mpz_class does.
template <unsigned Bits>
double root_from_above(const FixedInteger<Bits>& numerator, const FixedInteger<Bits>& denominator, long exponent) {
  mpz_t n, d;
  numerator.view(n);
  denominator.view(d);
  return root_from_above(static_cast<mpz_srcptr>(n), static_cast<mpz_srcptr>(d), exponent);
}

}  // namespace fathom::kernels
