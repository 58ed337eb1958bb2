// SPDX-License-Identifier: Apache-2.0
// What limits are made of: widths of numbers, and counts that do not overflow.
//                                                                            [FORMAT.md, section 8]
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "budget.hpp"
#include "certificate.hpp"
#include "limits.hpp"
#include "vectors.hpp"

namespace fathom_check {

using Count = std::uint64_t;

/// No amount of work is counted above this.
constexpr Count too_much = std::numeric_limits<Count>::max() / 2;

inline Count sum(Count s, Count t) { return std::min(too_much, std::min(too_much, s) + std::min(too_much, t)); }
inline Count product(Count s, Count t) { return s != 0 && t > too_much / s ? too_much : s * t; }

/// How wide numbers become over their common denominator, if `vectors` of them are kept.
class Width {
 public:
  Width(Count vectors, std::size_t line, const Limits& limits)
      : vectors_(vectors), line_(line), largest_(limits.size) {}

  void take(const Rational& r) {
    numerator_ = std::max(numerator_, bits(r.num));
    const mpz_srcptr common = denominator_.get_mpz_t(), den = r.den.get_mpz_t();
    const bool words = bits(common) <= 63 && bits(den) <= 63;
    if (words ? to_word(common) % to_word(den) == 0 : mpz_divisible_p(common, den) != 0) return;
    mpz_lcm(denominator_.get_mpz_t(), denominator_.get_mpz_t(), r.den.get_mpz_t());
    if (vectors_ * bits(denominator_) > largest_) throw too_large();
  }
  [[nodiscard]] Count value() const { return bits(denominator_) + numerator_; }
  [[nodiscard]] const mpz_class& denominator() const { return denominator_; }

  [[nodiscard]] Fault too_large() const {
    return malformed(line_, "a certificate larger than the limit, " + std::to_string(largest_) + " in its size");
  }

 private:
  Count vectors_, numerator_ = 0;
  std::size_t line_;
  std::uint64_t largest_;
  mpz_class denominator_ = 1;
};

/// What a product of numbers of these sizes takes.
inline Count cost(Count s, Count t) {
  constexpr Count fixed = 256, linear_from = 4'000;
  return product(fixed + std::max(s, t), fixed + std::min({s, t, linear_from}));
}

inline Count widest(const Vector& n) { return std::max({bits(n.x), bits(n.y), bits(n.z)}); }
inline Count widest(const Part<std::vector<Vector>>& vectors) {
  Count result = 0;
  for (const Vector& n : vectors.items) result = std::max(result, widest(n));
  return result;
}

/// Throws Fault (malformed, on `line`) if it is above the limit.
inline void require_work(Count work, std::size_t line, const Limits& limits) {
  if (work > limits.work)
    throw malformed(line, "a certificate of more work than the limit, " + std::to_string(limits.work));
}

}  // namespace fathom_check
