// SPDX-License-Identifier: GPL-3.0-or-later
// The small world: as many pairs as Burnside's lemma counts, each the least of its images; and
// kinds as a study and a plain search find them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/study.hpp"
#include "tests/families/small_world_twins.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;
using namespace fathom::testing;

// ---- the count ----

/// Returns how many sets of four points a symmetry maps to themselves: those made of whole cycles.
std::uint64_t fixed_sets(const SmallSymmetry& symmetry) {
  std::array<std::uint64_t, 5> ways{1, 0, 0, 0, 0};  // to choose cycles of so many points in all
  std::set<std::array<int, 3>> seen;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z) {
        std::size_t length = 0;
        for (std::array<int, 3> p{x, y, z}; seen.insert(p).second; p = image(symmetry, p)) ++length;
        for (std::size_t all = 4; length > 0 && all >= length; --all) ways[all] += ways[all - length];
      }
  return ways[4];
}

TEST(SmallWorld, HasAsManyPairsAsBurnsidesLemmaCounts) {
  std::uint64_t sum = 0;
  for (const SmallSymmetry& symmetry : small_symmetries()) sum += fixed_sets(symmetry) * fixed_sets(symmetry);
  EXPECT_EQ(small_symmetries().size(), 48U);
  EXPECT_EQ(fixed_sets(small_symmetries()[0]), 17550U) << "the identity is first";
  EXPECT_EQ(sum % 48, 0U);
  EXPECT_EQ(small_world_size(), sum / 48);
  EXPECT_EQ(small_world_size(), 6'463'188U);
  EXPECT_THROW(small_pair(small_world_size()), std::out_of_range);
}

// ---- the pairs ----

TEST(SmallWorld, PairsAscendAndEachIsTheLeastOfItsImages) {
  constexpr std::uint64_t step = 9'973;
  for (std::uint64_t number = 0; number + 1 < small_world_size(); number += step) {
    const SmallPair pair = small_pair(number);
    EXPECT_LT(pair, small_pair(number + 1)) << number;
    EXPECT_EQ(pair, least_image_naive(pair)) << number;
  }
  EXPECT_EQ(small_pair(0).a, small_pair(0).b);
  const SmallPair last = small_pair(small_world_size() - 1);
  EXPECT_EQ(last, least_image_naive(last));
}

TEST(SmallWorld, EveryPairIsAnImageOfOneThatIsThere) {
  constexpr std::uint64_t step = 99'991;
  for (std::uint64_t number = 0; number < small_world_size(); number += step) {
    const SmallPair pair = small_pair(number), swapped{pair.b, pair.a};
    const SmallPair least = least_image_naive(swapped);
    std::uint64_t low = 0, high = small_world_size();  // the pairs before `low` are less
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      if (small_pair(middle) < least) low = middle + 1;
      else high = middle;
    }
    ASSERT_LT(low, small_world_size());
    EXPECT_EQ(small_pair(low), least) << number;
  }
}

// ---- kinds ----

TEST(SmallWorld, KindsAreThoseOfAStudyAndOfAPlainSearch) {
  constexpr std::uint64_t step = 2'749;
  std::set<std::string_view> met;
  for (std::uint64_t number = 0; number < small_world_size(); number += step) {
    const SmallPair pair = small_pair(number);
    const std::vector<std::string_view> kinds = small_kinds(pair);
    EXPECT_EQ(kinds, small_kinds_naive(pair)) << number;
    met.insert(kinds.begin(), kinds.end());
  }
  const std::vector<std::string_view> all = all_small_kinds();
  EXPECT_EQ(std::set<std::string_view>(all.begin(), all.end()).size(), all.size());
  for (const std::string_view kind : all) EXPECT_EQ(met.count(kind), 1U) << kind << " is in no pair of the slice";
  EXPECT_EQ(met.size(), all.size());
}

TEST(SmallWorld, CasesAreThePairs) {
  const Case pair = small_case(12'345);
  EXPECT_EQ(pair.id, "small_world::12345");
  EXPECT_EQ(points_of(small_pair(12'345).a), pair.a.points.exact());
  EXPECT_EQ(points_of(small_pair(12'345).b), pair.b.points.exact());
}

}  // namespace
