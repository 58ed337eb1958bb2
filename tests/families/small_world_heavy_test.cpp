// SPDX-License-Identifier: GPL-3.0-or-later
// The small world: all pairs in their order, and a slice of it by two methods and the checker. The
// whole of it: fathom-two-ways --small-world.
#include <gtest/gtest.h>

#include "tests/families/small_world_twins.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/harness/two_ways.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

TEST(SmallWorld, AllPairsAscendAndEachIsTheLeastOfItsImages) {
  SmallPair before = small_pair(0);
  for (std::uint64_t number = 1; number < small_world_size(); ++number) {
    const SmallPair pair = small_pair(number);
    ASSERT_LT(before, pair) << number;
    ASSERT_EQ(pair, fathom::testing::least_image_naive(pair)) << number;
    before = pair;
  }
}

TEST(SmallWorld, AProvedAnswerAndTheHullOfAllDifferencesAgree) {
  constexpr std::uint64_t step = 307;
  const harness::Solver proved = harness::solver_with_proof(), naive = harness::solver_by(Method::naive);
  for (std::uint64_t number = 0; number < small_world_size(); number += step) {
    const Case pair = small_case(number);
    ASSERT_EQ(harness::difference(pair, proved, naive), std::nullopt) << number;
    ASSERT_EQ(small_kinds(small_pair(number)), fathom::testing::small_kinds_naive(small_pair(number))) << number;
  }
}

}  // namespace
