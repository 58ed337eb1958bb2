// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures against exact rationals: they hold the value, and are as narrow as stated.

#include "kernels/predicates/direction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/line_scenes.hpp"
#include "tests/support/property.hpp"
#include "tests/support/signs.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

constexpr double inf = std::numeric_limits<double>::infinity();

std::size_t bits(const mpz_class& c) { return c == 0 ? 0 : mpz_sizeinbase(c.get_mpz_t(), 2); }

std::size_t significant_bits(const mpz_class& c) { return c == 0 ? 0 : bits(c) - mpz_scan1(c.get_mpz_t(), 0); }

/// c * 2^-shift.
mpq_class scaled(const mpz_class& c, std::size_t shift) {
  mpq_class r(c, power_of_two(shift));
  r.canonicalize();
  return r;
}

bool encloses(const DoubleInterval& e, const mpq_class& value) {
  return mpq_class(e.low) <= value && value <= mpq_class(e.high);
}

/// How many numbers lie in the enclosure: 4 stands for more than 3.
int width(const DoubleInterval& e) {
  int n = 1;
  for (double x = e.low; x != e.high && n < 4; x = std::nextafter(x, inf)) ++n;
  return n;
}

/// Checks all that enclose() promises, component by component.
void expect_enclosed(const Vector& v) {
  const Vec3<DoubleInterval> e = enclose(v);
  const std::size_t shift = std::max({bits(v.x), bits(v.y), bits(v.z)});
  double largest = 0;
  for (const auto& [c, x] : {std::pair(v.x, e.x), std::pair(v.y, e.y), std::pair(v.z, e.z)}) {
    const mpq_class value = scaled(c, shift);
    ASSERT_TRUE(encloses(x, value)) << v << ": " << x.low << " to " << x.high;
    const bool normal = abs(value) >= mpq_class(std::numeric_limits<double>::min());
    const bool exact = c == 0 || (normal && significant_bits(c) <= 53);
    ASSERT_EQ(width(x), exact ? 1 : normal ? 2 : 3) << v << ": " << x.low << " to " << x.high;
    largest = std::max(largest, std::max(std::abs(x.low), std::abs(x.high)));
  }
  EXPECT_GE(largest, 0.5) << v;
  EXPECT_LE(largest, 1) << v;
}

TEST(Enclose, HoldsTheVectorTimesOnePowerOfTwo) {
  for (const Size size : all_sizes)
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] { expect_enclosed(*directions(size)); })) << name(size);
}

TEST(Enclose, IsSymmetricAboutZero) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Vector v = *directions(Size::mixed);
    const Vec3<DoubleInterval> e = enclose(v), m = enclose(-v);
    RC_ASSERT(e.x.low == -m.x.high && e.x.high == -m.x.low && e.z.low == -m.z.high);
  }));
}

TEST(Enclose, IsAPointUpToFiftyThreeBits) {
  const mpz_class full = power_of_two(53) - 1;
  for (const mpz_class& c : {mpz_class(1), mpz_class(-3), full, mpz_class(full << 900), mpz_class(-full << 13)}) {
    const Vector v{c, 0, 1};
    EXPECT_EQ(width(enclose(v).x), 1) << c;
    expect_enclosed(v);
  }
  for (const mpz_class& c : {mpz_class(full + 2), mpz_class((full << 1) + 1), mpz_class(power_of_two(900) + 1)}) {
    EXPECT_EQ(width(enclose(Vector{c, 0, 1}).x), 2) << c;
    expect_enclosed(Vector{c, 0, 1});
    expect_enclosed(Vector{mpz_class(-c), 0, 1});
  }
  EXPECT_EQ(enclose(Vector{full, 0, 0}).x.low, 1 - 0x1p-53);
  EXPECT_EQ(enclose(Vector{-power_of_two(70), 0, 0}).x.high, -0.5);
}

// Components at every distance around the end of the normal and of the subnormal range, with
// mantissas that round in every way.
TEST(Enclose, HoldsWhatFallsBelowTheNormalRange) {
  const mpz_class mantissas[] = {1,
                                 3,
                                 power_of_two(52) + 1,
                                 power_of_two(53) - 1,
                                 power_of_two(54) - 1,
                                 power_of_two(80) - 1,
                                 power_of_two(80) + 1,
                                 (power_of_two(52) - 1) << 20};
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    for (const mpz_class& m : mantissas) {
      for (unsigned long top = 1000; top < 1160; ++top) expect_enclosed(Vector{power_of_two(top), m, mpz_class(-m)});
    }
    expect_enclosed(Vector{power_of_two(5000), 1, -7});
  }
  std::fesetround(FE_TONEAREST);
}

// 2^53 - 1 scaled to just below the least normal number, to which ldexp rounds it up.
TEST(Enclose, DoesNotTakeARoundedNumberForAnExactOne) {
  const DoubleInterval e = enclose(Vector{power_of_two(1074), power_of_two(53) - 1, 0}).y;
  EXPECT_LT(e.low, std::numeric_limits<double>::min());
  expect_enclosed(Vector{power_of_two(1074), power_of_two(53) - 1, 0});
}

TEST(Direction, KeepsTheExactVector) {
  const Vector v{power_of_two(300) + 1, -1, 0};
  const Direction d(v);
  EXPECT_EQ(d.exact(), v);
  EXPECT_EQ(d.enclosure().x.low, 0.5);
  EXPECT_EQ(d.enclosure().x.high, std::nextafter(0.5, 1));
  EXPECT_EQ(d.enclosure().z.low, 0);
}

// A sign that is sure is right, in every rounding mode; and in general position it is sure.

struct Tally {
  int sure = 0, unsure = 0;
};

void expect_right(Tally& tally, int exact, const std::function<std::optional<Sign>()>& approximate) {
  for (const int mode : rounding_modes) {
    const std::optional<Sign> sign = [&] {
      const RoundingMode set(mode);
      return approximate();
    }();
    EXPECT_TRUE(!sign || to_int(*sign) == exact) << to_int(*sign) << " for " << exact;
    ++(sign ? tally.sure : tally.unsure);
  }
}

Vector add(const Vector& v, const Vector& step) { return v + step; }

// |image - value * 2^-exponent| < 2^-53, exactly.
bool within_half_an_ulp(double image, const mpz_class& value, long exponent) {
  const mpq_class scaled = mpq_class(value) / (mpz_class(1) << static_cast<mp_bitcnt_t>(exponent));
  return abs(mpq_class(mpq_class(image) - scaled)) < mpq_class(1, mpz_class(1) << 53);
}

TEST(Images, AreTruncatedAndOdd) {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const auto bits = static_cast<unsigned long>(below(random, 1200) + 1);
    const Vector v = random_direction(random, bits);
    const Vec3<double> d = direction_image(v), minus = direction_image(-v);
    EXPECT_TRUE(largest(d) >= 0.5 && largest(d) <= 1);
    EXPECT_TRUE(minus.x == -d.x && minus.y == -d.y && minus.z == -d.z);
    const auto exponent = static_cast<long>(testing::bits(v));
    EXPECT_TRUE(within_half_an_ulp(d.x, v.x, exponent) && within_half_an_ulp(d.y, v.y, exponent) &&
                within_half_an_ulp(d.z, v.z, exponent));
  }
  EXPECT_EQ(image(mpz_class(1), 499), std::ldexp(1.0, -499));
  EXPECT_EQ(image(mpz_class(1), 600), 0) << "no product of two underflows";
  const mpz_class long_one = (mpz_class(1) << 60) - 1;
  EXPECT_LT(image(long_one, 60), 1) << "truncated, not rounded";
  EXPECT_GT(image(mpz_class(-long_one), 60), -1);
}

// Normal to d except for a multiple of some power of two: values on both sides of the error bound.
TEST(Images, SureSidesAreRight) {
  std::mt19937_64 random(3);
  Tally near, far;
  for (int i = 0; i < 4000; ++i) {
    const unsigned long bits = 20 + random() % 200;
    const Vector d = random_direction(random, bits), e = random_direction(random, bits);
    const Vector n = add(cross(d, e), random_vector(random, 1 + random() % (2 * bits)));
    if (is_zero(n)) continue;
    const Direction of_n(n), of_d(d), of_e(e);
    expect_right(near, sgn(dot(n, d)), [&] { return sure_side_of_arc(image(of_n), image(of_d)); });
    expect_right(near, -sgn(dot(n, d)), [&] { return sure_side_of_arc(image(of_n), -image(of_d)); });
    expect_right(far, sgn(dot(e, d)), [&] { return sure_side_of_arc(image(of_e), image(of_d)); });
  }
  EXPECT_GT(near.sure, 1000);
  EXPECT_GT(near.unsure, 1000);
  EXPECT_LT(1000 * far.unsure, far.sure);
}

// d2 differs little from d1, or its circle nearly passes d1's point on the vertical.
TEST(Images, SureOrdersOnAVerticalAreRight) {
  std::mt19937_64 random(4);
  Tally near, far;
  for (int i = 0; i < 4000; ++i) {
    const unsigned long bits = 20 + random() % 100;
    const Vector d1 = random_direction(random, bits), n = random_direction(random, bits),
                 v = random_direction(random, bits);
    const Vector step = random_vector(random, 1 + random() % (3 * bits)), e = random_direction(random, bits);
    const Vector c = mpz_class(dot(d1, v)) * n - mpz_class(dot(d1, n)) * v;
    const Vector close = random() & 1 ? add(mpz_class(power_of_two(2 * bits)) * d1, step) : add(cross(c, e), step);
    if (is_zero(close)) continue;
    const auto check = [&](Tally& tally, const Vector& d2) {
      const int exact = unperturbed().order_on_vertical(Direction(d1), Direction(d2), Direction(n), Direction(v));
      EXPECT_EQ(exact, sgn(dot(c, d2)));
      expect_right(tally, exact, [&] {
        return VerticalProbe(image(Direction(d1)), image(Direction(n)), image(Direction(v))).sign(image(Direction(d2)));
      });
    };
    check(near, close);
    check(far, e);
  }
  EXPECT_GT(near.sure, 1000);
  EXPECT_GT(near.unsure, 1000);
  EXPECT_LT(1000 * far.unsure, far.sure);
}

}  // namespace
}  // namespace fathom::kernels
