// SPDX-License-Identifier: GPL-3.0-or-later
// Near ties at 65,536 edges a chain: 4.3e9 pairs of lines that agree to a part in 10^11, or in
// 10^20.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/lines/closest_lines.hpp"
#include "tests/support/grids.hpp"

namespace fathom::lines {
namespace {

Counters counted(const char* family, unsigned size, bool turned) {
  const Case input = families::find_family(family)->make(1, size);
  const testing::PreparedGrids grids(turned ? testing::turned(input) : input);
  kernels::NearestPlanes nearest;
  kernels::Context context;
  for (std::size_t h = 0; h < 2; ++h) closest_lines(context, grids.subsets[h], grids.scenes[h], nearest);
  return context.counters;
}

TEST(NearTiesHeavy, PairsGrowLikeThePower13AtMost) {
  for (const auto& [family, turned] : {std::pair("crossed_vanishing_ties", false),
                                       {"crossed_vanishing_ties", true},
                                       {"crossed_shrinking_ties", false}}) {
    const Counters small = counted(family, 256, turned), large = counted(family, 65536, turned);
    const double edges = 65536.0 / 256;
    EXPECT_LE(static_cast<double>(large.pairs_evaluated),
              static_cast<double>(small.pairs_evaluated) * std::pow(edges, 1.3))
        << family;
    EXPECT_LE(large.pairs_evaluated, 4100000U) << family;
    EXPECT_LE(large.pairs_exact, 65536U) << family;
  }
}

}  // namespace
}  // namespace fathom::lines
