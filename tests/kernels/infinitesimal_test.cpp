// SPDX-License-Identifier: GPL-3.0-or-later
// The axioms of an ordered ring; arithmetic against a plain map of exponents; signs against honest
// small numbers; what is infinitely smaller than what.
#include "kernels/number/infinitesimal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

Infinitesimal e(unsigned k, unsigned exponent = 1) { return Infinitesimal(Monomial(k, exponent), 1); }

Infinitesimal power(const Infinitesimal& s, unsigned exponent) {
  Infinitesimal result = 1;
  for (unsigned i = 0; i < exponent; ++i) result *= s;
  return result;
}

std::string text(const Infinitesimal& s) {
  std::ostringstream out;
  out << s;
  return out.str();
}

constexpr int largest_coefficient = 4;
constexpr unsigned largest_degree = 3, terms = 5;

/// Up to five terms in e_1, e_2 and one of e_3, e_12: few monomials, so that they often meet and
/// cancel.
rc::Gen<Infinitesimal> polynomials() {
  using Term = std::tuple<unsigned, unsigned, unsigned, unsigned, int>;
  const auto degree = rc::gen::inRange(0U, largest_degree + 1);
  const auto coefficient = rc::gen::inRange(-largest_coefficient, largest_coefficient + 1);
  const auto term = rc::gen::tuple(degree, degree, degree, rc::gen::element(3U, 12U), coefficient);
  const auto list = rc::gen::mapcat(rc::gen::inRange(0U, terms + 1),
                                    [=](unsigned n) { return rc::gen::container<std::vector<Term>>(n, term); });
  return rc::gen::resize(rc::kNominalSize, rc::gen::map(list, [](const std::vector<Term>& chosen) {
                           Infinitesimal sum;
                           for (const auto& [a, b, c, k, factor] : chosen) sum += factor * e(1, a) * e(2, b) * e(k, c);
                           return sum;
                         }));
}

// The naive twin: exponents to coefficient.
using Exponents = std::array<unsigned, Monomial::variables>;
using Plain = std::map<Exponents, mpz_class>;

Plain plain(const Infinitesimal& s) {
  Plain result;
  for (const auto& [monomial, coefficient] : s.terms()) {
    Exponents exponents{};
    for (unsigned k = 1; k <= Monomial::variables; ++k) exponents[k - 1] = monomial.exponent(k);
    result[exponents] += coefficient;
  }
  return result;
}

Plain without_zeros(Plain p) {
  std::erase_if(p, [](const auto& term) { return term.second == 0; });
  return p;
}

Plain sum(Plain s, const Plain& t, int factor) {
  for (const auto& [exponents, coefficient] : t) s[exponents] += factor * coefficient;
  return without_zeros(s);
}

Plain product(const Plain& s, const Plain& t) {
  Plain result;
  for (const auto& [m, c] : s) {
    for (const auto& [n, d] : t) {
      Exponents exponents{};
      for (std::size_t k = 0; k < exponents.size(); ++k) exponents[k] = m[k] + n[k];
      result[exponents] += c * d;
    }
  }
  return without_zeros(result);
}

// No zero coefficient, terms strictly falling.
bool well_formed(const Infinitesimal& s) {
  const auto& list = s.terms();
  return std::ranges::none_of(list, [](const auto& term) { return term.second == 0; }) &&
         std::ranges::adjacent_find(list, [](const auto& t, const auto& u) { return !(t.first < u.first); }) ==
             list.end();
}

template <class Property>
void law(const char* name, const Property& property) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] { property(*polynomials(), *polynomials(), *polynomials()); }))
      << name;
}

TEST(Infinitesimal, IsACommutativeRing) {
  law("addition", [](const Infinitesimal& s, const Infinitesimal& t, const Infinitesimal& u) {
    RC_ASSERT(s + t == t + s);
    RC_ASSERT((s + t) + u == s + (t + u));
    RC_ASSERT(s + 0 == s);
    RC_ASSERT(s - s == Infinitesimal());
    RC_ASSERT(s + (-s) == Infinitesimal());
    RC_ASSERT(s - t == s + (-t));
  });
  law("multiplication", [](const Infinitesimal& s, const Infinitesimal& t, const Infinitesimal& u) {
    RC_ASSERT(s * t == t * s);
    RC_ASSERT((s * t) * u == s * (t * u));
    RC_ASSERT(s * 1 == s);
    RC_ASSERT(s * 0 == Infinitesimal());
    RC_ASSERT(s * (t + u) == s * t + s * u);
    RC_ASSERT((-s) * t == -(s * t));
  });
}

TEST(Infinitesimal, IsOrderedAndHasNoZeroDivisors) {
  law("order", [](const Infinitesimal& s, const Infinitesimal& t, const Infinitesimal& u) {
    RC_ASSERT((s < t) + (s == t) + (t < s) == 1);
    RC_ASSERT((s < t) == (s + u < t + u));
    RC_ASSERT(!(s < t && t < u) || s < u);
    RC_ASSERT(sgn(s * t) == sgn(s) * sgn(t));
    RC_ASSERT(sgn(-s) == -sgn(s));
    RC_ASSERT((s * t == Infinitesimal()) == (s == Infinitesimal() || t == Infinitesimal()));
    RC_ASSERT(sgn(s * s) >= 0);
    RC_ASSERT((s <=> t) == (0 <=> sgn(t - s)));
  });
}

TEST(Infinitesimal, AgreesWithAMapOfExponents) {
  law("twin", [](const Infinitesimal& s, const Infinitesimal& t, const Infinitesimal&) {
    RC_ASSERT(plain(s + t) == sum(plain(s), plain(t), 1));
    RC_ASSERT(plain(s - t) == sum(plain(s), plain(t), -1));
    RC_ASSERT(plain(s * t) == product(plain(s), plain(t)));
    RC_ASSERT(well_formed(s) && well_formed(s + t) && well_formed(s - t) && well_formed(s * t) && well_formed(-s));
    RC_ASSERT(s.leading() == (s.terms().empty() ? Monomial() : s.terms().front().first));
  });
}

TEST(Infinitesimal, EachIsSmallerThanAnyPowerOfTheOneBefore) {
  EXPECT_LT(1000000 * e(1), Infinitesimal(1));
  EXPECT_LT(Infinitesimal(power_of_two(1000)) * e(1), Infinitesimal(1));
  for (unsigned k = 1; k <= Monomial::variables; ++k) {
    EXPECT_GT(e(k), Infinitesimal());
    EXPECT_LT(1000000 * e(k), Infinitesimal(1));
    if (k == Monomial::variables) break;
    for (unsigned j = 1; j <= Monomial::largest_exponent; ++j) {
      EXPECT_LT(1000000 * e(k + 1), e(k, j)) << k << ", " << j;
      EXPECT_LT(1000000 * e(k + 1) * e(k), e(k + 1)) << k;
      EXPECT_LT(1000000 * e(k, j), e(k, j - 1)) << k << ", " << j;
    }
  }
}

TEST(Monomial, AllButTheLastInWhichTwoDifferIsOfNoAccount) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const auto exponents = rc::gen::resize(rc::kNominalSize, rc::gen::container<Exponents>(rc::gen::inRange(0U, 3U)));
    const Exponents s = *exponents, t = *exponents;
    Monomial m, n;
    for (unsigned k = 1; k <= Monomial::variables; ++k) {
      m = m * Monomial(k, s[k - 1]);
      n = n * Monomial(k, t[k - 1]);
    }
    RC_ASSERT((m <=> n) == std::lexicographical_compare_three_way(s.rbegin(), s.rend(), t.rbegin(), t.rend()));
    RC_ASSERT(Monomial::unpacked(m.packed()) == m);
    RC_ASSERT((Infinitesimal(m, 1) > Infinitesimal(n, 1)) == (m < n));
  }));
}

// With degrees at most D, e_k = r^((D+1)^(k-1)) makes each monomial r^N with N its exponents read
// as digits, so different monomials differ by a factor r at least, in the ring's order; and with
// coefficients at most C, C r/(1 - r) < 1 lets the largest outweigh the rest.
TEST(Infinitesimal, SignsAreThoseOfSmallEnoughNumbers) {
  constexpr unsigned base = largest_degree + 1, highest = base - 1 + base * (base - 1) + base * base * (base - 1);
  constexpr unsigned bits = 12;
  static_assert(4 * largest_coefficient * 100 < 1 << bits);  // a hundred terms on one monomial at most
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] {
    const auto degree = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0U, largest_degree + 1));
    const auto coefficient =
        rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-largest_coefficient, largest_coefficient + 1));
    Infinitesimal s;
    mpz_class value = 0;  // times 2^(bits highest)
    for (int term = *rc::gen::inRange(0, 100); term > 0; --term) {
      const unsigned a = *degree, b = *degree, c = *degree;
      const int factor = *coefficient;
      s += factor * (e(1, a) * e(2, b) * e(3, c));
      value += factor * power_of_two(bits * (highest - a - base * b - base * base * c));
    }
    RC_ASSERT(sgn(s) == sgn(value));
  }));
}

TEST(Infinitesimal, OverflowOfAnExponentIsRefused) {
  for (unsigned k = 1; k <= Monomial::variables; ++k) {
    EXPECT_EQ(e(k, 15) * e(k, 16), e(k, 31));
    EXPECT_THROW(e(k, 16) * e(k, 16), std::overflow_error);
    EXPECT_THROW(e(k, 31) * e(k), std::overflow_error);
    EXPECT_THROW(Monomial(k, 31) * Monomial(k), std::overflow_error);
    Infinitesimal s = 1 + e(k, 20);
    EXPECT_THROW(s *= s, std::overflow_error);
    EXPECT_EQ(s, 1 + e(k, 20)) << "unchanged";
  }
  EXPECT_EQ(power(e(12), 31), e(12, 31));
}

TEST(Infinitesimal, MayBeItsOwnOperand) {
  law("self", [](const Infinitesimal& s, const Infinitesimal&, const Infinitesimal&) {
    Infinitesimal twice = s, none = s, squared = s, same = s;
    twice += twice;
    none -= *&none;
    squared *= squared;
    same = *&same;
    RC_ASSERT(twice == 2 * s);
    RC_ASSERT(none == Infinitesimal());
    RC_ASSERT(squared == s * s);
    RC_ASSERT(same == s);
  });
}

TEST(Infinitesimal, Prints) {
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(e(1) - e(1)), "0");
  EXPECT_EQ(text(-7), "-7");
  EXPECT_EQ(text(e(3)), "e3");
  EXPECT_EQ(text(-e(12, 31)), "-e12^31");
  EXPECT_EQ(text(3 - 2 * e(1) * e(2, 2)), "3 - 2 e1 e2^2");
  EXPECT_EQ(text(e(2) - 5 + e(1)), "-5 + e1 + e2");
  EXPECT_EQ(text(-e(2) - e(1, 2) * e(5)), "-e2 - e1^2 e5");
  EXPECT_EQ(text(Infinitesimal(power_of_two(70))), "1180591620717411303424");
  EXPECT_EQ(Monomial().text(), "1");
  EXPECT_EQ((Monomial(1, 2) * Monomial(5)).text(), "e1^2 e5");
}

TEST(Infinitesimal, ConstantsAreIntegers) {
  EXPECT_EQ(Infinitesimal(Monomial(4), 0), Infinitesimal());
  EXPECT_EQ(sgn(Infinitesimal(power_of_two(200)) - Infinitesimal(mpz_class(power_of_two(200) + 1))), -1);
  EXPECT_EQ(Infinitesimal().leading(), Monomial());
  EXPECT_EQ((e(3) * e(7) - e(9)).leading(), Monomial(3) * Monomial(7));
}

}  // namespace
}  // namespace fathom::kernels
