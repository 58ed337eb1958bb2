// SPDX-License-Identifier: GPL-3.0-or-later
// Rational numbers: in lowest terms; as a word of bits times a power of two, which is what binary64
// holds; and rounded.                                                           [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"

namespace fathom::kernels {

/// p / q in lowest terms; q is not zero.
inline mpq_class ratio(const mpz_class& p, const mpz_class& q) {
  mpq_class result(p, q);
  result.canonicalize();
  return result;
}

/// value * 2^exponent.
inline mpq_class times_power_of_two(mpq_class value, long exponent) {
  if (exponent >= 0) mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return value;
}

/// A k with 2^(k-1) < |q| < 2^(k+1). For q != 0.
long binary_order(const mpq_class& q);

// All exact arithmetic relies on lowest terms, which the public functions check: GMP computes
// wrongly with mpq_class(2, -4).

/// Returns whether the number is in lowest terms over a positive denominator, as
/// mpq_class::canonicalize leaves it.
bool in_lowest_terms(const mpq_class& value);

/// Throws std::invalid_argument unless it is.
void require_lowest_terms(const mpq_class& value);

/// mantissa * 2^exponent, where the mantissa is odd; 0 is 0 * 2^0.
struct Dyadic {
  std::int64_t mantissa = 0;
  long exponent = 0;
};

/// mantissa * 2^exponent, for any mantissa.
inline Dyadic normalised(std::int64_t mantissa, long exponent) {
  if (mantissa == 0) return {};
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa >> zeros, exponent + zeros};
}

/// The exact value. Throws std::invalid_argument if it is not finite.
inline Dyadic dyadic(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<long>(bits >> 52 & 0x7ff);
  if (biased == 0x7ff) throw std::invalid_argument("a coordinate is not a finite number");
  const auto fraction = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  const std::int64_t magnitude = biased == 0 ? fraction : fraction | std::int64_t{1} << 52;
  return normalised(bits >> 63 != 0 ? -magnitude : magnitude, std::max(biased, 1L) - 1075);
}

/// A rational of few bits: mantissa * 2^exponent / divisor. The divisor is odd and below 2^63.
struct ShortRational : Dyadic {
  std::uint64_t divisor = 1;  ///< > 0
};

/// The number if its odd parts are that short, as they stand: whether they share a factor is for
/// the caller to ask. Returns nullopt if they are longer, and if the number is surely not in lowest
/// terms over a positive denominator.
std::optional<ShortRational> short_rational(const mpq_class& value);

/// The divisors of short rationals. They tell of many numbers at once whether they are in lowest
/// terms: a prime that divides a divisor and the product of its numerators divides one of these.
class Divisors {
 public:
  void clear() { products_.clear(); }
  /// Takes the number in, of which the divisor is not 1. False if there is no room for its divisor:
  /// of few each is looked up where it comes again, of more that would take too long.
  bool add(const ShortRational& number);
  [[nodiscard]] bool in_lowest_terms() const;
  /// Throws std::invalid_argument unless they are.
  void require_lowest_terms() const;
  /// The least common multiple, if it has at most so many bits.
  [[nodiscard]] std::optional<std::uint64_t> common(long bits) const;

 private:
  static constexpr std::size_t most = 64;

  std::vector<std::pair<std::uint64_t, std::uint64_t>> products_;  // a divisor; the product, modulo it
};

/// The nearest number of binary32, ties to even, while rounding is to nearest; infinite beyond its
/// range. Not in line: there g++ 12.2 leaves two out of three coordinates as they are.
double nearest_binary32(double value);

/// The number in binary64; nullopt if it is none.
std::optional<double> in_binary64(const mpq_class& value);

/// How the negative of a number is rounded, so that the number itself is rounded by `mode`.
constexpr Rounding mirrored(Rounding mode) {
  return mode == Rounding::rd ? Rounding::ru : mode == Rounding::ru ? Rounding::rd : Rounding::rn;
}

// All roundings of one number at once, for results that print them.

template <class Float>
struct EveryMode {
  Float rn, rd, ru;
  friend bool operator==(const EveryMode&, const EveryMode&) = default;
};

struct Roundings {
  EveryMode<double> binary64;
  EveryMode<float> binary32;
};

/// Returns what round_binary64 and round_binary32, the naive twins, say in each mode, by one
/// division.
Roundings roundings(const mpq_class& value);

/// Returns what root_binary64 and root_binary32, the naive twins, say in each mode, by one division
/// and one integer root. Throws std::domain_error if `squared` is negative.
Roundings roundings_of_root(const mpq_class& squared);

}  // namespace fathom::kernels
