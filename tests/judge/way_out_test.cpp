// SPDX-License-Identifier: GPL-3.0-or-later
// The ray that starts from a certificate, against the ray through hulls and hierarchies.
#include <gtest/gtest.h>

#include "fathom/approximate.hpp"
#include "tests/support/prepared.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

TEST(WayOut, EqualsTheDirectionalDepthOnEveryFamily) {
  std::size_t rays = 0, given_up = 0;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    const Depth depth = penetration_depth(a, b, {.method = Method::certificate});
    if (!depth.penetration()) continue;
    const InnerPolytope& inner = depth.penetration()->inner.value();
    const polytope::PlacedPair placed = polytope::place(a, b);
    std::vector<Vector> directions{{1, 0, 0}, {0, -1, 0}, {1, 1, 1}, {3, -2, 1}, {1, 0, 1000000}};
    for (const Optimum& optimum : depth.optima()) directions.push_back(optimum.direction);
    for (const auto& [i, j] : inner.vertices) directions.push_back(placed.b[j] - placed.a[i]);
    if (directions.size() > 12) directions.resize(12);
    for (const Vector& u : directions) {
      ++rays;
      const DirectionalDepth expected = directional_depth(a, b, {u.x, u.y, u.z});
      const std::optional<mpq_class> found = way_out(placed, inner, u);
      if (found) EXPECT_EQ(*found / placed.denominator, expected.factor()) << input.id;
      else ++given_up;
    }
  }
  EXPECT_GT(rays, 300U);
  EXPECT_EQ(given_up, 0U);
}

TEST(WayOut, MayRunOutOfPatience) {
  const Case input = families::find_family("random_sphere")->make(1, 30);
  const Depth depth = penetration_depth(input.a.points, input.b.points, {.method = Method::certificate});
  const InnerPolytope& inner = depth.penetration()->inner.value();
  EXPECT_FALSE(way_out(polytope::place(input.a.points, input.b.points), inner, {1, 2, 3}, 0));
}

}  // namespace
}  // namespace fathom::judging
