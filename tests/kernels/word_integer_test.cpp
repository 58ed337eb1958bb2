// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of two and of four words against GMP's, up to their ends.
#include "kernels/number/word_integer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/filters/plane.hpp"
#include "kernels/predicates/direction.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using testing::power_of_two;
using Random = std::mt19937_64;

/// Below 2^bits in size, of every length; often around a power of 2 or of 2^64.
mpz_class some_short_integer(Random& random, long bits) {
  const auto length = static_cast<unsigned long>(random() % static_cast<std::uint64_t>(bits + 1));
  if (random() % 3 > 0) return testing::random_integer(random, length);
  const unsigned long power = random() % 2 == 0 ? length : length / 64 * 64;
  const mpz_class border = power_of_two(power) - 1 - static_cast<long>(power == 0 ? 0 : random() % 2);
  return random() % 2 == 0 ? border : mpz_class(-border);
}

template <class Integer>
class WordIntegers : public ::testing::Test {};
using Both = ::testing::Types<Integer127, Integer255>;
TYPED_TEST_SUITE(WordIntegers, Both, );

TYPED_TEST(WordIntegers, ComputeAsGmpDoes) {
  constexpr long most = TypeParam::most_bits;
  Random random(1);
  for (int i = 0; i < 40000; ++i) {
    const mpz_class a = some_short_integer(random, most - 1), b = i % 7 == 0 ? a : some_short_integer(random, most - 1);
    const TypeParam x(a), y(b);
    ASSERT_EQ(to_mpz(x), a);
    ASSERT_EQ(to_mpz(x + y), a + b) << a << " " << b;
    ASSERT_EQ(to_mpz(x - y), a - b) << a << " " << b;
    ASSERT_EQ(to_mpz(-x), -a);
    const mpz_class factor = some_short_integer(random, most - bit_length(a));
    ASSERT_EQ(to_mpz(x * TypeParam(factor)), a * factor) << a << " " << factor;
    ASSERT_EQ(sgn(x), sgn(a));
    ASSERT_EQ(cmp(x, y) > 0, a > b);
    ASSERT_EQ(cmp(x, y) < 0, a < b);
    ASSERT_EQ(x == y, a == b);
    ASSERT_EQ(x.bit_length(), bit_length(a));
    ASSERT_EQ(static_cast<FixedInteger<3072>>(x).to_mpz(), a);
    if (a.fits_slong_p()) {
      ASSERT_EQ(x.to_word(), a.get_si());
      ASSERT_EQ(TypeParam(a.get_si()), x);
    }
  }
}

TYPED_TEST(WordIntegers, HoldTheirEnds) {
  const mpz_class most = power_of_two(TypeParam::most_bits) - 1;
  const TypeParam top(most);
  EXPECT_EQ(to_mpz(top), most);
  EXPECT_EQ(to_mpz(-top), -most);
  EXPECT_EQ(sgn(-top), -1);
  EXPECT_GT(cmp(top, -top), 0);
  EXPECT_EQ(to_mpz(TypeParam(mpz_class(most / 2)) + TypeParam(mpz_class(most / 2 + 1))), most);
  EXPECT_EQ(to_mpz(top - top), 0);
  EXPECT_EQ(to_mpz(TypeParam(mpz_class(-most)) * TypeParam(1)), -most);
  const unsigned long half = (TypeParam::most_bits - 1) / 2;
  EXPECT_EQ(to_mpz(TypeParam(power_of_two(half)) * TypeParam(mpz_class(-power_of_two(half)))), -power_of_two(2 * half));
}

TYPED_TEST(WordIntegers, HaveTheImagesOfGmpInEveryRoundingMode) {
  Random random(3);
  for (int i = 0; i < 40000; ++i) {
    const testing::RoundingMode mode(testing::rounding_modes[i % 4]);
    const mpz_class a = some_short_integer(random, TypeParam::most_bits);
    const long exponent = std::max(bit_length(a), static_cast<long>(random() % 400));
    ASSERT_EQ(image(TypeParam(a), exponent), image(a, exponent)) << a << " * 2^-" << exponent;
  }
}

TYPED_TEST(WordIntegers, OfDirectionsHaveASlackUnlessAllIsExact) {
  const Vec3<TypeParam> u{TypeParam(4), TypeParam(-7), TypeParam(0)};
  const DirectionImage exact = direction_image_for(u, 48);
  EXPECT_EQ(exact.slack, 0);
  EXPECT_EQ(exact.x, 0.5);
  EXPECT_EQ(exact.y, -0.875);
  EXPECT_GT(direction_image_for(u, 49).slack, 0);
}

}  // namespace
}  // namespace fathom::kernels
