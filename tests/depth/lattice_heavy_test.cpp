// SPDX-License-Identifier: GPL-3.0-or-later
// 10,000 pairs of lattice bodies with coordinates in {0..3}: almost none of them is in general
// position. Against two independent oracles.
#include <gtest/gtest.h>

#include "tests/oracles/brute_oracle.hpp"
#include "tests/oracles/cdd_oracle.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/families/random.hpp"

namespace fathom::depth {
namespace {

std::vector<Point> lattice_body(families::Random& random) {
  std::vector<Point> points(static_cast<std::size_t>(random.between(1, 7)));
  for (Point& p : points) p = {random.between(0, 3), random.between(0, 3), random.between(0, 3)};
  return points;
}

TEST(LatticePairs, TenThousandEqualTheOracles) {
  families::Random random(2026);
  std::size_t penetrating = 0, ties = 0, symbolic = 0;
  for (int i = 0; i < 10000; ++i) {
    const std::vector<Point> a = lattice_body(random), b = lattice_body(random);
    const Depth depth = testing::exact_depth(a, b);
    const oracles::OracleAnswer mine = oracles::answer_of(depth);
    ASSERT_EQ(mine, oracles::brute_oracle(a, b)) << "pair " << i;
    if (i % 10 == 0) {
      ASSERT_EQ(mine, oracles::cdd_oracle(a, b)) << "pair " << i;
    }
    penetrating += depth.status() == Status::penetrating;
    ties += depth.optima().size() > 1;
    for (const TierCounts& tiers : depth.counters.predicates) symbolic += tiers.zero > 0;
  }
  EXPECT_GT(penetrating, 3000U);
  EXPECT_GT(ties, 100U);
  EXPECT_GT(symbolic, 3000U) << "these inputs are meant to be degenerate";
}

}  // namespace
}  // namespace fathom::depth
