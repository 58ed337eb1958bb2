// SPDX-License-Identifier: GPL-3.0-or-later
// A floating-point number of 122 bits, made of integers: the rounding mode does not matter, and
// nothing overflows or underflows. For filters that ties beyond the reach of binary64 ask for more
// digits.                                                         [proofs/number.md, "Wide floats"]
#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "kernels/vector.hpp"

namespace fathom::kernels {

/// significand * 2^exponent. Every operation returns its exact result times 1 + e, |e| <= unit;
/// sums are 0 only if they are exactly 0.
class WideFloat {
 public:
  static constexpr double unit = 0x1p-118;

  WideFloat() = default;
  /// Exact; x must be finite.
  WideFloat(double x);  // NOLINT(google-explicit-constructor): as integers become doubles
  /// c * 2^-exponent, truncated to 122 bits.
  static WideFloat scaled(const mpz_class& c, long exponent);

  /// Truncated to 53 bits; 0 below 2^-900, infinite from 2^900 on.
  [[nodiscard]] double truncated() const;
  /// -1, 0 or 1.
  [[nodiscard]] int sign() const { return significand_ > 0 ? 1 : significand_ < 0 ? -1 : 0; }

  WideFloat operator-() const { return {-significand_, exponent_}; }
  friend WideFloat operator+(const WideFloat& a, const WideFloat& b) {
    if (a.significand_ == 0) return b;
    if (b.significand_ == 0) return a;
    const bool larger = a.exponent_ >= b.exponent_;
    const WideFloat &x = larger ? a : b, &y = larger ? b : a;
    const std::int64_t apart = x.exponent_ - y.exponent_;
    if (apart >= bits + guard) return x;
    const Signed sum = (x.significand_ << guard) + ((y.significand_ << guard) >> apart);
    return normalised(sum < 0, magnitude(sum), x.exponent_ - guard);
  }
  friend WideFloat operator-(const WideFloat& a, const WideFloat& b) { return a + -b; }
  friend WideFloat operator*(const WideFloat& a, const WideFloat& b) {
    constexpr int shift = 128 - bits;
    const Unsigned x = magnitude(a.significand_) << shift, y = magnitude(b.significand_) << shift;
    const auto x1 = static_cast<std::uint64_t>(x >> 64), x0 = static_cast<std::uint64_t>(x);
    const auto y1 = static_cast<std::uint64_t>(y >> 64), y0 = static_cast<std::uint64_t>(y);
    // The upper half of the product, too small by less than 3.
    const Unsigned upper = Unsigned{x1} * y1 + ((Unsigned{x1} * y0) >> 64) + ((Unsigned{x0} * y1) >> 64);
    return normalised((a.significand_ < 0) != (b.significand_ < 0), upper, a.exponent_ + b.exponent_ + 128 - 2 * shift);
  }
  /// b may not be 0.
  friend WideFloat operator/(const WideFloat& a, const WideFloat& b);
  /// a >= 0.
  friend WideFloat sqrt(const WideFloat& a);
  friend WideFloat abs(const WideFloat& a) { return a.significand_ < 0 ? -a : a; }

  friend bool operator==(const WideFloat& a, const WideFloat& b) { return (a - b).sign() == 0; }
  friend bool operator<(const WideFloat& a, const WideFloat& b) { return (a - b).sign() < 0; }
  friend bool operator>(const WideFloat& a, const WideFloat& b) { return b < a; }
  friend bool operator<=(const WideFloat& a, const WideFloat& b) { return !(b < a); }
  friend bool operator>=(const WideFloat& a, const WideFloat& b) { return !(a < b); }

 private:
  __extension__ typedef __int128 Signed;
  __extension__ typedef unsigned __int128 Unsigned;
  static constexpr int bits = 122;
  static constexpr int guard = 4;  // more bits while a sum is made

  WideFloat(Signed significand, std::int64_t exponent) : significand_(significand), exponent_(exponent) {}
  // +-magnitude * 2^exponent, with the last bits cut off where there are more than 122.
  static WideFloat normalised(bool negative, Unsigned magnitude, std::int64_t exponent) {
    if (magnitude == 0) return {};
    const auto high = static_cast<std::uint64_t>(magnitude >> 64);
    const int zeros = high != 0 ? __builtin_clzll(high) : 64 + __builtin_clzll(static_cast<std::uint64_t>(magnitude));
    const int cut = 128 - bits - zeros;
    const Signed s = static_cast<Signed>(cut > 0 ? magnitude >> cut : magnitude << -cut);
    return {negative ? -s : s, exponent + cut};
  }
  static Unsigned magnitude(Signed s) { return static_cast<Unsigned>(s < 0 ? -s : s); }
  // The first 53 bits, as a number in [1/2, 1).
  [[nodiscard]] double leading() const;

  Signed significand_ = 0;  // 0, or of exactly 122 bits
  std::int64_t exponent_ = 0;
};

/// A vector scaled like the images in binary64: into [-1, 1] if |components| <= 2^exponent.
inline Vec3<WideFloat> wide_image(const Vector& v, long exponent) {
  return {WideFloat::scaled(v.x, exponent), WideFloat::scaled(v.y, exponent), WideFloat::scaled(v.z, exponent)};
}

// The same words for both kinds of floats.
inline double truncated(double x) { return x; }
inline double truncated(const WideFloat& x) { return x.truncated(); }

}  // namespace fathom::kernels
