// SPDX-License-Identifier: GPL-3.0-or-later
// The exact directional depth against the hull of all differences.
#include <gtest/gtest.h>

#include <stdexcept>

#include "fathom/approximate.hpp"
#include "kernels/vector.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::approximate {
namespace {

const Point directions[] = {{1, 0, 0}, {0, -3, 0}, {1, 1, 1}, {mpq_class(1, 3), mpq_class(-2, 7), 0}, {mpq_class(1, 1000), 0, 1}};

TEST(Directional, EqualsTheHullOfAllDifferencesOnEveryFamily) {
  std::size_t penetrating = 0;
  for (const Case& input : testing::cases_of_all_families(2, 8)) {
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    const Depth exact = testing::exact_depth(a, b);
    const polytope::PlacedPair placed = polytope::place(a, b);
    const polytope::Polytope p = testing::differences(placed);
    for (const Point& u : directions) {
      const DirectionalDepth found = directional_depth(a, b, u);
      ASSERT_EQ(found.status(), exact.status()) << input.id;
      EXPECT_EQ(found.translation(), (Point{found.factor() * u.x, found.factor() * u.y, found.factor() * u.z})) << input.id;
      EXPECT_GE(found.squared(), exact.squared()) << input.id;
      if (found.status() != Status::penetrating) {
        EXPECT_EQ(found.factor(), 0) << input.id;
        EXPECT_EQ(sgn(testing::support(a, b, found.normal())), found.status() == Status::disjoint ? -1 : 0) << input.id;
        continue;
      }
      ++penetrating;
      const RayExit& exit = *found.penetration();
      const Vector scaled{mpq_class(21000 * u.x).get_num(), mpq_class(21000 * u.y).get_num(), mpq_class(21000 * u.z).get_num()};
      const mpq_class factor = testing::factor_naive(p, scaled);
      EXPECT_EQ(found.factor(), factor * 21000 / placed.denominator) << input.id;
      EXPECT_TRUE(testing::is_hit(p, found.normal(), factor, scaled)) << input.id;
      EXPECT_EQ(exit.contact.kind, testing::kind_of(exit.contact, a, b)) << input.id;
      EXPECT_EQ(exit.contact.a, testing::face(a, -exit.normal)) << input.id;
      EXPECT_EQ(exit.contact.b, testing::face(b, exit.normal)) << input.id;
      EXPECT_EQ(exit.witness.b - exit.witness.a, found.translation()) << input.id;
      EXPECT_TRUE(testing::in_hull(exit.witness.a, a, exit.contact.a)) << input.id;
      EXPECT_TRUE(testing::in_hull(exit.witness.b, b, exit.contact.b)) << input.id;
    }
  }
  EXPECT_GT(penetrating, 200U);
}

// Along the direction of an optimum the directional depth is the depth.
TEST(Directional, AlongAnOptimumItIsTheDepth) {
  for (const Case& input : testing::cases_of_all_families(2, 10)) {
    const Depth exact = testing::exact_depth(input.a.points, input.b.points);
    for (const Optimum& optimum : exact.optima()) {
      const DirectionalDepth found = directional_depth(input.a.points, input.b.points, optimum.translation());
      EXPECT_EQ(found.factor(), 1) << input.id;
      EXPECT_EQ(found.squared(), exact.squared()) << input.id;
      EXPECT_EQ(found.normal(), optimum.direction) << input.id;
      EXPECT_EQ(found.penetration()->contact, optimum.contact) << input.id;
    }
  }
}

TEST(Directional, RefusesZero) {
  const std::vector<Point> one{{0, 0, 0}}, none;
  EXPECT_THROW(directional_depth(one, one, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(directional_depth(none, one, {1, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::approximate
