// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of bounded size that live in place: no allocation, no pointer. Sign and magnitude, like
// GMP's, and over GMP's own mpn functions; what fits one limb is done without a call.
//                                                              [proofs/number.md, "Fixed integers"]
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace fathom::kernels {

static_assert(GMP_LIMB_BITS == 64 && GMP_NAIL_BITS == 0, "limbs have 64 bits");

/// An integer of at most `Bits` bits and a sign. Only the limbs in use are touched, so a wide type
/// costs memory and no time. Sums and products are exact; one that needs more than `Bits` + 64 bits
/// throws std::overflow_error, and whoever computes proves that none does.
template <unsigned Bits>
class FixedInteger {
 public:
  static_assert(Bits % 64 == 0);
  /// One limb more: the sizes of two factors may add up to one limb more than their product has.
  static constexpr int capacity = static_cast<int>(Bits / 64) + 1;

  FixedInteger() = default;
  FixedInteger(long value)
      : size_(value == 0  ? 0
              : value < 0 ? -1
                          : 1) {  // NOLINT(google-explicit-constructor): as mpz_class
    limbs_[0] = value < 0 ? -static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
  }
  explicit FixedInteger(const mpz_class& value) {
    assign(mpz_limbs_read(value.get_mpz_t()), sgn(value) * static_cast<int>(mpz_size(value.get_mpz_t())));
  }
  template <unsigned Other>
  explicit FixedInteger(const FixedInteger<Other>& other) {
    assign(other.limbs(), other.size());
  }
  FixedInteger(const FixedInteger& other) : size_(other.size_) { copy(other); }
  FixedInteger& operator=(const FixedInteger& other) {
    size_ = other.size_;
    copy(other);
    return *this;
  }
  ~FixedInteger() = default;

  /// From `count` limbs, the lowest first.
  static FixedInteger of_limbs(const mp_limb_t* limbs, int count, bool negative) {
    FixedInteger result;
    while (count > 0 && limbs[count - 1] == 0) --count;
    result.assign(limbs, negative ? -count : count);
    return result;
  }
  /// value * 2^shift.
  static FixedInteger shifted(long value, unsigned shift) {
    FixedInteger result(value);
    const unsigned whole = shift / 64, part = shift % 64;
    if (value == 0 || shift == 0) return result;
    if (whole + 2 > static_cast<unsigned>(capacity)) overflow();
    const mp_limb_t magnitude = result.limbs_[0];
    std::fill_n(result.limbs_, whole, mp_limb_t{0});
    result.limbs_[whole] = magnitude << part;
    result.limbs_[whole + 1] = part == 0 ? 0 : magnitude >> (64 - part);
    result.set_size(static_cast<int>(whole) + 2, value < 0);
    return result;
  }

  /// The number of limbs, negative for negative numbers. The highest limb is not zero.
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] int limb_count() const { return size_ < 0 ? -size_ : size_; }
  [[nodiscard]] const mp_limb_t* limbs() const { return limbs_; }
  /// The number of bits of the magnitude; 0 for zero.
  [[nodiscard]] long bit_length() const {
    const int n = limb_count();
    return n == 0 ? 0 : 64L * n - std::countl_zero(limbs_[n - 1]);
  }
  /// The number of zero bits below the lowest bit that is set. Not for zero.
  [[nodiscard]] unsigned trailing_zeros() const {
    unsigned i = 0;
    while (limbs_[i] == 0) ++i;
    return 64 * i + static_cast<unsigned>(std::countr_zero(limbs_[i]));
  }
  /// Divides by 2^shift, which has to divide the number.
  void divide_by_power(unsigned shift) {
    const int whole = static_cast<int>(shift / 64), n = limb_count() - whole;
    if (size_ == 0 || shift == 0) return;
    if (shift % 64 == 0) std::memmove(limbs_, limbs_ + whole, static_cast<std::size_t>(n) * sizeof(mp_limb_t));
    else mpn_rshift(limbs_, limbs_ + whole, n, shift % 64);
    set_size(n, size_ < 0);
  }

  /// Divides by a divisor of the number, not zero.
  void divide_by(std::uint64_t divisor) {
    if (size_ == 0) return;
    mpn_divexact_1(limbs_, limbs_, limb_count(), divisor);
    set_size(limb_count(), size_ < 0);
  }

  /// The same number, if it has at most 63 bits.
  [[nodiscard]] std::int64_t to_word() const {
    const auto magnitude = size_ == 0 ? 0 : static_cast<std::int64_t>(limbs_[0]);
    return size_ < 0 ? -magnitude : magnitude;
  }
  /// The same number for GMP: a view, which reads this object.
  void view(mpz_ptr z) const { mpz_roinit_n(z, limbs_, size_); }
  [[nodiscard]] mpz_class to_mpz() const {
    mpz_t z;
    view(z);
    return mpz_class(z);
  }

  friend int sgn(const FixedInteger& a) { return (a.size_ > 0) - (a.size_ < 0); }
  friend int cmp(const FixedInteger& a, const FixedInteger& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
    const int order = a.size_ == 0 ? 0 : mpn_cmp(a.limbs_, b.limbs_, a.limb_count());
    return a.size_ < 0 ? -order : order;
  }
  friend bool operator==(const FixedInteger& a, const FixedInteger& b) { return a.size_ == b.size_ && cmp(a, b) == 0; }

  friend FixedInteger operator-(FixedInteger a) {
    a.size_ = -a.size_;
    return a;
  }
  friend FixedInteger operator+(const FixedInteger& a, const FixedInteger& b) { return sum(a, b, b.size_); }
  friend FixedInteger operator-(const FixedInteger& a, const FixedInteger& b) { return sum(a, b, -b.size_); }
  friend FixedInteger operator*(const FixedInteger& a, const FixedInteger& b) {
    FixedInteger r;
    const int m = a.limb_count(), n = b.limb_count();
    if (m == 0 || n == 0) return r;
    if (m + n > capacity) overflow();
    if (m == 1 && n == 1) {
      const Double product = static_cast<Double>(a.limbs_[0]) * b.limbs_[0];
      r.limbs_[0] = static_cast<mp_limb_t>(product);
      r.limbs_[1] = static_cast<mp_limb_t>(product >> 64);
    } else if (m >= n) {
      mpn_mul(r.limbs_, a.limbs_, m, b.limbs_, n);
    } else {
      mpn_mul(r.limbs_, b.limbs_, n, a.limbs_, m);
    }
    r.set_size(m + n, (a.size_ < 0) != (b.size_ < 0));
    return r;
  }

 private:
  __extension__ using Double = unsigned __int128;

  [[noreturn]] static void overflow() { throw std::overflow_error("a number has more bits than its type"); }

  void assign(const mp_limb_t* limbs, int size) {
    const int n = size < 0 ? -size : size;
    if (n > capacity) overflow();
    size_ = size;
    if (n == 1) limbs_[0] = *limbs;
    else std::copy_n(limbs, n, limbs_);
  }
  // Mostly one limb or two: a call of memmove would cost more than the copy.
  void copy(const FixedInteger& other) {
    const int n = other.limb_count();
    if (n > 2) std::copy_n(other.limbs_, n, limbs_);
    if (n == 1 || n == 2) limbs_[0] = other.limbs_[0];
    if (n == 2) limbs_[1] = other.limbs_[1];
  }
  // From the number of limbs, the highest of which may be zero.
  void set_size(int n, bool negative) {
    while (n > 0 && limbs_[n - 1] == 0) --n;
    size_ = negative ? -n : n;
  }

  // a + b, where b has `size_of_b` instead of its own size.
  static FixedInteger sum(const FixedInteger& a, const FixedInteger& b, int size_of_b) {
    FixedInteger r;
    const int m = a.limb_count(), n = b.limb_count();
    const bool negative_a = a.size_ < 0, negative_b = size_of_b < 0;
    if (m == 1 && n == 1) {
      const mp_limb_t x = a.limbs_[0], y = b.limbs_[0];
      if (negative_a == negative_b) {
        r.limbs_[0] = x + y;
        r.limbs_[1] = r.limbs_[0] < x ? 1 : 0;
        r.set_size(2, negative_a);
      } else {
        r.limbs_[0] = x > y ? x - y : y - x;
        r.set_size(1, (x > y) == negative_a);
      }
    } else if (negative_a == negative_b || m == 0 || n == 0) {
      const FixedInteger &longer = m >= n ? a : b, &shorter = m >= n ? b : a;
      const int most = std::max(m, n), least = std::min(m, n);
      if (most == capacity) overflow();
      r.limbs_[most] = least == 0 ? (std::copy_n(longer.limbs_, most, r.limbs_), mp_limb_t{0})
                                  : mpn_add(r.limbs_, longer.limbs_, most, shorter.limbs_, least);
      r.set_size(most + 1, m >= n && m > 0 ? negative_a : negative_b);
    } else {
      const int order = m != n ? m - n : mpn_cmp(a.limbs_, b.limbs_, m);
      if (order == 0) return r;
      const FixedInteger &larger = order > 0 ? a : b, &smaller = order > 0 ? b : a;
      mpn_sub(r.limbs_, larger.limbs_, larger.limb_count(), smaller.limbs_, smaller.limb_count());
      r.set_size(larger.limb_count(), order > 0 ? negative_a : negative_b);
    }
    return r;
  }

  int size_ = 0;
  mp_limb_t limbs_[capacity];
};

}  // namespace fathom::kernels
