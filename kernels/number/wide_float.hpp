// SPDX-License-Identifier: GPL-3.0-or-later
// A floating-point number of 122 bits, made of integers: the rounding mode does not matter, and
// nothing overflows or underflows. For filters that ties beyond the reach of binary64 ask for more
// digits, and numbers beyond its range for a wider one. With a bound of its error it encloses an
// integer of any size.                                            [proofs/number.md, "Wide floats"]
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

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
  [[nodiscard]] double truncated() const { return truncated(0, -900); }
  /// That of x * 2^-exponent; 0 below 2^least, which is at least -900.
  [[nodiscard]] double truncated(std::int64_t exponent, long least) const;
  /// |x| < 2^order(), and at least half of that; of 0 the lowest order, far below all others.
  [[nodiscard]] std::int64_t order() const { return significand_ == 0 ? lowest_order : exponent_ + bits; }
  static constexpr std::int64_t lowest_order = std::numeric_limits<std::int64_t>::min() / 8;
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
  friend class WideEnclosure;
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
  // The exponent of the lowest bit that is set. Not for 0.
  [[nodiscard]] std::int64_t lowest_bit() const {
    const Unsigned m = magnitude(significand_);
    const auto low = static_cast<std::uint64_t>(m);
    return exponent_ + (low != 0 ? __builtin_ctzll(low) : 64 + __builtin_ctzll(static_cast<std::uint64_t>(m >> 64)));
  }

  Signed significand_ = 0;  // 0, or of exactly 122 bits
  std::int64_t exponent_ = 0;
};

/// The first 53 bits of a number, as mpz_get_d_2exp gives them: mantissa * 2^exponent, truncated,
/// with 1/2 <= |mantissa| < 1; 0 for 0.
struct Leading {
  double mantissa;
  long exponent;
};
Leading leading(mpz_srcptr n);

/// A number of which a wide float and a bound of its error are known. Sums, differences and
/// products enclose those of all enclosed numbers.         [proofs/number.md, "Wide enclosures"]
class WideEnclosure {
 public:
  /// 0, exactly.
  WideEnclosure() = default;
  explicit WideEnclosure(const mpz_class& n);
  /// Of n - m, of which these are enclosures. Exact where the difference of these has few digits.
  static WideEnclosure of_difference(const WideEnclosure& near_n, const mpz_class& n, const WideEnclosure& near_m,
                                     const mpz_class& m);

  /// Nullopt if unsure.
  [[nodiscard]] std::optional<Sign> sign() const {
    if (value_.order() - 1 > error_) return sign_of(value_.sign());
    if (exact() && value_.sign() == 0) return Sign::zero;
    return std::nullopt;
  }
  /// The first 53 bits; nullopt if unsure.
  [[nodiscard]] std::optional<Leading> leading() const;
  /// Whether so many digits of x are known that no other way to compute it is worth a try.
  [[nodiscard]] bool has_digits() const { return order() - error() > digits_enough || is_zero(); }
  /// |x| < 2^order().
  [[nodiscard]] std::int64_t order() const { return std::max(value_.order(), error_) + 1; }
  /// The bound of the error as a power of two; far below all numbers if there is none.
  [[nodiscard]] std::int64_t error() const { return error_; }
  [[nodiscard]] const WideFloat& value() const { return value_; }

  WideEnclosure operator-() const { return {-value_, error_}; }
  friend WideEnclosure operator+(const WideEnclosure& a, const WideEnclosure& b) {
    const WideFloat sum = a.value_ + b.value_;
    if (a.exact() && b.exact() && sum_is_exact(a.value_, b.value_, sum)) return {sum, none};
    return {sum, std::max({a.error_, b.error_, sum.order() - rounding}) + 2};
  }
  friend WideEnclosure operator-(const WideEnclosure& a, const WideEnclosure& b) { return a + -b; }
  friend WideEnclosure operator*(const WideEnclosure& a, const WideEnclosure& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const WideFloat product = a.value_ * b.value_;
    if (a.exact() && b.exact() && product_is_exact(a.value_, b.value_, product)) return {product, none};
    return {product, std::max({a.value_.order() + b.error_, b.value_.order() + a.error_, a.error_ + b.error_,
                               product.order() - rounding}) +
                         2};
  }

 private:
  static constexpr std::int64_t none = WideFloat::lowest_order;
  static constexpr int digits_enough = 80;
  static constexpr int rounding = 118;  // a result of an operation errs by less than 2^(order - 118)

  WideEnclosure(const WideFloat& value, std::int64_t error) : value_(value), error_(std::max(error, none)) {}
  [[nodiscard]] bool exact() const { return error_ == none; }
  [[nodiscard]] bool is_zero() const { return exact() && value_.significand_ == 0; }
  static bool sum_is_exact(const WideFloat& a, const WideFloat& b, const WideFloat& sum) {
    if (a.significand_ == 0 || b.significand_ == 0) return true;
    const std::int64_t low = std::min(a.lowest_bit(), b.lowest_bit());
    return low >= std::max(a.exponent_, b.exponent_) - WideFloat::guard &&
           (sum.significand_ == 0 || low >= sum.exponent_);
  }
  static bool product_is_exact(const WideFloat& a, const WideFloat& b, const WideFloat& product) {
    return product.significand_ == 0 || a.lowest_bit() + b.lowest_bit() >= product.exponent_;
  }

  WideFloat value_;            // |x - value| <= 2^error
  std::int64_t error_ = none;  // none: x = value
};

/// A vector scaled like the images in binary64: into [-1, 1] if |components| <= 2^exponent.
inline Vec3<WideFloat> wide_image(const Vector& v, long exponent) {
  return {WideFloat::scaled(v.x, exponent), WideFloat::scaled(v.y, exponent), WideFloat::scaled(v.z, exponent)};
}

// The same words for both kinds of floats.
inline double truncated(double x) { return x; }
inline double truncated(const WideFloat& x) { return x.truncated(); }

}  // namespace fathom::kernels
