// SPDX-License-Identifier: GPL-3.0-or-later
// Integers in place against GMP's.
#include "kernels/number/fixed_integer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/filters/rounded_plane.hpp"
#include "kernels/predicates/direction.hpp"
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

}  // namespace
}  // namespace fathom::kernels
