// SPDX-License-Identifier: GPL-3.0-or-later
// A sign that is sure is right, in every rounding mode; and in general position it is sure.
#include <gtest/gtest.h>

#include <functional>

#include "kernels/predicates/direction.hpp"
#include "tests/support/line_scenes.hpp"
#include "tests/support/signs.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

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
    EXPECT_TRUE(within_half_an_ulp(d.x, v.x, exponent) && within_half_an_ulp(d.y, v.y, exponent) && within_half_an_ulp(d.z, v.z, exponent));
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
    const Vector d1 = random_direction(random, bits), n = random_direction(random, bits), v = random_direction(random, bits);
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
