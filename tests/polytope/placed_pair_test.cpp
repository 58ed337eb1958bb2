// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/number/rational.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::polytope {
namespace {

Point integers(long x, long y, long z) { return {x, y, z}; }

std::vector<Point> random_points(int most_terms) {
  const auto coordinate = [&] { return kernels::ratio(*rc::gen::inRange(-40, 40), *rc::gen::inRange(1, 13)); };
  std::vector<Point> points(*rc::gen::inRange(1, most_terms));
  for (Point& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

/// The least common denominator of all differences to b[0], by the definition.
mpz_class denominator_naive(std::span<const Point> a, std::span<const Point> b) {
  mpz_class common = 1;
  for (const std::span<const Point> body : {a, b}) {
    for (const Point& p : body) {
      for (const mpq_class& d : {mpq_class(p.x - b[0].x), mpq_class(p.y - b[0].y), mpq_class(p.z - b[0].z)}) {
        common = lcm(common, d.get_den());
      }
    }
  }
  return common;
}

void expect_same_positions(const PlacedPair& placed, std::span<const Point> a, std::span<const Point> b) {
  ASSERT_EQ(placed.a.size(), a.size());
  ASSERT_EQ(placed.b.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(placed.position(placed.a[i]), a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) EXPECT_EQ(placed.position(placed.b[i]), b[i]);
}

TEST(PlacedPair, KeepsEveryPositionInTheLeastDenominator) {
  EXPECT_TRUE(holds({.seed = 37, .runs = 1000}, [] {
    const std::vector<Point> a = random_points(5), b = random_points(5);
    const PlacedPair placed = place(a, b);
    expect_same_positions(placed, a, b);
    RC_ASSERT(placed.denominator == denominator_naive(a, b));
    RC_ASSERT(is_zero(placed.b[0]));
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TEST(PlacedPair, ADenominatorThatDifferencesDoNotNeedIsDividedOut) {
  const std::vector<Point> a{{kernels::ratio(1, 3), kernels::ratio(1, 7), 0},
                             {kernels::ratio(4, 3), kernels::ratio(8, 7), 5}},
      b{{kernels::ratio(7, 3), kernels::ratio(-6, 7), 1}};
  const PlacedPair placed = place(a, b);
  EXPECT_EQ(placed.denominator, 1);
  EXPECT_EQ(placed.a[1], (Vector{-1, 2, 4}));
  expect_same_positions(placed, a, b);
}

TEST(PlacedPair, AFactorOfAllIntegersStays) {
  const PlacedPair placed = place(std::vector{integers(1000, 0, 2000)}, std::vector{integers(0, 0, 0)});
  EXPECT_EQ(placed.denominator, 1);
  EXPECT_EQ(placed.a[0], (Vector{1000, 0, 2000}));
}

TEST(PlacedPair, BodiesFarFromTheOriginStaySmall) {
  const mpz_class far("1" + std::string(300, '0'));
  const std::vector<Point> a{{mpq_class(far + 1), mpq_class(far), mpq_class(-far)}},
      b{{mpq_class(far), mpq_class(far), mpq_class(-far)}};
  const PlacedPair placed = place(a, b);
  EXPECT_EQ(placed.a[0], (Vector{1, 0, 0}));
  expect_same_positions(placed, a, b);
}

TEST(PlacedPair, DoublesOfAllExponents) {
  std::vector<Point> a, b;
  for (int e = -1074; e <= 1023; e += 233) {
    a.push_back({mpq_class(std::ldexp(1.0, e)), mpq_class(-1e300), mpq_class(1e-300)});
    b.push_back({mpq_class(0.1), mpq_class(std::ldexp(-1.5, e)), mpq_class(5e-324)});
  }
  const PlacedPair placed = place(a, b);
  EXPECT_EQ(placed.denominator, mpz_class(1) << 1074);
  expect_same_positions(placed, a, b);
}

TEST(PlacedPair, PositionsBetweenLatticePoints) {
  const PlacedPair placed =
      place(std::vector<Point>{{kernels::ratio(1, 2), 0, 0}}, std::vector<Point>{{kernels::ratio(1, 3), 1, 0}});
  EXPECT_EQ(placed.denominator, 6);
  EXPECT_EQ(placed.position({1, -6, 12}, 4),
            (Point{kernels::ratio(1, 3) + kernels::ratio(1, 24), kernels::ratio(3, 4), kernels::ratio(1, 2)}));
  EXPECT_EQ(placed.position({1, 0, 0}, -1), (Point{kernels::ratio(1, 6), 1, 0}));
}

// One exponent, the least, whichever body is larger: filters compare images of both clouds.
TEST(PlacedPair, CloudsShareTheLeastExponent) {
  const std::vector<Point> small{integers(0, 0, 0), integers(3, 0, 0)}, large{integers(0, 0, 0), integers(0, 1000, 0)};
  for (const PlacedPair& placed : {place(small, large), place(large, small)}) {
    EXPECT_EQ(placed.exponent(), 10);
    EXPECT_EQ(placed.a.exponent(), placed.b.exponent());
  }
  const PlacedPair integral = place_integers({{1, 2, 3}}, {{4, 0, 0}, {-9, 0, 0}});
  EXPECT_EQ(integral.exponent(), 4);
  EXPECT_EQ(integral.b.exponent(), 4);
  EXPECT_EQ(integral.position({1, 2, 3}), (Point{1, 2, 3})) << "the unit is 1, the origin O";
}

TEST(PlacedPair, IsSlimWhereDenominatorsRepeat) {
  const std::vector<Point> origin{integers(0, 0, 0)};
  std::vector<Point> body;
  mpz_class prime = 1;
  for (int i = 0; i < 500; ++i) {
    mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
    body.push_back({kernels::ratio(1, prime), 0, 0});
  }
  EXPECT_FALSE(place_if_slim(body, origin)) << "some 5000 bits for coordinates of 12";
  expect_same_positions(place(body, origin), body, origin);
  body.resize(100);
  ASSERT_TRUE(place_if_slim(body, origin));
  expect_same_positions(*place_if_slim(body, origin), body, origin);
}

TEST(PlacedPair, LongCoordinatesAreNotPlacedToTheirEndAfterAStop) {
  struct Count final : Monitor {
    void report(std::string_view, double) override {}
    bool stopped() override { return ++asked > most; }
    std::size_t asked = 0, most = 0;
  };
  // Of so many bits that a handful of coordinates takes as long as one may wait.
  const auto body = [](unsigned long digits) {
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, digits);
    return std::vector<Point>(20, {kernels::ratio(1, power), kernels::ratio(1, power + 1), 3});
  };
  const std::vector<Point> a = body(50000), b = body(49999), few = body(10);
  for (const std::size_t most : {0, 5, 10}) {
    Count stop;
    stop.most = most;
    kernels::Context context(&stop);
    EXPECT_THROW(place(a, b, &context), Interrupted);
    EXPECT_EQ(stop.asked, most + 1);
  }
  Count never;
  kernels::Context context(&never);
  EXPECT_NO_THROW(place(few, few, &context));
  EXPECT_EQ(never.asked, 0U) << "short ones are placed sooner than one could ask";
}

TEST(PlacedPair, ABodyWithoutPointsIsRefused) {
  const std::vector<Point> one{integers(0, 0, 0)}, none;
  EXPECT_THROW(place(one, none), std::invalid_argument);
  EXPECT_THROW(place(none, one), std::invalid_argument);
}

// The lattice that is found by shifts, against the one that is found with rationals.

using Random = std::mt19937_64;
using Doubles = std::vector<std::array<double, 3>>;

std::vector<Point> exact(const Doubles& body) {
  std::vector<Point> points;
  for (const auto& [x, y, z] : body) points.push_back({exact_value(x), exact_value(y), exact_value(z)});
  return points;
}

/// The same points in units of 2^power, of which all are multiples.
PlacedPair coarser(const PlacedPair& pair, unsigned power) {
  const auto divided = [&](const kernels::PointCloud& cloud) {
    std::vector<Vector> points = cloud.points();
    for (Vector& p : points) p = {p.x >> power, p.y >> power, p.z >> power};
    return points;
  };
  PlacedPair result = place_integers(divided(pair.a), divided(pair.b));
  EXPECT_EQ(result.exponent() + power, pair.exponent());
  return result;
}

void expect_cloud(const NarrowCloud& cloud, const kernels::PointCloud& expected) {
  kernels::ScanMemory memory;
  const Points nobody_asks(std::span<const Point>{});
  const PointsIn<NarrowInteger> points(cloud, expected.exponent(), nobody_asks, memory);
  ASSERT_EQ(points.size(), expected.size());
  ASSERT_EQ(cloud.words.size() + cloud.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Vec3<NarrowInteger> p = points[i];
    ASSERT_EQ((Vector{p.x.to_mpz(), p.y.to_mpz(), p.z.to_mpz()}), expected[i]);
    ASSERT_EQ((Vec3<double>{cloud.x[i], cloud.y[i], cloud.z[i]}),
              (Vec3<double>{expected.xs()[i], expected.ys()[i], expected.zs()[i]}));
  }
}

/// That of `place`, but for a power of two in the unit.
void expect_placed(const NarrowMemory& pair, const PlacedPair& expected) {
  const unsigned finer = static_cast<unsigned>(std::max(pair.power, 0L));
  EXPECT_EQ(mpz_class(pair.denominator << std::max(-pair.power, 0L)), expected.denominator);
  EXPECT_TRUE(mpz_odd_p(pair.denominator.get_mpz_t()));
  EXPECT_EQ(pair.exponent + finer, expected.exponent());
  const PlacedPair in_units = coarser(expected, finer);
  expect_cloud(pair.a, in_units.a);
  expect_cloud(pair.b, in_units.b);
  const PlacedPair wide = widened(pair, expected.origin);
  EXPECT_EQ(wide.denominator, expected.denominator);
  EXPECT_EQ(wide.exponent(), expected.exponent());
  for (const auto& [x, y] : {std::pair(&wide.a, &expected.a), std::pair(&wide.b, &expected.b)}) {
    EXPECT_EQ(x->points(), y->points());
    EXPECT_TRUE(std::ranges::equal(x->xs(), y->xs()));
  }
}

/// Numbers around 2^scale, with a few bits or with all.
double some_double(Random& random, int scale, int spread) {
  if (random() % 9 == 0) return 0;
  const int bits = random() % 2 == 0 ? 8 : 53;
  const double mantissa = std::ldexp(static_cast<double>(random() >> 11), -53);
  const double cut = std::ldexp(std::floor(std::ldexp(mantissa, bits)), -bits);
  return std::ldexp(random() % 2 == 0 ? cut : -cut, scale + static_cast<int>(random() % (2 * spread + 1)) - spread);
}

TEST(PlaceNarrow, IsTheLatticeOfPlaceForBinary64) {
  Random random(1);
  NarrowMemory pair, of_points;
  std::size_t narrow = 0, wide = 0;
  for (int i = 0; i < 3000; ++i) {
    const int scale = i % 5 == 0   ? 200
                      : i % 5 == 1 ? -1060
                                   : static_cast<int>(random() % 60) - 30,
              spread = 1 + i % 250;
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
    ASSERT_EQ(place_narrow(exact_a, exact_b, of_points), placed);
    if (placed) expect_placed(of_points, expected);
  }
  EXPECT_GT(narrow, 1500U);
  EXPECT_GT(wide, 50U);
}

TEST(PlaceNarrow, IsTheLatticeOfPlaceForPointsInOnePlace) {
  for (const double unit : {0.0, 1.0, 0x1p-63, 0x1p-64, 0x1p-1074, 0x1p200}) {
    const Doubles body(2, {unit, -unit, 3 * unit});
    NarrowMemory pair;
    ASSERT_TRUE(place_narrow(body, body, pair));
    expect_placed(pair, place(exact(body), exact(body)));
  }
}

TEST(PlaceNarrow, IsTheLatticeOfPlaceForEveryFamily) {
  NarrowMemory pair;
  std::size_t of_words = 0, fractions = 0, coarse = 0;
  for (const Case& input : testing::cases_of_all_families(3, 12)) {
    SCOPED_TRACE(input.id);
    const PlacedPair expected = place(input.a.points, input.b.points);
    if (place_narrow(input.a.points, input.b.points, pair)) {
      ++of_words;
      fractions += pair.denominator > 1 ? 1 : 0;
      coarse += pair.power > 0 ? 1 : 0;
      expect_placed(pair, expected);
    }
  }
  EXPECT_GT(of_words, 150U);
  EXPECT_GT(fractions, 40U);
  EXPECT_GT(coarse, 2U);
}

/// Fractions whose divisors, numerators and differences are about as long as words can be.
TEST(PlaceNarrow, IsTheLatticeOfPlaceForFractions) {
  Random random(3);
  NarrowMemory pair;
  std::size_t placed = 0, left = 0, shared = 0;
  const auto fraction = [&](unsigned long numerator_bits, std::uint64_t divisor) {
    mpq_class q(testing::random_vector(random, numerator_bits).x, mpz_class(divisor));
    q.canonicalize();
    return q;
  };
  for (int i = 0; i < 4000; ++i) {
    const std::uint64_t most = std::uint64_t{1} << (1 + random() % 40);
    std::array<std::uint64_t, 3> divisors;
    for (std::uint64_t& d : divisors) d = 1 + random() % most;
    const bool far = random() % 3 == 0;  // one remainder for all: differences need no divisor
    const mpq_class origin = fraction(far ? 50 : 1, divisors[0]);
    std::vector<Point> a(1 + random() % 5), b(1 + random() % 5);
    for (std::vector<Point>* body : {&a, &b})
      for (Point& p : *body)
        for (mpq_class* c : {&p.x, &p.y, &p.z})
          *c = origin + (far ? fraction(20, 1) : fraction(1 + random() % 64, divisors[random() % 3]));
    const PlacedPair expected = place(a, b);
    if (place_narrow(a, b, pair)) {
      ++placed;
      shared += far && pair.denominator == 1 && divisors[0] > 1 ? 1 : 0;
      expect_placed(pair, expected);
    } else {
      ++left;
    }
    ASSERT_FALSE(::testing::Test::HasFailure()) << i;
  }
  EXPECT_GT(placed, 1500U);
  EXPECT_GT(left, 200U);
  EXPECT_GT(shared, 500U);
}

TEST(PlaceNarrow, LeavesTheRestToPlace) {
  NarrowMemory pair;
  const std::vector<Point> origin{{0, 0, 0}}, fine{{mpq_class(1, testing::power_of_two(400)), 1, 0}};
  Point broken{0, 0, 0};
  broken.x.get_num() = 2;
  broken.x.get_den() = 4;
  EXPECT_TRUE(place_narrow(origin, origin, pair));
  EXPECT_EQ(pair.power, 0);
  EXPECT_FALSE(place_narrow(std::vector<Point>{}, origin, pair));
  EXPECT_FALSE(place_narrow(fine, origin, pair));
  EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << "not in lowest terms";
  broken.x.get_num() = 1;
  broken.x.get_den() = -4;
  EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << "a negative denominator";
  broken.x.get_den() = 0;
  EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << "a denominator of 0";
  for (const auto& [n, d] : {std::pair(0, 3), {3, 9}, {6, 15}, {2, 6}}) {
    broken.x.get_num() = n;
    broken.x.get_den() = d;
    EXPECT_FALSE(place_narrow(std::vector{broken}, origin, pair)) << n << '/' << d;
    EXPECT_FALSE(place_narrow(std::vector{{mpq_class(1, d), 0, 0}, broken}, origin, pair)) << n << '/' << d;
  }
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
    auto differences = differences_in<NarrowInteger>(pair.a, pair.b, memory);
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
