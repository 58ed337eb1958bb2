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
};

Work measure(const char* family, unsigned size) {
  const PreparedGrids grids(families::find_family(family)->make(1, size));
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
  return result;
}

class Growth : public ::testing::TestWithParam<const char*> {};

TEST_P(Growth, OfWorkIsNearLinearWhileCrossingsAreQuadratic) {
  const Work small = measure(GetParam(), 512), large = measure(GetParam(), 4096);
  const double edges = large.edges / small.edges;
  EXPECT_GE(large.crossings / small.crossings, std::pow(edges, 1.9));
  EXPECT_LE(large.work / small.work, std::pow(edges, 1.2)) << small.work << " to " << large.work;
  EXPECT_LE(large.work, large.crossings / 20);
  // Storage: sum |A_i| + |B_i|, which may grow like n log^2 n.
  EXPECT_LE(large.memory / small.memory, std::pow(edges, 1.4));
}

INSTANTIATE_TEST_SUITE_P(Families, Growth,
                         ::testing::Values("crossed_prisms", "crossed_random_prisms", "crossed_fans", "crossed_ties",
                                           "crossed_shrinking_ties", "crossed_twists", "crossed_fillets", "crossed_parabolas"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace fathom::lines
