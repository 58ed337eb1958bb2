// SPDX-License-Identifier: GPL-3.0-or-later
// What a prepared pair says of the bodies, against the exact pipeline.
#include "reference/approximate/body_pair.hpp"

#include <gtest/gtest.h>

#include "tests/support/check_depth.hpp"
#include "tests/support/prepared.hpp"

namespace fathom {
namespace {

TEST(BodyPair, EqualsTheExactPipeline) {
  std::size_t penetrating = 0;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const Depth depth = penetration_depth(input.a.points, input.b.points);
    const BodyPair pair(input.a.points, input.b.points);
    ASSERT_EQ(pair.status(), depth.status()) << input.id;
    EXPECT_EQ(pair.flat_a(), depth.flat_a) << input.id;
    EXPECT_EQ(pair.flat_b(), depth.flat_b) << input.id;
    if (depth.status() != Status::penetrating) {
      const mpq_class h = testing::support(input.a.points, input.b.points, *pair.separating());
      EXPECT_EQ(sgn(h), depth.status() == Status::disjoint ? -1 : 0) << input.id;
      continue;
    }
    ++penetrating;
    EXPECT_FALSE(pair.separating()) << input.id;
    EXPECT_EQ(pair.a().polytope().vertices.size(), depth.extreme_a) << input.id;
    EXPECT_EQ(pair.b().polytope().vertices.size(), depth.extreme_b) << input.id;
    for (const Optimum& optimum : depth.optima()) {
      const Vector& n = optimum.direction;
      const mpq_class factor = testing::support(input.a.points, input.b.points, n) * pair.lattice().denominator / dot(n, n);
      EXPECT_EQ(pair.translation(factor, n), optimum.translation) << input.id;
      EXPECT_EQ(pair.contact(n), optimum.contact) << input.id;
      const auto witness = pair.witness(n, optimum.translation);
      ASSERT_TRUE(witness) << input.id;
      EXPECT_EQ((Point{witness->b.x - witness->a.x, witness->b.y - witness->a.y, witness->b.z - witness->a.z}), optimum.translation);
      EXPECT_TRUE(testing::in_hull(witness->a, input.a.points, optimum.contact.a)) << input.id;
      EXPECT_TRUE(testing::in_hull(witness->b, input.b.points, optimum.contact.b)) << input.id;
      const Point& t = optimum.translation;
      EXPECT_FALSE(pair.witness(n, {2 * t.x, 2 * t.y, 2 * t.z})) << input.id << ": twice as far, the faces do not meet";
    }
  }
  EXPECT_GT(penetrating, 50U);
}

TEST(BodyPair, ProgressCanStopIt) {
  const Case input = families::find_family("random_sphere")->make(1, 9);
  EXPECT_THROW(BodyPair(input.a.points, input.b.points, [](const std::string&, double) { return false; }), Interrupted);
  const std::vector<Point> none;
  EXPECT_THROW(BodyPair(none, input.b.points), std::invalid_argument);
}

}  // namespace
}  // namespace fathom
