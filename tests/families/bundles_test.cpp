// SPDX-License-Identifier: GPL-3.0-or-later
// All crossed bundles, at sizes beyond those of the tests over all families: Theta(n^2) crossings,
// one of which decides, and the pipeline against its twins.
#include <gtest/gtest.h>

#include <algorithm>

#include "reference/depth/naive.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace {

using namespace fathom;
using families::find_family;

struct Bundle {
  const char* family;
  double share;  ///< of n^2 that are crossings, about
};

constexpr Bundle bundles[] = {{"crossed_fans", 1},
                              {"crossed_parabolas", 1},
                              {"crossed_random_parabolas", 1},
                              {"crossed_twists", 1},
                              {"crossed_patch", 1},
                              {"crossed_prisms", 0.5},
                              {"crossed_random_prisms", 0.5},
                              {"crossed_ties", 1},
                              {"crossed_shrinking_ties", 1},
                              {"crossed_vanishing_ties", 1},
                              {"crossed_noisy_ties", 1},
                              {"crossed_fillets", 0.25}};

class Bundles : public ::testing::TestWithParam<Bundle> {};

TEST_P(Bundles, EqualTheHullOfAllDifferences) {
  for (const unsigned n : {16U, 100U}) {
    const Case input = find_family(GetParam().family)->make(n, n);
    const Depth depth = fathom::testing::exact_depth(input.a.points, input.b.points, {.validate = true});
    const Depth twin = penetration_depth(input.a.points, input.b.points, {.method = Method::naive});
    EXPECT_EQ(depth.status(), Status::penetrating) << input.id;
    EXPECT_EQ(depth.squared(), twin.squared()) << input.id;
    EXPECT_EQ(depth.optima(), twin.optima()) << input.id;
  }
}

TEST_P(Bundles, CrossLikeAGridAndTwoEdgesDecide) {
  for (const unsigned n : {64U, 256U}) {
    const Case input = find_family(GetParam().family)->make(5, n);
    const Depth depth = fathom::testing::exact_depth(input.a.points, input.b.points);
    const double grid = GetParam().share * n * n, crossings = static_cast<double>(depth.counters.crossings);
    EXPECT_GT(crossings, grid * (1 - 8.0 / n)) << input.id;
    EXPECT_LT(crossings, grid * (1 + 32.0 / n)) << input.id;
    EXPECT_LE(depth.counters.edges_a + depth.counters.edges_b, 8 * n + 64) << input.id;
    ASSERT_EQ(depth.status(), Status::penetrating) << input.id;
    for (const Optimum& optimum : depth.optima()) EXPECT_EQ(optimum.contact.kind, ContactKind::edge_edge) << input.id;
    const auto p = fathom::testing::prepare(input);
    const kernels::NearestPlanes scan = depth::nearest_facets_scan(p->a, p->b, p->exponent);
    EXPECT_TRUE(std::ranges::equal(scan.directions(), depth.optima(), {}, {}, &Optimum::direction)) << input.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Bundles, ::testing::ValuesIn(bundles),
                         [](const auto& info) { return std::string(info.param.family); });

}  // namespace
