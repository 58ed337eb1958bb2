// SPDX-License-Identifier: GPL-3.0-or-later
// What a prepared pair says of the bodies, against the exact pipeline.
#include "reference/approximate/body_pair.hpp"

#include <gtest/gtest.h>

#include "kernels/vector.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::approximate {
namespace {

TEST(BodyPair, EqualsTheExactPipeline) {
  std::size_t penetrating = 0;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const Depth depth = testing::exact_depth(input.a.points, input.b.points);
    kernels::Context context;
    const BodyPair pair(context, input.a.points, input.b.points);
    ASSERT_EQ(pair.separation() ? pair.separation()->status() : Status::penetrating, depth.status()) << input.id;
    EXPECT_EQ(pair.facts().flat_a, depth.flat_a) << input.id;
    EXPECT_EQ(pair.facts().flat_b, depth.flat_b) << input.id;
    if (depth.status() != Status::penetrating) {
      const mpq_class h = testing::support(input.a.points, input.b.points, pair.separation()->normal);
      EXPECT_EQ(sgn(h), depth.status() == Status::disjoint ? -1 : 0) << input.id;
      continue;
    }
    ++penetrating;
    EXPECT_EQ(pair.facts().extreme_a, pair.a().polytope().vertices.size()) << input.id;
    EXPECT_EQ(pair.facts().extreme_b, pair.b().polytope().vertices.size()) << input.id;
    EXPECT_EQ(pair.a().polytope().vertices.size(), depth.extreme_a) << input.id;
    EXPECT_EQ(pair.b().polytope().vertices.size(), depth.extreme_b) << input.id;
    for (const Optimum& optimum : depth.optima()) {
      const Vector& n = optimum.direction;
      const mpq_class factor =
          testing::support(input.a.points, input.b.points, n) * pair.placed().denominator / dot(n, n);
      EXPECT_EQ(pair.translation(factor, n), optimum.translation()) << input.id;
      const auto [contact, witness] = pair.meeting(n, optimum.translation());
      EXPECT_EQ(contact, optimum.contact) << input.id;
      ASSERT_TRUE(witness) << input.id;
      EXPECT_EQ(witness->b - witness->a, optimum.translation());
      EXPECT_TRUE(testing::in_hull(witness->a, input.a.points, optimum.contact.a)) << input.id;
      EXPECT_TRUE(testing::in_hull(witness->b, input.b.points, optimum.contact.b)) << input.id;
      const Point& t = optimum.translation();
      EXPECT_FALSE(pair.meeting(n, {2 * t.x, 2 * t.y, 2 * t.z}).witness)
          << input.id << ": twice as far, the faces do not meet";
    }
  }
  EXPECT_GT(penetrating, 50U);
}

TEST(BodyPair, AMonitorCanStopIt) {
  const Case input = families::find_family("random_sphere")->make(1, 9);
  testing::Recorder impatient(0);
  kernels::Context stopped(&impatient), context;
  EXPECT_THROW(BodyPair(stopped, input.a.points, input.b.points), Interrupted);
  const std::vector<Point> none;
  EXPECT_THROW(BodyPair(context, none, input.b.points), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::approximate
