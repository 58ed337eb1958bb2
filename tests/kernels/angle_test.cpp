// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <utility>

#include "kernels/number/irrational.hpp"

namespace fathom::kernels {
namespace {

/// Two neighbouring sums of Taylor's series, between which the cosine or sine of x lies for 0 < x < 2.
std::pair<mpq_class, mpq_class> naive(const mpq_class& x, bool sine) {
  mpq_class term = sine ? x : mpq_class(1), sum = term, before;
  for (unsigned k = sine ? 1 : 0; k < 60; k += 2) {
    term *= -x * x / ((k + 1) * (k + 2));
    before = sum;
    sum += term;
  }
  return sum < before ? std::pair(sum, before) : std::pair(before, sum);
}

/// Half the distance of two numbers of 53 bits near `value`, or of those below it if it is a power of two.
mpq_class half_ulp(const mpq_class& value) {
  mpq_class ulp(1);
  while (ulp > abs(value)) ulp /= 2;
  while (ulp * 2 <= abs(value)) ulp *= 2;
  return ulp / (mpz_class(1) << 53);
}

void expect_nearest(const mpq_class& value, const std::pair<mpq_class, mpq_class>& bounds) {
  const mpz_class odd = value.get_num() >> mpz_scan1(value.get_num_mpz_t(), 0);
  EXPECT_LE(mpz_sizeinbase(odd.get_mpz_t(), 2), 53U);
  const mpq_class slack = half_ulp(value);
  EXPECT_LE(abs(mpq_class(value - bounds.first)), slack);
  EXPECT_LE(abs(mpq_class(value - bounds.second)), slack);
}

TEST(Angle, IsCorrectlyRoundedAsTaylorSays) {
  for (int i = 1; i < 200; ++i) {
    const mpq_class x(i, 101);
    const CosineAndSine found = cosine_and_sine(x, AngleUnit::radians);
    expect_nearest(found.cosine, naive(x, false));
    expect_nearest(found.sine, naive(x, true));
  }
  const mpq_class tiny(1, mpz_class(1) << 2000);
  expect_nearest(cosine_and_sine(tiny, AngleUnit::radians).sine, naive(tiny, true));
  EXPECT_EQ(cosine_and_sine(tiny, AngleUnit::radians).cosine, 1);
}

TEST(Angle, IsExactWhereItCanBe) {
  const mpq_class half(1, 2);
  const std::pair<int, std::pair<mpq_class, mpq_class>> exactly[] = {{0, {1, 0}},    {90, {0, 1}},  {180, {-1, 0}},     {270, {0, -1}},
                                                                     {-90, {0, -1}}, {360, {1, 0}}, {36000090, {0, 1}}, {-180, {-1, 0}}};
  for (const auto& [degrees, expected] : exactly) {
    const CosineAndSine found = cosine_and_sine(degrees, AngleUnit::degrees);
    EXPECT_EQ(std::pair(found.cosine, found.sine), expected) << degrees;
  }
  EXPECT_EQ(cosine_and_sine(60, AngleUnit::degrees).cosine, half);
  EXPECT_EQ(cosine_and_sine(240, AngleUnit::degrees).cosine, -half);
  EXPECT_EQ(cosine_and_sine(150, AngleUnit::degrees).sine, half);
  EXPECT_EQ(cosine_and_sine(-30, AngleUnit::degrees).sine, -half);
  EXPECT_EQ(cosine_and_sine(0, AngleUnit::radians).cosine, 1);
  EXPECT_EQ(cosine_and_sine(0, AngleUnit::radians).sine, 0);
}

TEST(Angle, OfDegreesHasTheSymmetriesOfTheCircle) {
  for (int i = -400; i < 800; i += 7) {
    const mpq_class angle(i, 3);
    const CosineAndSine here = cosine_and_sine(angle, AngleUnit::degrees), there = cosine_and_sine(90 - angle, AngleUnit::degrees),
                        back = cosine_and_sine(-angle, AngleUnit::degrees), again = cosine_and_sine(angle + 720, AngleUnit::degrees);
    EXPECT_EQ(here.cosine, there.sine) << i;
    EXPECT_EQ(here.cosine, back.cosine) << i;
    EXPECT_EQ(here.sine, -back.sine) << i;
    EXPECT_EQ(here.sine, again.sine) << i;
    const mpq_class one = here.cosine * here.cosine + here.sine * here.sine;
    EXPECT_LT(abs(mpq_class(one - 1)), mpq_class(1, mpz_class(1) << 51)) << i;
  }
}

}  // namespace
}  // namespace fathom::kernels
