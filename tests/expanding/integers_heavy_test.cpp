// SPDX-License-Identifier: GPL-3.0-or-later
// The integers of fixed size against their twin on 10,000 pairs of every family.
#include <gtest/gtest.h>

#include "tests/expanding/same_expansion.hpp"

namespace fathom::expanding {
namespace {

TEST(FixedIntegers, TakeTheStepsOfMpzOnTenThousandPairsOfEveryFamily) {
  Workspace workspace;
  for (const families::Family& family : families::families()) {
    for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
      expect_same_expansions(family.make(seed, 4 + seed % 5), workspace);
      ASSERT_FALSE(::testing::Test::HasFailure()) << family.name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace fathom::expanding
