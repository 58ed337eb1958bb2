// SPDX-License-Identifier: GPL-3.0-or-later
// The next nearest facet plane against the hull of all differences.
#include <gtest/gtest.h>

#include <random>

#include "reference/depth/naive.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/solids.hpp"

namespace fathom::depth {
namespace {

Depth solved(const Body& a, const Body& b) { return fathom::penetration_depth(a.points, b.points); }

/// Whether the bodies penetrate; then both ways must agree.
bool agrees(const Body& a, const Body& b) {
  const Depth depth = solved(a, b);
  if (depth.status() != Status::penetrating) {
    EXPECT_THROW((void)second_nearest_squared_naive(a.points, b.points), std::invalid_argument);
    return false;
  }
  const std::optional<mpq_class> second = second_nearest_squared(a.points, b.points, *depth.penetration());
  EXPECT_EQ(second, second_nearest_squared_naive(a.points, b.points));
  EXPECT_TRUE(!second || *second > depth.squared());
  return true;
}

TEST(Gap, IsThatOfTheHullOfDifferencesOnSmallLattices) {
  std::mt19937_64 random(5);
  const auto body = [&random](long reach) {
    Body result;
    for (std::size_t n = 1 + random() % 9; n > 0; --n) {
      const auto coordinate = [&] {
        return mpq_class(static_cast<long>(random() % static_cast<unsigned long>(2 * reach + 1)) - reach, 2);
      };
      Point p{coordinate(), coordinate(), coordinate()};
      for (mpq_class* x : {&p.x, &p.y, &p.z}) x->canonicalize();
      result.points.push_back(p);
    }
    return result;
  };
  std::size_t penetrating = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Body a = body(1 + i % 5), b = i % 4 == 0 ? a : body(2 + i % 7);
    penetrating += agrees(a, b) ? 1U : 0U;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(penetrating, 500U);
}

TEST(Gap, IsThatOfTheHullOfDifferencesOnFamilies) {
  std::vector<Case> cases = testing::cases_of_all_families(3, 8);
  for (const families::Family& family : families::families()) cases.push_back(family.make(5, 22));
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t penetrating = 0;
  for (const Case& input : cases) {
    SCOPED_TRACE(input.id);
    penetrating += agrees(input.a, input.b) ? 1U : 0U;
  }
  EXPECT_GT(penetrating, 200U);
}

TEST(Gap, IsNothingWhereAllFacetsTie) {
  for (const Body& body : {families::cube(), families::tetrahedron(), families::box(1, 1, 1)}) {
    const Depth depth = solved(body, Body{{{0, 0, 0}}});
    EXPECT_GE(depth.optima().size(), 4U);
    EXPECT_FALSE(second_nearest_squared(body.points, std::vector<Point>{{0, 0, 0}}, *depth.penetration()));
  }
}

// P is a box: every facet holds the foot point of O.
TEST(Gap, IsFoundOnTheOtherSide) {
  const Body a = families::box(1, 2, 3), b = families::translated(a, {0, 0, families::ratio(9, 2)});
  const Depth depth = solved(a, b);
  EXPECT_EQ(depth.squared(), families::ratio(9, 4));
  EXPECT_EQ(second_nearest_squared(a.points, b.points, *depth.penetration()), mpq_class(4));
}

// Two facets tie, and the next one leans against the second of them; around the first all are far.
TEST(Gap, IsSoughtAroundEveryOptimum) {
  const Body b{{{-1, -3, 1}, {-1, 3, -2}, {1, -1, 3}, {-1, -1, -2}, {1, 2, -3}}}, origin{{{0, 0, 0}}};
  const Depth depth = solved(origin, b);
  EXPECT_EQ(depth.optima().size(), 2U);
  EXPECT_EQ(second_nearest_squared(origin.points, b.points, *depth.penetration()), families::ratio(49, 101));
  EXPECT_TRUE(agrees(origin, b));
}

// The next facet leans against the nearest one so closely that its foot point lies far outside it,
// and other facets are far away.
TEST(Gap, IsFoundBehindAnEdge) {
  Body roof = families::box(9, 9, 9);
  roof.points.push_back({0, 0, families::ratio(901, 100)});
  const Body a{{{0, 0, -families::ratio(89, 10)}}};  // O near the floor of P: the four sides of the roof are far
  EXPECT_TRUE(agrees(a, roof));
  const Body wedge{{{-9, -9, 1},
                    {-9, 9, 1},
                    {9, -9, 1},
                    {9, 9, 1},
                    {-9, -99, 0},
                    {-9, 99, 0},
                    {9, -99, 0},
                    {9, 99, 0},
                    {0, 0, -99}}};
  EXPECT_TRUE(agrees(Body{{{0, 0, 0}}}, families::translated(wedge, {0, 0, families::ratio(-1, 2)})));
}

}  // namespace
}  // namespace fathom::depth
