// SPDX-License-Identifier: GPL-3.0-or-later
// A trace says what a search did, and the search does the same without it.
#include <gtest/gtest.h>

#include "reference/lines/closest_lines.hpp"
#include "tests/support/grids.hpp"

namespace fathom::lines {
namespace {

using testing::cases_of_all_families;
using testing::PreparedGrids;

// The same nearest planes and the same work.
TEST(SearchTrace, ChangesNothing) {
  std::size_t blocks = 0;
  std::vector<Case> cases = cases_of_all_families(1, 24);
  for (const char* name : {"crossed_fans", "crossed_ties"}) cases.push_back(families::find_family(name)->make(1, 100));
  for (const Case& input : cases) {
    const PreparedGrids grids(input);
    for (const ClosestLines engine : {ClosestLines::cutting, ClosestLines::sampled, ClosestLines::naive}) {
      kernels::NearestPlanes plain, traced;
      kernels::Context of_plain, of_traced;
      std::uint64_t evaluated = 0, cut = 0;
      for (std::size_t h = 0; h < 2; ++h) {
        ClosestLinesOptions options{.engine = engine, .scanned = 64, .cutting_size = {4, 2, 16}};
        closest_lines(of_plain, grids.subsets[h], grids.scenes[h], plain, options);
        SearchTrace trace;
        options.trace = &trace;
        closest_lines(of_traced, grids.subsets[h], grids.scenes[h], traced, options);
        ASSERT_EQ(trace.pairs.size(), grids.subsets[h].size()) << input.id;
        for (const SearchTrace::OfPair& pair : trace.pairs) {
          evaluated += pair.evaluated;
          cut += pair.treatment == Treatment::cut;
        }
        blocks += trace.blocks.size();
      }
      EXPECT_EQ(plain.directions(), traced.directions()) << input.id;
      EXPECT_EQ(of_plain.counters.pairs_evaluated, of_traced.counters.pairs_evaluated) << input.id;
      EXPECT_EQ(of_plain.counters.block_tests, of_traced.counters.block_tests) << input.id;
      EXPECT_EQ(of_plain.counters.cells, of_traced.counters.cells) << input.id;
      EXPECT_EQ(evaluated, of_traced.counters.pairs_evaluated) << input.id << ": of all pairs together";
      EXPECT_EQ(cut, of_traced.counters.grids_cut) << input.id;
    }
  }
  EXPECT_GT(blocks, 100U);
}

}  // namespace
}  // namespace fathom::lines
