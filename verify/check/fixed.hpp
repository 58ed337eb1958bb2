// SPDX-License-Identifier: Apache-2.0
// Integers of a fixed size, which need no memory of their own: words, and what products and sums of
// these need. They stand for GMP's where a bound is known, which whoever uses them proves.
#pragma once

#include <gmpxx.h>

#include <cassert>
#include <cstddef>
#include <cstdint>

namespace fathom_check {

using Word = std::int64_t;
__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;
static_assert(GMP_NUMB_BITS == 64, "a digit of GMP is a word");

/// Binary digits of the absolute value; 0 has none.
inline std::size_t bits(mpz_srcptr n) {
  const std::size_t digits = mpz_size(n);
  return digits == 0 ? 0 : 64 * digits - static_cast<std::size_t>(__builtin_clzll(mpz_getlimbn(n, digits - 1)));
}

/// Returns an integer of at most 127 bits.
inline Int128 to_int128(mpz_srcptr n) {
  assert(bits(n) <= 127);
  const auto size = static_cast<Int128>(Uint128{mpz_getlimbn(n, 1)} << 64 | mpz_getlimbn(n, 0));
  return mpz_sgn(n) < 0 ? -size : size;
}
/// Returns an integer of at most 63 bits.
inline Word to_word(mpz_srcptr n) {
  assert(bits(n) <= 63);
  const auto size = static_cast<Word>(mpz_getlimbn(n, 0));
  return mpz_sgn(n) < 0 ? -size : size;
}

/// At least -2^255, and less than 2^255.
class Int256 {
 public:
  Int256() = default;
  /// a b, whatever they are: it is at most 2^254. Of a word b no upper half is multiplied.
  template <class Number>
  static Int256 product(Int128 a, Number b) {
    const auto low_half = [](Uint128 n) { return Uint128{static_cast<std::uint64_t>(n)}; };
    const Uint128 u = size(a), v = size(b);
    const Uint128 first = low_half(u) * low_half(v), middle = low_half(u) * (v >> 64) + (first >> 64),
                  other = (u >> 64) * low_half(v) + low_half(middle);
    const Int256 result(other << 64 | low_half(first), (u >> 64) * (v >> 64) + (middle >> 64) + (other >> 64));
    return (a < 0) != (b < 0) ? -result : result;
  }
  /// Writes it as an integer of GMP.
  void copy_to(mpz_class& result) const {
    const Int256 absolute = negative() ? -*this : *this;
    mp_limb_t* const digits = mpz_limbs_write(result.get_mpz_t(), 4);
    digits[0] = static_cast<mp_limb_t>(absolute.low_);
    digits[1] = static_cast<mp_limb_t>(absolute.low_ >> 64);
    digits[2] = static_cast<mp_limb_t>(absolute.high_);
    digits[3] = static_cast<mp_limb_t>(absolute.high_ >> 64);
    mpz_limbs_finish(result.get_mpz_t(), negative() ? -4 : 4);
  }

  friend Int256 operator-(const Int256& a) { return {-a.low_, ~a.high_ + (a.low_ == 0 ? 1 : 0)}; }
  /// The sum must fit.
  friend Int256 operator+(const Int256& a, const Int256& b) {
    const Uint128 low = a.low_ + b.low_;
    const Int256 sum(low, a.high_ + b.high_ + (low < a.low_ ? 1 : 0));
    assert(a.negative() != b.negative() || sum.negative() == a.negative());
    return sum;
  }
  friend bool operator!=(const Int256& a, const Int256& b) { return a.low_ != b.low_ || a.high_ != b.high_; }
  friend bool operator<(const Int256& a, const Int256& b) {
    return a.high_ != b.high_ ? static_cast<Int128>(a.high_) < static_cast<Int128>(b.high_) : a.low_ < b.low_;
  }
  friend int sgn(const Int256& a) { return a.negative() ? -1 : (a.low_ | a.high_) != 0; }

 private:
  Int256(Uint128 low, Uint128 high) : low_(low), high_(high) {}
  static Uint128 size(Int128 n) { return n < 0 ? -static_cast<Uint128>(n) : static_cast<Uint128>(n); }
  static Uint128 size(Word n) { return n < 0 ? -static_cast<std::uint64_t>(n) : static_cast<std::uint64_t>(n); }
  [[nodiscard]] bool negative() const { return high_ >> 127 != 0; }

  Uint128 low_, high_;  // modulo 2^256
};

inline void copy(mpz_class& result, const Int256& n) { n.copy_to(result); }
inline void copy(mpz_class& result, Int128 n) { Int256::product(n, Word{1}).copy_to(result); }
inline void copy(mpz_class& result, const mpz_class& n) { result = n; }

template <class Number>
struct FixedVector {
  Number x, y, z;
};
using Words = FixedVector<Word>;

// As those of vectors.hpp, where the results fit.
inline void dot(Int128& result, const Words& u, const Words& v) {
  result = Int128{u.x} * v.x + Int128{u.y} * v.y + Int128{u.z} * v.z;
}
template <class Number>
void dot(Int256& result, const FixedVector<Int128>& u, const FixedVector<Number>& v) {
  result = Int256::product(u.x, v.x) + Int256::product(u.y, v.y) + Int256::product(u.z, v.z);
}
inline void cross(FixedVector<Int128>& result, const Words& u, const Words& v) {
  const auto minor = [](Word a, Word b, Word c, Word d) { return Int128{a} * d - Int128{b} * c; };
  result = {minor(u.y, u.z, v.y, v.z), minor(u.z, u.x, v.z, v.x), minor(u.x, u.y, v.x, v.y)};
}
inline void subtract(Words& result, const Words& u, const Words& v) { result = {u.x - v.x, u.y - v.y, u.z - v.z}; }
inline void add(FixedVector<Int128>& sum, const FixedVector<Int128>& v) {
  sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z};
}

}  // namespace fathom_check
