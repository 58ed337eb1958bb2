// SPDX-License-Identifier: GPL-3.0-or-later
// What the rounded plane says for certain, against exact arithmetic, in every rounding mode; and
// that it says so often enough.
#include "kernels/filters/rounded_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/filters/support.hpp"
#include "kernels/predicates/direction.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using testing::random_integer;
using testing::random_vector;
using testing::rounding_modes;
using testing::RoundingMode;
using Random = std::mt19937_64;

/// Four points of some number of bits; the last often nearly or exactly in the plane of the others,
/// which are often close together.
std::array<Vector, 4> four_points(Random& random, unsigned long bits) {
  std::array<Vector, 4> p{random_vector(random, bits), random_vector(random, bits), random_vector(random, bits),
                          random_vector(random, bits)};
  if (random() % 3 == 0) {
    const unsigned long fine = 1 + random() % bits;
    for (std::size_t i = 1; i < 4; ++i) p[i] = p[0] + random_vector(random, fine);
  }
  if (random() % 4 == 0) {  // so near to p[0] that the images almost agree
    p[3] = p[0] + random_vector(random, bits > 55 ? bits - 55 + random() % 8 : 1);
  } else if (random() % 2 == 0) {
    p[3] = p[0] + p[1] - p[2];
    if (random() % 2 == 0) p[3].z += random_integer(random, 1 + random() % bits);
  }
  return p;
}

TEST(RoundedPlane, SaysNoSideThatIsWrong) {
  Random random(7);
  std::size_t sure = 0, zero = 0, generic_unsure = 0;
  for (int i = 0; i < 40000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = i % 3 == 0 ? 5 : i % 3 == 1 ? 60 : 700;
    const std::array<Vector, 4> p = four_points(random, bits);
    const auto at = [&](int k) { return image(p[k], static_cast<long>(bits)); };
    const std::optional<Sign> said = RoundedPlane(at(0), at(1), at(2)).side(at(3));
    const int exact = sgn(det(Vector(p[1] - p[0]), Vector(p[2] - p[0]), Vector(p[3] - p[0])));
    if (said) {
      ASSERT_EQ(to_int(*said), exact) << i;
      ++sure;
    }
    if (exact == 0) ++zero;
    const std::array<Vector, 4> g{random_vector(random, bits), random_vector(random, bits), random_vector(random, bits),
                                  random_vector(random, bits)};
    const auto plain = [&](int k) { return image(g[k], static_cast<long>(bits)); };
    if (bits == 60 && RoundedPlane(plain(0), plain(1), plain(2)).side(plain(3)) == std::nullopt) ++generic_unsure;
  }
  EXPECT_GT(sure, 15000U);
  EXPECT_GT(zero, 5000U);
  EXPECT_LT(generic_unsure, 10U) << "of 13333";
}

TEST(RoundedPlane, SurelyBeyondIsNeverWrongAndRarelyMissed) {
  Random random(8);
  std::size_t beyond = 0, missed = 0;
  for (int i = 0; i < 20000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = i % 2 == 0 ? 60 : 700;
    const std::array<Vector, 4> p = four_points(random, bits);
    const Vector n = cross(Vector(p[1] - p[0]), Vector(p[2] - p[0]));
    const mpz_class height = dot(n, p[0]), square = dot(n, n);
    if (square == 0 || height == 0) continue;
    const auto at = [&](int k) { return image(p[k], static_cast<long>(bits)); };
    const RoundedPlane plane(at(0), at(1), at(2));
    // The radius of the plane itself: it is not beyond that. A little less: it is, if O is below.
    const double radius = root_from_above(height * height, square, static_cast<long>(bits));
    ASSERT_FALSE(plane.surely_beyond(radius)) << i;
    if (height < 0) {
      ASSERT_FALSE(plane.surely_beyond(0)) << i;
      continue;
    }
    const bool said = plane.surely_beyond(radius * 0.99);
    if (plane.trustworthy()) ++(said ? beyond : missed);
  }
  EXPECT_GT(beyond, 5000U);
  EXPECT_LT(missed, beyond / 10);
}

TEST(RoundedPlane, ImagesAreNear) {
  Random random(9);
  for (int i = 0; i < 5000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = 1 + random() % 900;
    const Vector v = random_vector(random, bits);
    const double x = image(v, static_cast<long>(bits)).x;
    const mpq_class difference = mpq_class(x) - mpq_class(v.x, testing::power_of_two(bits));
    ASSERT_LE(abs(difference), mpq_class(1, testing::power_of_two(52)));
  }
}

TEST(RootFromAbove, IsAboveAndNear) {
  Random random(10);
  for (int i = 0; i < 5000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const mpz_class numerator = abs(random_integer(random, 1 + random() % 400)),
                    denominator = abs(random_integer(random, 1 + random() % 400)) + 1;
    const double root = root_from_above(numerator, denominator, 0);
    ASSERT_TRUE(std::isfinite(root));
    const mpq_class square = mpq_class(root) * mpq_class(root);
    mpq_class truth(numerator, denominator);
    truth.canonicalize();
    ASSERT_GE(square, truth);
    ASSERT_LE(square, truth * mpq_class(1001, 1000));
  }
  EXPECT_EQ(root_from_above(0, 1, 5), 0);
  EXPECT_GE(root_from_above(testing::power_of_two(4000), 1, 0), 1e300) << "too large for binary64: infinite";
  EXPECT_GT(root_from_above(1, testing::power_of_two(6000), 0), 0) << "too small: not zero";
}

TEST(LikelyExtremePoint, IsExtremeWhereNothingTies) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector> points(1 + random() % 700);
    for (Vector& p : points) p = random_vector(random, 40);
    const PointCloud cloud(points, binary_exponent(points));
    const Vector u = testing::random_direction(random, 20);
    const std::uint32_t found = likely_extreme_point(cloud.images(), image(u, 20));
    EXPECT_EQ(found, extreme_points_naive(points, u).front());
  }
  EXPECT_EQ(likely_extreme_point(PointCloud({{1, 2, 3}, {4, 5, 6}}).images(), {0, 0, 0}), 0U);
}

}  // namespace
}  // namespace fathom::kernels
