// SPDX-License-Identifier: GPL-3.0-or-later
// How the work of the cutting engine grows, in counts. The families are those of the closest-line study: rims with minima along an arc,
// the same at random, thin fans, near ties over a fixed and over a shrinking patch; and two of another kind, twisted chains and fillets.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/lines/closest_lines.hpp"
#include "tests/support/grids.hpp"

namespace fathom::lines {
namespace {

using testing::PreparedGrids;

struct Work {
  double edges = 0, crossings = 0, work = 0, memory = 0;
  Counters counters;
};

Work measure(const char* family, unsigned size, bool turned = false) {
  const Case input = families::find_family(family)->make(1, size);
  const PreparedGrids grids(turned ? testing::turned(input) : input);
  Work result;
  kernels::NearestPlanes nearest;
  kernels::Context context;
  for (std::size_t h = 0; h < 2; ++h) {
    closest_lines(context, grids.subsets[h], grids.scenes[h], nearest);
    const canonical::CanonicalSubsets::Sums sums = grids.subsets[h].sums();
    result.crossings += static_cast<double>(sums.product);
    result.memory += static_cast<double>(sums.a + sums.b);
  }
  result.edges = static_cast<double>(grids.a.size());
  const Counters& counters = context.counters;
  result.work = static_cast<double>(counters.cells + counters.block_tests + counters.pairs_evaluated);
  result.counters = counters;
  return result;
}

class Growth : public ::testing::TestWithParam<const char*> {};

TEST_P(Growth, OfWorkIsNearLinearWhileCrossingsAreQuadratic) {
  const Work small = measure(GetParam(), 512), large = measure(GetParam(), 4096);
  const double edges = large.edges / small.edges;
  EXPECT_GE(large.crossings / small.crossings, std::pow(edges, 1.9));
  EXPECT_LE(large.work / small.work, std::pow(edges, 1.2)) << small.work << " to " << large.work;
  EXPECT_LE(large.work, large.crossings / 20);
  // Where binary64 tells pairs apart, nothing is done in longer numbers.
  EXPECT_EQ(large.counters.wide_tests, 0U);
  // Storage: sum |A_i| + |B_i|, which may grow like n log^2 n.
  EXPECT_LE(large.memory / small.memory, std::pow(edges, 1.4));
}

// Ties beyond binary64: what the double filter cannot tell apart is told apart by blocks, in wide floats, and not pair by pair. How the
// bodies lie does not matter.
struct Ties {
  const char* family;
  bool turned;
};
class NearTies : public ::testing::TestWithParam<Ties> {};

TEST_P(NearTies, AreLookedAtByBlocks) {
  const auto [family, turned] = GetParam();
  const Work small = measure(family, 256, turned), large = measure(family, 8192, turned);
  const double edges = large.edges / small.edges;
  EXPECT_GE(large.crossings / small.crossings, std::pow(edges, 1.9));
  const auto pairs = [](const Work& w) { return static_cast<double>(w.counters.pairs_evaluated); };
  EXPECT_LE(pairs(large) / pairs(small), std::pow(edges, 1.3)) << pairs(small) << " to " << pairs(large);
  EXPECT_LE(large.work, large.crossings / 50);
  // Few are left to exact arithmetic, and those of the blocks that the offset test did are part of all.
  EXPECT_LE(large.counters.pairs_exact, 8 * static_cast<std::uint64_t>(large.edges));
  EXPECT_GT(large.counters.wide_clears + large.counters.offset_blocks, 0U);
  EXPECT_LE(large.counters.wide_clears + large.counters.offset_blocks, large.counters.wide_tests);
  EXPECT_LE(large.counters.offset_pairs, large.counters.pairs_evaluated);
}

INSTANTIATE_TEST_SUITE_P(Families, NearTies,
                         ::testing::Values(Ties{"crossed_vanishing_ties", false}, Ties{"crossed_noisy_ties", false},
                                           Ties{"crossed_vanishing_ties", true}, Ties{"crossed_noisy_ties", true}),
                         [](const auto& info) { return std::string(info.param.family) + (info.param.turned ? "_turned" : ""); });

// Where tests cost more than they can be worth, the rest of a grid is scanned: never far more work than every pair.
TEST(Fallback, WorkIsBoundedByTheCrossings) {
  const PreparedGrids grids(families::find_family("crossed_fans")->make(1, 400));
  for (const std::uint64_t allowance : {0ULL, 1ULL << 10, 1ULL << 20}) {
    kernels::NearestPlanes nearest;
    kernels::Context context;
    std::uint64_t crossings = 0;
    for (std::size_t h = 0; h < 2; ++h) {
      closest_lines(context, grids.subsets[h], grids.scenes[h], nearest, {.cutting_size = {.few = 1, .base = 1, .allowance = allowance}});
      crossings += grids.subsets[h].sums().product;
    }
    const Counters& counters = context.counters;
    const std::uint64_t tests = 16 * counters.block_tests + 256 * counters.frame_tests + 4096 * counters.wide_tests;
    EXPECT_LE(tests, crossings / 8 + counters.grids_cut * (allowance + 5000)) << allowance;
    EXPECT_LE(counters.pairs_evaluated, 2 * crossings) << allowance;
    EXPECT_LE(counters.cells, crossings / 16) << allowance;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Growth,
                         ::testing::Values("crossed_prisms", "crossed_random_prisms", "crossed_fans", "crossed_ties",
                                           "crossed_shrinking_ties", "crossed_twists", "crossed_fillets", "crossed_parabolas"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace fathom::lines
