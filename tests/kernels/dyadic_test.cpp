// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/number/dyadic.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "fathom/numbers.hpp"

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
  for (const auto& [numerator, denominator] : {std::pair{0L, 1UL}, {12L, 1UL}, {-7L, 8UL}, {INT64_MAX, 2UL}, {-INT64_MAX, 1UL}}) {
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

}  // namespace
}  // namespace fathom::kernels
