// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/monitor.hpp"
#include "kernels/context.hpp"
#include "kernels/number/rational.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/support/property.hpp"

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
    RC_ASSERT(!testing::Test::HasFailure());
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

}  // namespace
}  // namespace fathom::polytope
