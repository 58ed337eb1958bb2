// SPDX-License-Identifier: GPL-3.0-or-later
// Integers in place against GMP's.

#include "kernels/number/fixed_integer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/filters/plane.hpp"
#include "kernels/number/wide_float.hpp"
#include "kernels/predicates/direction.hpp"
#include "tests/support/exact_floats.hpp"
#include "tests/support/line_scenes.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using Fixed = FixedInteger<1024>;
using testing::power_of_two;
using testing::rounding_modes;
using testing::RoundingMode;
using Random = std::mt19937_64;

/// Of every length up to `bits`; often at the border of a limb, where carries run.
mpz_class some_integer(Random& random, unsigned long bits) {
  const unsigned long length = random() % (bits + 1);
  if (random() % 3 > 0) return testing::random_integer(random, length);
  mpz_class border = power_of_two(length / 64 * 64);
  border += static_cast<long>(random() % 3) - 1;
  if (random() % 4 == 0) border <<= random() % (bits - length + 1);
  return random() % 2 == 0 ? border : mpz_class(-border);
}

TEST(FixedInteger, ComputesAsGmpDoes) {
  Random random(1);
  for (int i = 0; i < 40000; ++i) {
    const mpz_class a = some_integer(random, i % 2 == 0 ? 70 : 500),
                    b = i % 7 == 0 ? a : some_integer(random, i % 3 == 0 ? 70 : 500);
    const Fixed x(a), y(b);
    ASSERT_EQ(x.to_mpz(), a);
    ASSERT_EQ(Fixed(x + y).to_mpz(), a + b) << a << " " << b;
    ASSERT_EQ(Fixed(x - y).to_mpz(), a - b) << a << " " << b;
    ASSERT_EQ(Fixed(x * y).to_mpz(), a * b) << a << " " << b;
    ASSERT_EQ(Fixed(-x).to_mpz(), -a);
    ASSERT_EQ(sgn(x), sgn(a));
    ASSERT_EQ(cmp(x, y) > 0, a > b);
    ASSERT_EQ(cmp(x, y) < 0, a < b);
    ASSERT_EQ(x == y, a == b);
    ASSERT_EQ(x.bit_length(), a == 0 ? 0 : static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2)));
    ASSERT_EQ(FixedInteger<640>(x).to_mpz(), a) << "a narrower type";
    if (x.bit_length() < 64) {
      ASSERT_EQ(x.to_word(), a.get_si());
    }
    if (a == 0) continue;
    ASSERT_EQ(x.trailing_zeros(), mpz_scan1(a.get_mpz_t(), 0));
    ASSERT_EQ(binary_exponent(x), binary_exponent(Vector{a, 0, 0}));
  }
}

TEST(FixedInteger, ShiftsWords) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const long value = static_cast<long>(random()) >> random() % 63;
    const unsigned shift = static_cast<unsigned>(random() % 900), part = static_cast<unsigned>(random() % (shift + 1));
    mpz_class expected = value;
    expected <<= shift;
    Fixed x = Fixed::shifted(value, shift);
    ASSERT_EQ(x.to_mpz(), expected);
    x.divide_by_power(part);
    expected >>= part;
    ASSERT_EQ(x.to_mpz(), expected);
  }
  EXPECT_EQ(Fixed(std::numeric_limits<long>::min()).to_mpz(), std::numeric_limits<long>::min());
}

TEST(FixedInteger, RefusesWhatItCannotHold) {
  const mpz_class most = power_of_two(1024) - 1;
  EXPECT_EQ(Fixed(most).to_mpz(), most);
  EXPECT_EQ(Fixed(Fixed(power_of_two(511)) * Fixed(power_of_two(512))).to_mpz(), power_of_two(1023));
  EXPECT_EQ(Fixed(Fixed(most) + Fixed(most)).to_mpz(), 2 * most) << "one limb is to spare";
  EXPECT_THROW(Fixed(most) * Fixed(most), std::overflow_error);
  EXPECT_THROW(Fixed(mpz_class(power_of_two(1024 + 64))), std::overflow_error);
  EXPECT_THROW(Fixed::shifted(1, 1024 + 64), std::overflow_error);
  const Fixed top(mpz_class(power_of_two(1024)));
  EXPECT_THROW(top + top, std::overflow_error);
  EXPECT_EQ(sgn(top - top), 0);
}

TEST(FixedImages, AreThoseOfGmpInEveryRoundingMode) {
  Random random(3);
  for (int i = 0; i < 40000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const mpz_class a = some_integer(random, 900);
    const long bits = a == 0 ? 0 : static_cast<long>(mpz_sizeinbase(a.get_mpz_t(), 2));
    const long exponent = std::max(0L, bits - 400 + static_cast<long>(random() % 1400));
    ASSERT_EQ(image(Fixed(a), exponent), image(a, exponent)) << a << " * 2^-" << exponent;
  }
}

TEST(FixedImages, OfDirectionsHaveASlackUnlessAllIsExact) {
  const Vec3<Fixed> u{Fixed(4), Fixed(-7), Fixed(0)};
  const DirectionImage exact = direction_image_for(u, 48);
  EXPECT_EQ(exact.slack, 0);
  EXPECT_EQ(exact.x, 0.5);
  EXPECT_EQ(exact.y, -0.875);
  EXPECT_GT(direction_image_for(u, 49).slack, 0);
}

TEST(FixedImages, RootsFromAboveAreThoseOfGmp) {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const mpz_class numerator = abs(some_integer(random, 800)), denominator = abs(some_integer(random, 800)) + 1;
    const long exponent = static_cast<long>(random() % 300);
    ASSERT_EQ(root_from_above(Fixed(numerator), Fixed(denominator), exponent),
              root_from_above(numerator, denominator, exponent));
  }
}

// Wide floats against rationals: every operation within a unit, in every rounding mode.

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
