// SPDX-License-Identifier: Apache-2.0
// Integers that are made once and kept. A small certificate has several hundred, and an allocation
// for each would take longer than their arithmetic: so their digits lie side by side in a few
// blocks.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace fathom_check {

/// An integer whose digits lie in an Arena, which must outlive it. Copies share the digits; nothing
/// changes them.
class Integer {
 public:
  Integer() : Integer(&one_, 0) {}
  static Integer one() { return {&one_, 1}; }

  [[nodiscard]] mpz_srcptr get_mpz_t() const { return value_; }
  [[nodiscard]] mpz_class value() const { return mpz_class(value_); }
  [[nodiscard]] int sign() const { return mpz_sgn(value_); }

 private:
  friend class Arena;
  /// Digits with the least one first, and their number, which is negative if the integer is.
  Integer(mp_srcptr digits, mp_size_t size)
      : value_ MPZ_ROINIT_N(const_cast<mp_limb_t*>(digits), static_cast<int>(size)) {}

  static constexpr mp_limb_t one_ = 1;
  mpz_t value_;
};

inline bool operator==(const Integer& u, const Integer& v) { return mpz_cmp(u.get_mpz_t(), v.get_mpz_t()) == 0; }

class Arena {
 public:
  Integer keep(const mpz_class& value) {
    if (value == 0) return {};
    const std::size_t size = mpz_size(value.get_mpz_t());
    mp_limb_t* const digits = room(size);
    std::copy_n(mpz_limbs_read(value.get_mpz_t()), size, digits);
    return {digits, sgn(value) * static_cast<mp_size_t>(size)};
  }
  Integer keep(std::int64_t value) {
    if (value == 0) return {};
    mp_limb_t* const digit = room(1);
    *digit = value < 0 ? -static_cast<mp_limb_t>(value) : static_cast<mp_limb_t>(value);
    return {digit, value < 0 ? -1 : 1};
  }

 private:
  mp_limb_t* room(std::size_t digits) {
    constexpr std::size_t block = 1024;
    if (digits > left_) {
      left_ = std::max(digits, block);
      blocks_.emplace_back(new mp_limb_t[left_]);
      next_ = blocks_.back().get();
    }
    left_ -= digits;
    return std::exchange(next_, next_ + digits);
  }

  std::vector<std::unique_ptr<mp_limb_t[]>> blocks_;
  mp_limb_t* next_ = nullptr;
  std::size_t left_ = 0;
};

}  // namespace fathom_check
