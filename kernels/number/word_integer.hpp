// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of two or four words in two's complement, for numbers that are known to fit: no length,
// no loop, no allocation. Whoever computes with them proves that no result is longer; with
// assertions, each operation checks that.                    [proofs/number.md, "Word integers"]
#pragma once

#include <gmpxx.h>

#include <bit>
#include <cassert>
#include <concepts>
#include <cstdint>

#include "kernels/number/fixed_integer.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

constexpr long bit_length(Uint128 n) {
  const auto high = static_cast<std::uint64_t>(n >> 64);
  return high != 0 ? 64 + std::bit_width(high) : std::bit_width(static_cast<std::uint64_t>(n));
}

/// An integer below 2^127 in size.
class Integer127 {
 public:
  static constexpr long most_bits = 127;

  Integer127() = default;
  Integer127(long value) : value_(value) {}  // NOLINT(google-explicit-constructor): as mpz_class
  /// Of at most 127 bits.
  explicit Integer127(const mpz_class& n) {
    assert(kernels::bit_length(n) <= most_bits);
    const auto limb = [&](int i) { return static_cast<Uint128>(mpz_getlimbn(n.get_mpz_t(), i)); };
    value_ = static_cast<Int128>(limb(1) << 64 | limb(0));
    if (sgn(n) < 0) value_ = -value_;
  }

  [[nodiscard]] long bit_length() const { return kernels::bit_length(magnitude()); }
  /// The same number, if it has at most 63 bits.
  [[nodiscard]] std::int64_t to_word() const { return static_cast<std::int64_t>(value_); }
  template <unsigned Bits>
  explicit operator FixedInteger<Bits>() const {
    const Uint128 m = magnitude();
    const mp_limb_t limbs[2] = {static_cast<mp_limb_t>(m), static_cast<mp_limb_t>(m >> 64)};
    return FixedInteger<Bits>::of_limbs(limbs, 2, value_ < 0);
  }
  /// |n| / 2^shift, rounded down, which has at most 64 bits.
  [[nodiscard]] std::uint64_t leading(long shift) const { return static_cast<std::uint64_t>(magnitude() >> shift); }

  friend int sgn(Integer127 a) { return (a.value_ > 0) - (a.value_ < 0); }
  friend int cmp(Integer127 a, Integer127 b) { return (a.value_ > b.value_) - (a.value_ < b.value_); }
  friend bool operator==(Integer127 a, Integer127 b) = default;
  friend Integer127 operator-(Integer127 a) { return of(-a.value_); }
  friend Integer127 operator+(Integer127 a, Integer127 b) {
    const Integer127 sum = of(static_cast<Int128>(static_cast<Uint128>(a.value_) + static_cast<Uint128>(b.value_)));
    assert((a.value_ < 0) != (b.value_ < 0) || (sum.value_ < 0) == (a.value_ < 0));
    return sum;
  }
  friend Integer127 operator-(Integer127 a, Integer127 b) { return a + -b; }
  friend Integer127 operator*(Integer127 a, Integer127 b) {
    const Integer127 product = of(static_cast<Int128>(static_cast<Uint128>(a.value_) * static_cast<Uint128>(b.value_)));
    assert(a.value_ == 0 || product.value_ / a.value_ == b.value_);
    return product;
  }

 private:
  static Integer127 of(Int128 value) {
    Integer127 n;
    n.value_ = value;
    return n;
  }
  [[nodiscard]] Uint128 magnitude() const {
    return value_ < 0 ? -static_cast<Uint128>(value_) : static_cast<Uint128>(value_);
  }

  Int128 value_;
};

/// An integer below 2^255 in size: high * 2^128 + low.
class Integer255 {
 public:
  static constexpr long most_bits = 255;

  Integer255() = default;
  Integer255(long value)  // NOLINT(google-explicit-constructor): as mpz_class
      : low_(static_cast<Uint128>(static_cast<Int128>(value))), high_(value < 0 ? -Uint128{1} : 0) {}
  /// Of at most 255 bits.
  explicit Integer255(const mpz_class& n) {
    assert(kernels::bit_length(n) <= most_bits);
    const auto limb = [&](int i) { return static_cast<Uint128>(mpz_getlimbn(n.get_mpz_t(), i)); };
    low_ = limb(1) << 64 | limb(0);
    high_ = limb(3) << 64 | limb(2);
    if (sgn(n) < 0) *this = -*this;
  }

  [[nodiscard]] long bit_length() const {
    const Integer255 m = magnitude();
    return m.high_ != 0 ? 128 + kernels::bit_length(m.high_) : kernels::bit_length(m.low_);
  }
  /// The same number, if it has at most 63 bits.
  [[nodiscard]] std::int64_t to_word() const { return static_cast<std::int64_t>(low_); }
  template <unsigned Bits>
  explicit operator FixedInteger<Bits>() const {
    const Integer255 m = magnitude();
    const mp_limb_t limbs[4] = {static_cast<mp_limb_t>(m.low_), static_cast<mp_limb_t>(m.low_ >> 64),
                                static_cast<mp_limb_t>(m.high_), static_cast<mp_limb_t>(m.high_ >> 64)};
    return FixedInteger<Bits>::of_limbs(limbs, 4, negative());
  }
  /// |n| / 2^shift, rounded down, which has at most 64 bits.
  [[nodiscard]] std::uint64_t leading(long shift) const {
    const Integer255 m = magnitude();
    if (shift >= 128) return static_cast<std::uint64_t>(m.high_ >> (shift - 128));
    return static_cast<std::uint64_t>(m.low_ >> shift | (shift == 0 ? 0 : m.high_ << (128 - shift)));
  }

  friend int sgn(const Integer255& a) { return a.negative() ? -1 : (a.high_ | a.low_) != 0; }
  friend int cmp(const Integer255& a, const Integer255& b) {
    if (a.high_ != b.high_) return static_cast<Int128>(a.high_) < static_cast<Int128>(b.high_) ? -1 : 1;
    return (a.low_ > b.low_) - (a.low_ < b.low_);
  }
  friend bool operator==(const Integer255& a, const Integer255& b) = default;
  friend Integer255 operator-(const Integer255& a) { return of(-a.low_, ~a.high_ + (a.low_ == 0 ? 1 : 0)); }
  friend Integer255 operator+(const Integer255& a, const Integer255& b) {
    const Uint128 low = a.low_ + b.low_;
    const Integer255 sum = of(low, a.high_ + b.high_ + (low < a.low_ ? 1 : 0));
    assert(a.negative() != b.negative() || sum.negative() == a.negative());
    return sum;
  }
  friend Integer255 operator-(const Integer255& a, const Integer255& b) { return a + -b; }
  /// Modulo 2^256, which is the product itself where that fits.
  friend Integer255 operator*(const Integer255& a, const Integer255& b) {
    assert(a.bit_length() + b.bit_length() <= most_bits + 1);
    const auto low_half = [](Uint128 n) { return static_cast<Uint128>(static_cast<std::uint64_t>(n)); };
    const Uint128 a0 = low_half(a.low_), a1 = a.low_ >> 64, b0 = low_half(b.low_), b1 = b.low_ >> 64;
    const Uint128 first = a0 * b0, middle = a0 * b1 + (first >> 64), other = a1 * b0 + low_half(middle);
    const Integer255 product = of(other << 64 | low_half(first),
                                  a1 * b1 + (middle >> 64) + (other >> 64) + a.low_ * b.high_ + a.high_ * b.low_);
    assert(sgn(product) == sgn(a) * sgn(b));
    return product;
  }

 private:
  static Integer255 of(Uint128 low, Uint128 high) {
    Integer255 n;
    n.low_ = low;
    n.high_ = high;
    return n;
  }
  [[nodiscard]] bool negative() const { return high_ >> 127 != 0; }
  [[nodiscard]] Integer255 magnitude() const { return negative() ? -*this : *this; }

  Uint128 low_, high_;
};

template <class T>
concept WordInteger = std::same_as<T, Integer127> || std::same_as<T, Integer255>;

template <WordInteger T>
mpz_class to_mpz(const T& n) {
  return static_cast<FixedInteger<256>>(n).to_mpz();
}

}  // namespace fathom::kernels
