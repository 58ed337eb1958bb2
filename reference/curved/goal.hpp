// SPDX-License-Identifier: GPL-3.0-or-later
// How near to each other the bounds have to be, and rational numbers around roots that are near
// enough for that.
#pragma once

#include <gmpxx.h>

namespace fathom::curved {

/// A number is rho + the signed root of x: sqrt(x), or -sqrt(-x) for x < 0. It is named by x.
class Goal {
 public:
  /// If low and high have one sign, high - low is to be at most 2^-bits of both, or of the extent;
  /// if not, at most 2^-status_bits of the extent, which are not fewer.
  Goal(unsigned bits, unsigned status_bits, mpq_class extent, mpq_class rho);

  /// Multiples of 2^-k, moved by rho, at most and at least the number. They differ by less than the
  /// goal allows.
  [[nodiscard]] mpq_class from_below(const mpq_class& x) const;
  [[nodiscard]] mpq_class from_above(const mpq_class& x) const;
  /// The number itself, if x is the square of a rational or its negative; else from_below or
  /// from_above.
  [[nodiscard]] mpq_class exact_or_below(const mpq_class& x) const;
  [[nodiscard]] mpq_class exact_or_above(const mpq_class& x) const;
  [[nodiscard]] bool met(const mpq_class& low, const mpq_class& high) const;
  /// Whether these bounds have one sign.
  static bool decided(const mpq_class& low, const mpq_class& high) { return low > 0 || high < 0; }

  [[nodiscard]] const mpq_class& extent() const { return extent_; }
  [[nodiscard]] const mpq_class& rho() const { return rho_; }
  /// 2^-finest is a small part of what the goal allows for a number of the size of sqrt(|x|).
  [[nodiscard]] long finest(const mpq_class& x) const;
  /// 2^-bits, less some room for numbers in the proof that are rounded afterwards.
  [[nodiscard]] const mpq_class& share() const { return share_; }

 private:
  unsigned status_bits_;
  mpq_class extent_, rho_, share_, status_share_;
};

/// value * 2^exponent.
mpq_class shifted(const mpq_class& value, long exponent);
/// The least integer >= value.
mpz_class rounded_up(const mpq_class& value);

}  // namespace fathom::curved
