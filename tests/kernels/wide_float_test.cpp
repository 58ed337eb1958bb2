// SPDX-License-Identifier: GPL-3.0-or-later
// Wide floats against rationals: every operation within a unit, in every rounding mode.
#include "kernels/number/wide_float.hpp"

#include <gtest/gtest.h>

#include "tests/support/exact_floats.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

class WideFloats : public ::testing::Test {
 protected:
  mpz_class integer(unsigned long bits) {
    const mpz_class n = random_.get_z_bits(bits);
    return small_() & 1 ? n : mpz_class(-n);
  }
  // Any sign and size, with few or many digits, 0 at times; sometimes all digits are 0, or all are
  // 1.
  WideFloat any() {
    const unsigned long bits = 1 + small_() % 140;
    mpz_class n = integer(bits);
    if (small_() % 8 == 0) n = (mpz_class(1) << bits) - static_cast<long>(small_() % 3);
    return WideFloat::scaled(n, static_cast<long>(small_() % 200) - 50);
  }
  // Near another one, so that the difference cancels.
  WideFloat near(const WideFloat& x) { return x * (1 + any() * std::ldexp(1, -static_cast<int>(small_() % 140))); }

  std::uint64_t below(std::uint64_t n) { return small_() % n; }

 private:
  gmp_randclass random_{gmp_randinit_default};
  Random small_{7};
};

// |computed - exact| <= unit |exact|, so a computed 0 is exact.
void expect_within_a_unit(const WideFloat& computed, const mpq_class& exact, const char* what) {
  EXPECT_LE(abs(mpq_class(exactly(computed) - exact)), abs(exact) * mpq_class(WideFloat::unit)) << what << " " << exact;
}

TEST_F(WideFloats, EveryOperationIsWithinAUnit) {
  for (int n = 0; n < 40000; ++n) {
    const WideFloat a = any(), b = below(2) ? any() : near(a);
    const mpq_class x = exactly(a), y = exactly(b);
    WideFloat sum, difference, product, quotient, root;
    {
      const RoundingMode mode(rounding_modes[n % 4]);
      sum = a + b;
      difference = a - b;
      product = a * b;
      if (b.sign() != 0) quotient = a / b;
      root = sqrt(abs(a));
    }
    expect_within_a_unit(sum, x + y, "sum");
    expect_within_a_unit(difference, x - y, "difference");
    expect_within_a_unit(product, x * y, "product");
    if (y != 0) expect_within_a_unit(quotient, x / y, "quotient");
    // |r - sqrt(x)| <= unit sqrt(x), by squares.
    const mpq_class r = exactly(root), low = 1 - mpq_class(WideFloat::unit), high = 1 + mpq_class(WideFloat::unit);
    EXPECT_TRUE(low * low * abs(x) <= r * r && r * r <= high * high * abs(x)) << "root " << x;
    EXPECT_EQ(exactly(-a), -x);
    EXPECT_EQ(exactly(abs(a)), abs(x));
    EXPECT_EQ(a.sign(), sgn(x));
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a <= b, x <= y);
    EXPECT_EQ(a > b, x > y);
    EXPECT_EQ(a >= b, x >= y);
    EXPECT_EQ(a == b, x == y);
  }
}

// A unit is not far more than it must be: a filter would be sound with any larger one.
TEST_F(WideFloats, ProductsKeep118Digits) {
  mpq_class worst;
  for (int n = 0; n < 2000; ++n) {
    const WideFloat a = any(), b = any();
    const mpq_class exact = exactly(a) * exactly(b);
    if (exact != 0) worst = std::max(worst, mpq_class(abs(mpq_class(exactly(a * b) - exact)) / abs(exact)));
  }
  EXPECT_LT(worst, mpq_class(WideFloat::unit) / 4);
  EXPECT_GT(worst, mpq_class(WideFloat::unit) / 64);
}

TEST_F(WideFloats, IntegersAreTruncatedTo122Bits) {
  for (const unsigned long bits :
       {1UL, 53UL, 63UL, 64UL, 65UL, 121UL, 122UL, 123UL, 127UL, 128UL, 129UL, 190UL, 193UL, 700UL}) {
    for (int n = 0; n < 200; ++n) {
      const mpz_class c = integer(bits);
      const auto size = static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2));
      mpz_class kept = c;
      if (size > 122) {
        const auto cut = static_cast<mp_bitcnt_t>(size - 122);
        mpz_tdiv_q_2exp(kept.get_mpz_t(), c.get_mpz_t(), cut);
        kept <<= cut;
      }
      EXPECT_EQ(exactly(WideFloat::scaled(c, 0)), kept);
      EXPECT_EQ(exactly(WideFloat::scaled(c, 3)), mpq_class(kept) / 8);
      EXPECT_EQ(exactly(WideFloat::scaled(c, -5)), mpq_class(kept) * 32);
    }
  }
}

TEST_F(WideFloats, DoublesComeAndGo) {
  for (const double x : {0.0, 1.0, -1.0, 1.0 / 3, -0x1.fffffffffffffp-5, 0x1p-700, 0x1p800}) {
    for (int n = 0; n < 4; ++n) {
      const RoundingMode mode(rounding_modes[n]);
      EXPECT_EQ(WideFloat(x).truncated(), x);
    }
    EXPECT_EQ(exactly(WideFloat(x)), mpq_class(x));
  }
  const WideFloat third = WideFloat(1) / 3;
  EXPECT_EQ(third.truncated(), 0x1.5555555555555p-2);
  EXPECT_EQ((-third).truncated(), -0x1.5555555555555p-2);
  EXPECT_EQ(WideFloat::scaled(1, 902).truncated(), 0);
  EXPECT_EQ(WideFloat::scaled(-3, -2000).truncated(), -infinite);
}

}  // namespace
}  // namespace fathom::kernels
