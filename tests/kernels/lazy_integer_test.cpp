// SPDX-License-Identifier: GPL-3.0-or-later
// Wide enclosures against the numbers that they enclose, and lazy integers against GMP's: above all
// where digits cancel, and where a number lies as near to a border as its enclosure can tell.
#include "kernels/number/lazy_integer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "kernels/predicates/direction.hpp"
#include "tests/support/exact_floats.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using testing::exactly;
using testing::power_of_two;
using testing::rounding_modes;
using testing::RoundingMode;
using Random = std::mt19937_64;

/// Of any length and sign, with few digits, many, or a gap between the first and the last ones.
mpz_class any_integer(Random& random) {
  const unsigned long bits = random() % 400;
  mpz_class n = testing::random_integer(random, 1 + random() % 60);
  switch (random() % 4) {
    case 0: return testing::random_integer(random, bits);
    case 1: return n << bits;
    case 2: return (n << bits) + static_cast<long>(random() % 3) - 1;
    default: return n;
  }
}

void expect_encloses(const WideEnclosure& x, const mpz_class& n) {
  const mpq_class apart = abs(mpq_class(exactly(x.value()) - n));
  if (x.error() < -1000) {
    ASSERT_EQ(apart, 0) << n;
  } else {
    ASSERT_LE(apart, x.error() < 0 ? mpq_class(1, power_of_two(static_cast<unsigned long>(-x.error())))
                                   : mpq_class(power_of_two(static_cast<unsigned long>(x.error()))))
        << n;
  }
  ASSERT_LE(bit_length(n), std::max<std::int64_t>(x.order(), 0));
  if (const auto sure = x.sign()) {
    ASSERT_EQ(to_int(*sure), sgn(n));
  }
  if (const auto sure = x.leading()) {
    const Leading exact = leading(n.get_mpz_t());
    ASSERT_EQ(sure->mantissa, exact.mantissa) << n;
    ASSERT_EQ(sure->exponent, exact.exponent) << n;
  }
}

TEST(WideEnclosures, HoldWhatIsComputed) {
  Random random(1);
  std::uint64_t signs = 0, unsure_signs = 0, leadings = 0;
  for (int i = 0; i < 20000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    mpz_class n = any_integer(random);
    WideEnclosure x(n);
    for (int step = 0; step < 6 && !::testing::Test::HasFatalFailure(); ++step) {
      expect_encloses(x, n);
      ++signs;
      unsure_signs += x.sign() ? 0U : 1U;
      leadings += x.leading() ? 1U : 0U;
      const mpz_class m = random() % 3 == 0 ? mpz_class(n + any_integer(random)) : any_integer(random);
      const WideEnclosure y(m);
      expect_encloses(WideEnclosure::of_difference(x, n, y, m), n - m);
      switch (random() % 3) {
        case 0: x = x + y, n += m; break;
        case 1: x = x - y, n -= m; break;
        default: x = -x * y, n = -n * m;
      }
    }
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << i;
  }
  EXPECT_LT(unsure_signs, signs / 8);
  EXPECT_GT(unsure_signs, signs / 20) << "digits hardly ever cancel";
  EXPECT_GT(leadings, signs * 2 / 3);
}

/// Numbers of 201 bits whose enclosures err by `error` at most: the bits after the first 53 must
/// amount to so much, and so much must be missing from the next number of 53 bits.
TEST(WideEnclosures, KnowTheFirstBitsUpToTheLastPlace) {
  const mpz_class base = power_of_two(200), gap = power_of_two(148), place = power_of_two(79);
  const WideEnclosure noise = WideEnclosure(mpz_class(base + 1)) - WideEnclosure(base);
  ASSERT_FALSE(noise.sign()) << "not exact: it stands for the error";
  const mpz_class error = power_of_two(static_cast<unsigned long>((WideEnclosure(base) + noise).error()));
  ASSERT_LE(error, 256 * place);
  for (const auto& [n, known] : std::vector<std::pair<mpz_class, bool>>{{base, false},
                                                                        {base + error - place, false},
                                                                        {base + error, true},
                                                                        {base + gap - error - place, true},
                                                                        {base + gap - error, false},
                                                                        {base + gap, false},
                                                                        {base + gap + error, true}}) {
    const WideEnclosure x = WideEnclosure(n) + noise;
    EXPECT_EQ(x.leading().has_value(), known) << n;
    EXPECT_EQ((-x).leading().has_value(), known) << n;
    expect_encloses(x, n + 1);
  }
}

TEST(WideEnclosures, KnowExactZeros) {
  const mpz_class n = (power_of_two(100) + 1) << 900, m = 3 * power_of_two(2000);
  EXPECT_EQ((WideEnclosure(n) - WideEnclosure(n)).sign(), Sign::zero);
  EXPECT_EQ((WideEnclosure(n) * WideEnclosure()).sign(), Sign::zero);
  EXPECT_EQ((WideEnclosure(m) * WideEnclosure(m) - WideEnclosure(mpz_class(m * m))).sign(), Sign::zero);
  const mpz_class longer = n * n + 1;
  EXPECT_FALSE((WideEnclosure(longer) - WideEnclosure(longer)).sign());
}

Vec3<LazyInteger> lazy(const Vector& v) { return {LazyInteger(v.x), LazyInteger(v.y), LazyInteger(v.z)}; }
Vector to_exact(const Vec3<LazyInteger>& v) { return {v.x.exact(), v.y.exact(), v.z.exact()}; }

void expect_same_number(const LazyInteger& x, const mpz_class& n, const LazyInteger& y, const mpz_class& m) {
  ASSERT_EQ(sgn(x), sgn(n));
  ASSERT_EQ(sign_of(cmp(x, y)), sign_of(cmp(n, m)));
  ASSERT_EQ(x == y, n == m);
  ASSERT_EQ(image(x, bit_length(n)), image(n, bit_length(n)));
  ASSERT_EQ(image(x, bit_length(n) + 499), image(n, bit_length(n) + 499));
  ASSERT_EQ(image(x, bit_length(n) + 501), image(n, bit_length(n) + 501));
  if (m != 0) {
    ASSERT_EQ(root_from_above(x * x, y * y, 3), root_from_above(mpz_class(n * n), mpz_class(m * m), 3));
  }
  ASSERT_EQ(x.exact(), n);
  ASSERT_EQ(sgn(x), sgn(n)) << "once it is known";
}

TEST(LazyIntegers, AreThoseOfGmp) {
  Random random(2);
  for (int i = 0; i < 4000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    std::vector<std::pair<LazyInteger, mpz_class>> numbers;
    for (int k = 0; k < 3; ++k) {
      const mpz_class n = any_integer(random);
      numbers.emplace_back(n, n);
    }
    for (int k = 0; k < 6; ++k) {
      const auto [x, n] = numbers[random() % numbers.size()];
      const auto [y, m] = numbers[random() % numbers.size()];
      switch (random() % 4) {
        case 0: numbers.emplace_back(x + y, n + m); break;
        case 1: numbers.emplace_back(x - y, n - m); break;
        case 2: numbers.emplace_back(-x, -n); break;
        default: numbers.emplace_back(x * y, n * m);
      }
    }
    for (const auto& [x, n] : numbers) {
      const auto& [y, m] = numbers[random() % numbers.size()];
      expect_same_number(x, n, y, m);
      ASSERT_FALSE(::testing::Test::HasFatalFailure()) << i;
    }
  }
}

TEST(LazyIntegers, MakeTheSameVectors) {
  Random random(3);
  const auto any_vector = [&] { return Vector{any_integer(random), any_integer(random), any_integer(random)}; };
  for (int i = 0; i < 4000; ++i) {
    const Vector u = any_vector(), v = i % 5 == 0 ? Vector(3 * u) : any_vector();
    // Points that are all near one another, or near one line, as seen from O.
    const Vector far = i % 2 == 0 ? any_vector() : Vector{0, 0, 0};
    const Vector p = far + u, q = far + v, r = far + any_vector();
    EXPECT_EQ(dot(lazy(u), lazy(v)).exact(), dot(u, v));
    EXPECT_EQ(to_exact(cross(lazy(u), lazy(v))), cross(u, v));
    EXPECT_EQ(is_zero(cross(lazy(u), lazy(v))), is_zero(cross(u, v)));
    EXPECT_EQ(bit_length(cross(lazy(u), lazy(v))), bit_length(cross(u, v)));
    EXPECT_EQ(order_along(lazy(u), lazy(p), lazy(q)), sgn(dot(u, p - q)));
    const auto [normal, height] = plane_through(lazy(p), lazy(q), lazy(r));
    const Vector n = cross(q - p, r - p);
    for (const auto& [found, exact] : {std::pair(normal.x, n.x), std::pair(normal.y, n.y), std::pair(normal.z, n.z)})
      expect_encloses(found.enclosure(), exact);
    expect_encloses(height.enclosure(), dot(n, p));
    EXPECT_EQ(to_exact(normal), n);
    EXPECT_EQ(height.exact(), dot(n, p));
    ASSERT_FALSE(::testing::Test::HasFailure()) << i;
  }
}

/// Points with coordinates of all sizes about a corner far from O: nothing is left to integers,
/// though all of the corner's digits cancel.
TEST(LazyIntegers, AreHardlyComputedWhereDifferencesDecide) {
  Random random(4);
  const auto any_size = [&] { return mpz_class(testing::random_integer(random, 20) << (random() % 1000)); };
  std::uint64_t asked = 0;
  const std::uint64_t before = LazyInteger::computed();
  for (int i = 0; i < 1000; ++i) {
    const Vector far{power_of_two(3000) + 1, 3 * power_of_two(2500), power_of_two(2600) + 5};
    std::vector<Vec3<LazyInteger>> points;
    for (int k = 0; k < 3; ++k) points.push_back(lazy(far + Vector{any_size(), any_size(), any_size()}));
    const auto [normal, height] = plane_through(points[0], points[1], points[2]);
    for (const LazyInteger* c : {&normal.x, &normal.y, &normal.z}) asked += static_cast<std::uint64_t>(sgn(*c) != 0);
  }
  EXPECT_GT(asked, 2900U);
  EXPECT_LT(LazyInteger::computed() - before, 40U);
}

}  // namespace
}  // namespace fathom::kernels
