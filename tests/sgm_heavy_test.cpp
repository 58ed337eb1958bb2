// SPDX-License-Identifier: GPL-3.0-or-later
// The exact method and its naive twin against the overlay of CGAL's spherical Gaussian maps, over
// all families, at sizes beyond the other oracles.
#include <gtest/gtest.h>

#include <string>

#include "reference/polytope/polytope.hpp"
#include "tests/oracles/naive_answer.hpp"
#include "tests/oracles/sgm/sgm_oracle.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

namespace {

using namespace fathom;
using namespace fathom::oracles;
using families::Family;

bool both_solid(const Case& pair) {
  const polytope::PlacedPair placed = polytope::place(pair.a.points, pair.b.points);
  return polytope::convex_hull(placed.a.points()).rank == 3 && polytope::convex_hull(placed.b.points()).rank == 3;
}

TEST(GaussianMaps, CubeInItself) {
  const OracleAnswer answer = sgm_oracle(families::cube().points, families::cube().points);
  EXPECT_EQ(answer.squared, 4);
  EXPECT_EQ(answer.directions.size(), 6u);
}

TEST(GaussianMaps, RefuseFlatBodies) {
  const Body flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_THROW(sgm_oracle(flat.points, families::cube().points), std::invalid_argument);
}

class EveryFamily : public ::testing::TestWithParam<Family> {};

TEST_P(EveryFamily, OverlayEqualsThePipelineAndItsTwin) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Case pair = GetParam().make(seed, 16);
    if (!both_solid(pair)) continue;
    const OracleAnswer overlay = sgm_oracle(pair.a.points, pair.b.points);
    EXPECT_EQ(overlay, naive_answer(pair.a.points, pair.b.points)) << pair.id;
    EXPECT_EQ(overlay, answer_of(penetration_depth(pair.a.points, pair.b.points))) << pair.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryFamily,
                         ::testing::ValuesIn(families::families().begin(), families::families().end()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(GaussianMaps, LargeRandomSpheres) {
  const Case pair = families::find_family("random_sphere")->make(1, 100);
  const OracleAnswer overlay = sgm_oracle(pair.a.points, pair.b.points);
  EXPECT_EQ(overlay, naive_answer(pair.a.points, pair.b.points)) << pair.id;
  EXPECT_EQ(overlay, answer_of(penetration_depth(pair.a.points, pair.b.points))) << pair.id;
}

}  // namespace
