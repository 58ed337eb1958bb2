// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/polytope/placed_pair.hpp"

namespace fathom {
namespace {

[[maybe_unused]] const int configured = setenv("RC_PARAMS", "seed=37 max_success=1000", 0);

mpq_class ratio(long p, long q) {
  mpq_class r(p, q);
  r.canonicalize();
  return r;
}

Point integers(long x, long y, long z) { return {x, y, z}; }

std::vector<Point> random_points(int most_terms) {
  const auto coordinate = [&] { return ratio(*rc::gen::inRange(-40, 40), *rc::gen::inRange(1, 13)); };
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

void expect_same_positions(const Lattice& lattice, std::span<const Point> a, std::span<const Point> b) {
  ASSERT_EQ(lattice.a.size(), a.size());
  ASSERT_EQ(lattice.b.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(position(lattice, lattice.a[i]), a[i]);
  for (std::size_t i = 0; i < b.size(); ++i) EXPECT_EQ(position(lattice, lattice.b[i]), b[i]);
}

TEST(Lattice, KeepsEveryPositionInTheLeastDenominator) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Point> a = random_points(5), b = random_points(5);
    const Lattice lattice = common_lattice(a, b);
    expect_same_positions(lattice, a, b);
    RC_ASSERT(lattice.denominator == denominator_naive(a, b));
    RC_ASSERT(is_zero(lattice.b[0]));
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

TEST(Lattice, ADenominatorThatDifferencesDoNotNeedIsDividedOut) {
  const std::vector<Point> a{{ratio(1, 3), ratio(1, 7), 0}, {ratio(4, 3), ratio(8, 7), 5}}, b{{ratio(7, 3), ratio(-6, 7), 1}};
  const Lattice lattice = common_lattice(a, b);
  EXPECT_EQ(lattice.denominator, 1);
  EXPECT_EQ(lattice.a[1], (Vector{-1, 2, 4}));
  expect_same_positions(lattice, a, b);
}

TEST(Lattice, AFactorOfAllIntegersStays) {
  const Lattice lattice = common_lattice(std::vector{integers(1000, 0, 2000)}, std::vector{integers(0, 0, 0)});
  EXPECT_EQ(lattice.denominator, 1);
  EXPECT_EQ(lattice.a[0], (Vector{1000, 0, 2000}));
}

TEST(Lattice, BodiesFarFromTheOriginStaySmall) {
  const mpz_class far("1" + std::string(300, '0'));
  const std::vector<Point> a{{mpq_class(far + 1), mpq_class(far), mpq_class(-far)}}, b{{mpq_class(far), mpq_class(far), mpq_class(-far)}};
  const Lattice lattice = common_lattice(a, b);
  EXPECT_EQ(lattice.a[0], (Vector{1, 0, 0}));
  expect_same_positions(lattice, a, b);
}

TEST(Lattice, DoublesOfAllExponents) {
  std::vector<Point> a, b;
  for (int e = -1074; e <= 1023; e += 233) {
    a.push_back({mpq_class(std::ldexp(1.0, e)), mpq_class(-1e300), mpq_class(1e-300)});
    b.push_back({mpq_class(0.1), mpq_class(std::ldexp(-1.5, e)), mpq_class(5e-324)});
  }
  const Lattice lattice = common_lattice(a, b);
  EXPECT_EQ(lattice.denominator, mpz_class(1) << 1074);
  expect_same_positions(lattice, a, b);
}

TEST(Lattice, PositionsBetweenLatticePoints) {
  const Lattice lattice = common_lattice(std::vector<Point>{{ratio(1, 2), 0, 0}}, std::vector<Point>{{ratio(1, 3), 1, 0}});
  EXPECT_EQ(lattice.denominator, 6);
  EXPECT_EQ(position(lattice, {1, -6, 12}, 4), (Point{ratio(1, 3) + ratio(1, 24), ratio(3, 4), ratio(1, 2)}));
  EXPECT_EQ(position(lattice, {1, 0, 0}, -1), (Point{ratio(1, 6), 1, 0}));
}

TEST(Lattice, ABodyWithoutPointsIsRefused) {
  const std::vector<Point> one{integers(0, 0, 0)}, none;
  EXPECT_THROW(common_lattice(one, none), std::invalid_argument);
  EXPECT_THROW(common_lattice(none, one), std::invalid_argument);
}

}  // namespace
}  // namespace fathom
