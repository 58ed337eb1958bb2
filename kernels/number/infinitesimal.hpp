// SPDX-License-Identifier: GPL-3.0-or-later
// The ordered ring Z[e1, ..., ek] of infinitesimals: 1 >> e1 >> e2 >> ..., each positive and
// smaller than any positive power of the one before.                       [proofs/perturbation.md]
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace fathom::kernels {

/// A product of powers of infinitesimals, packed so that comparing the packed numbers compares
/// sizes: the exponent of the smallest infinitesimal stands in the highest bits. A lower number is
/// a larger monomial; 0 is the monomial 1.
class Monomial {
 public:
  static constexpr unsigned variables = 12;  ///< e1, ..., e12
  static constexpr unsigned bits = 5;        ///< each
  static constexpr unsigned largest_exponent = 31;

  constexpr Monomial() = default;
  /// e_k to the power `exponent`, 1 <= k <= 12 and exponent <= 31: constants of the caller, not
  /// checked.
  constexpr explicit Monomial(unsigned k, unsigned exponent = 1)
      : packed_(std::uint64_t{exponent} << (bits * (k - 1))) {}

  [[nodiscard]] constexpr unsigned exponent(unsigned k) const { return packed_ >> (bits * (k - 1)) & largest_exponent; }
  /// Throws std::overflow_error when an exponent would exceed the largest.
  friend Monomial operator*(Monomial s, Monomial t);
  friend constexpr auto operator<=>(Monomial, Monomial) = default;

  /// "1", "e3", "e1^2 e5".
  [[nodiscard]] std::string text() const;
  [[nodiscard]] constexpr std::uint64_t packed() const { return packed_; }
  static constexpr Monomial unpacked(std::uint64_t packed) {
    Monomial m;
    m.packed_ = packed;
    return m;
  }

 private:
  std::uint64_t packed_ = 0;
};

/// A sparse polynomial in the infinitesimals with integer coefficients; its sign is that of the
/// coefficient of its largest monomial. A commutative ordered ring without zero divisors: s < t
/// implies s + u < t + u, and s, t > 0 imply s t > 0. Exact.
class Infinitesimal {
 public:
  using Term = std::pair<Monomial, mpz_class>;

  Infinitesimal() = default;
  Infinitesimal(int constant) : Infinitesimal(mpz_class(constant)) {}  // NOLINT: integers are elements of the ring
  Infinitesimal(const mpz_class& constant);                            // NOLINT
  Infinitesimal(Monomial monomial, const mpz_class& coefficient);

  /// Terms by falling size, no coefficient 0; empty for 0.
  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  /// The monomial that decides the sign; 1 for 0.
  [[nodiscard]] Monomial leading() const { return terms_.empty() ? Monomial() : terms_.front().first; }

  Infinitesimal& operator+=(const Infinitesimal& t);
  Infinitesimal& operator-=(const Infinitesimal& t);
  Infinitesimal& operator*=(const Infinitesimal& t);
  friend Infinitesimal operator+(Infinitesimal s, const Infinitesimal& t) { return s += t; }
  friend Infinitesimal operator-(Infinitesimal s, const Infinitesimal& t) { return s -= t; }
  friend Infinitesimal operator*(const Infinitesimal& s, const Infinitesimal& t);
  friend Infinitesimal operator-(Infinitesimal s);

  friend int sgn(const Infinitesimal& s) { return s.terms_.empty() ? 0 : sgn(s.terms_.front().second); }
  friend bool operator==(const Infinitesimal& s, const Infinitesimal& t) { return s.terms_ == t.terms_; }
  friend std::strong_ordering operator<=>(const Infinitesimal& s, const Infinitesimal& t);

 private:
  template <class Combine>
  void merge(const Infinitesimal& t, Combine combine);

  std::vector<Term> terms_;
};

/// "3 - 2 e1 e2^2"; "0".
std::ostream& operator<<(std::ostream& out, const Infinitesimal& s);

}  // namespace fathom::kernels
