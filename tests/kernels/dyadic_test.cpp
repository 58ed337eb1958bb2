// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::kernels {
namespace {

mpq_class value(const Dyadic& d) {
  mpq_class q(d.mantissa);
  if (d.exponent >= 0) mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(d.exponent));
  else mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-d.exponent));
  return q;
}

TEST(Dyadic, IsTheExactValueOfEveryDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(i % 5 == 0 ? random() & 0x800fffffffffffffU : random());
    if (!std::isfinite(x)) continue;
    const Dyadic d = dyadic(x);
    ASSERT_EQ(value(d), exact_value(x)) << x;
    ASSERT_TRUE(d.mantissa % 2 != 0 || x == 0) << x;
  }
  for (const double x : {0.0, -0.0}) EXPECT_TRUE(dyadic(x).mantissa == 0 && dyadic(x).exponent == 0);
  EXPECT_THROW(dyadic(std::nan("")), std::invalid_argument);
  EXPECT_THROW(dyadic(-std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(Dyadic, OfRationals) {
  for (const auto& [numerator, denominator] :
       {std::pair{0L, 1UL}, {12L, 1UL}, {-7L, 8UL}, {INT64_MAX, 2UL}, {-INT64_MAX, 1UL}}) {
    const mpq_class q(numerator, denominator);
    const auto d = dyadic(q);
    ASSERT_TRUE(d) << q;
    EXPECT_EQ(value(*d), q);
    EXPECT_TRUE(d->mantissa % 2 != 0 || q == 0);
  }
  EXPECT_FALSE(dyadic(mpq_class(1, 3)));
  EXPECT_FALSE(dyadic(mpq_class(5, 12)));
  EXPECT_FALSE(dyadic(mpq_class(mpz_class(1) << 63))) << "a long numerator";
  EXPECT_FALSE(dyadic(mpq_class(2, 4))) << "not in lowest terms";
  EXPECT_FALSE(dyadic(mpq_class(1, -4)));
  EXPECT_FALSE(dyadic(mpq_class(1, 0)));
}

TEST(Dyadic, InBinary64AreItsNumbersAlone) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(i % 5 == 0 ? random() & 0x800fffffffffffffU : random());
    if (!std::isfinite(x)) continue;
    const mpq_class exact = exact_value(x), third = exact / 3;
    ASSERT_EQ(in_binary64(exact), std::optional(x + 0.0)) << x;
    const bool is_number = exact_value(round_binary64(third)) == third;
    ASSERT_EQ(in_binary64(third).has_value(), is_number) << x;
  }
  const mpq_class top = value({1, 1024}), least = value({1, -1074});
  for (const mpq_class& q :
       {top, mpq_class(-top), mpq_class(least / 2), mpq_class(3 * least / 2), value({(1L << 53) + 1, 0}),
        value({(1L << 53) + 1, 900}), mpq_class(1, 3), mpq_class(1, -4), mpq_class(1, 0)})
    EXPECT_FALSE(in_binary64(q)) << q;
  EXPECT_EQ(in_binary64(mpq_class(top - value({1, 971}))), std::numeric_limits<double>::max());
  EXPECT_EQ(in_binary64(least), 0x1p-1074);
}

TEST(Dyadic, EachOfThreeIsRoundedToBinary32) {
  for (const double x : {0.1, -0.7, 1e-42, 1e300}) {
    std::array<double, 3> p{x, 2 * x, 3 * x};
    for (double& c : p) c = nearest_binary32(c);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const mpq_class exact = exact_value(static_cast<double>(i + 1) * x);
      EXPECT_EQ(p[i], static_cast<double>(round_binary32(exact))) << x;
    }
  }
}

}  // namespace
}  // namespace fathom::kernels
