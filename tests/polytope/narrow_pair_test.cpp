// SPDX-License-Identifier: GPL-3.0-or-later
// The lattice that is found by shifts, against the one that is found with rationals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "fathom/numbers.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::polytope {
namespace {

using Random = std::mt19937_64;
using Doubles = std::vector<std::array<double, 3>>;

std::vector<Point> exact(const Doubles& body) {
  std::vector<Point> points;
  for (const auto& [x, y, z] : body) points.push_back({exact_value(x), exact_value(y), exact_value(z)});
  return points;
}

void expect_cloud(const NarrowCloud& cloud, const kernels::PointCloud& expected) {
  kernels::ScanMemory memory;
  const NarrowPoints points(cloud, expected.exponent(), memory);
  ASSERT_EQ(points.size(), expected.size());
  ASSERT_EQ(cloud.words.size() + cloud.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Vec3<NarrowInteger> p = points[i];
    ASSERT_EQ((Vector{p.x.to_mpz(), p.y.to_mpz(), p.z.to_mpz()}), expected[i]);
    ASSERT_EQ((Vec3<double>{cloud.x[i], cloud.y[i], cloud.z[i]}),
              (Vec3<double>{expected.xs()[i], expected.ys()[i], expected.zs()[i]}));
  }
}

void expect_placed(const NarrowPair& pair, const PlacedPair& expected) {
  EXPECT_EQ(pair.exponent, expected.exponent());
  EXPECT_EQ(testing::power_of_two(pair.shift), expected.denominator);
  expect_cloud(pair.a, expected.a);
  expect_cloud(pair.b, expected.b);
}

/// Numbers around 2^scale, with a few bits or with all.
double some_double(Random& random, int scale, int spread) {
  if (random() % 9 == 0) return 0;
  const int bits = random() % 2 == 0 ? 8 : 53;
  const double mantissa = std::ldexp(static_cast<double>(random() >> 11), -53);
  const double cut = std::ldexp(std::floor(std::ldexp(mantissa, bits)), -bits);
  return std::ldexp(random() % 2 == 0 ? cut : -cut, scale + static_cast<int>(random() % (2 * spread + 1)) - spread);
}

TEST(NarrowPair, IsTheLatticeOfPlaceForBinary64) {
  Random random(1);
  NarrowPair pair, of_points;
  std::size_t narrow = 0, wide = 0;
  for (int i = 0; i < 3000; ++i) {
    const int scale = i % 5 == 0   ? 200
                      : i % 5 == 1 ? -1060
                                   : static_cast<int>(random() % 60) - 30,
              spread = 1 + i % 130;
    Doubles a(1 + random() % 9), b(1 + random() % 9);
    for (Doubles* body : {&a, &b})
      for (std::array<double, 3>& p : *body)
        for (double& c : p) c = some_double(random, scale, spread);
    const std::vector<Point> exact_a = exact(a), exact_b = exact(b);
    const PlacedPair expected = place(exact_a, exact_b);
    const bool placed = place_narrow(a, b, pair);
    ++(placed ? narrow : wide);
    ASSERT_TRUE(placed || expected.exponent() > 200)
        << i << ": a lattice of " << expected.exponent() << " bits is narrow";
    if (placed) expect_placed(pair, expected);
    if (!place_narrow(exact_a, exact_b, of_points)) continue;  // long numerators are left to `place`
    ASSERT_TRUE(placed);
    expect_placed(of_points, expected);
  }
  EXPECT_GT(narrow, 1500U);
  EXPECT_GT(wide, 50U);
}

TEST(NarrowPair, IsTheLatticeOfPlaceForPointsInOnePlace) {
  for (const double unit : {0.0, 1.0, 0x1p-63, 0x1p-64, 0x1p-1074, 0x1p200}) {
    const Doubles body(2, {unit, -unit, 3 * unit});
    NarrowPair pair;
    ASSERT_TRUE(place_narrow(body, body, pair));
    expect_placed(pair, place(exact(body), exact(body)));
  }
}

TEST(NarrowPair, IsTheLatticeOfPlaceForEveryFamily) {
  NarrowPair pair;
  std::size_t narrow = 0;
  for (const Case& input : testing::cases_of_all_families(3, 12)) {
    if (!place_narrow(input.a.points, input.b.points, pair)) continue;
    SCOPED_TRACE(input.id);
    ++narrow;
    expect_placed(pair, place(input.a.points, input.b.points));
  }
  EXPECT_GT(narrow, 50U);
}

TEST(NarrowPair, LeavesTheRestToPlace) {
  NarrowPair pair;
  const std::vector<Point> origin{{0, 0, 0}}, third{{mpq_class(1, 3), 0, 0}},
      fine{{mpq_class(1, testing::power_of_two(400)), 1, 0}};
  Point broken{0, 0, 0};
  broken.x.get_num() = 2;
  broken.x.get_den() = 4;
  EXPECT_TRUE(place_narrow(origin, origin, pair));
  EXPECT_EQ(pair.shift, 0U);
  EXPECT_FALSE(place_narrow(std::vector<Point>{}, origin, pair));
  EXPECT_FALSE(place_narrow(third, origin, pair));
  EXPECT_FALSE(place_narrow(fine, origin, pair));
  EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << "not in lowest terms";
  broken.x.get_num() = 1;
  broken.x.get_den() = -4;
  EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << "a negative denominator";
  broken.x.get_den() = 0;
  EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << "a denominator of 0";
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(place_narrow(Doubles{{0, bad, 0}}, Doubles{{0, 0, 0}}, pair), std::invalid_argument);
}

TEST(NarrowDifferences, AreThoseOfClouds) {
  Random random(2);
  kernels::ScanMemory memory;
  for (int i = 0; i < 1500; ++i) {
    const unsigned long bits = i % 3 == 0 ? 2 : i % 3 == 1 ? 50 : 300;
    std::vector<Vector> a(1 + random() % 30), b(1 + random() % 300);
    for (std::vector<Vector>* body : {&a, &b})
      for (Vector& p : *body) p = testing::random_vector(random, bits);
    const PlacedPair pair = place_integers(a, b);
    Differences expected{pair.a, pair.b};
    NarrowDifferences differences{{pair.a, memory}, {pair.b, memory}};
    const Vector u = i % 20 == 0 ? Vector{0, 0, 0} : testing::random_vector(random, 1 + random() % 300);
    const Vec3<NarrowInteger> fixed{NarrowInteger(u.x), NarrowInteger(u.y), NarrowInteger(u.z)};
    const Difference d = differences.extreme(fixed);
    ASSERT_EQ(d, expected.extreme(u));
    const Vec3<NarrowInteger> difference = differences[d];
    ASSERT_EQ((Vector{difference.x.to_mpz(), difference.y.to_mpz(), difference.z.to_mpz()}), expected[d]);
  }
}

}  // namespace
}  // namespace fathom::polytope
