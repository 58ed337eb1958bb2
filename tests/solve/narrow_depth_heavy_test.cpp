// SPDX-License-Identifier: GPL-3.0-or-later
// 2,000 pairs of every family: the expanding polytope with integers of fixed size against its twin
// in mpz_class, and the answer on narrow lattices against that on any lattice, in every field.
#include <gtest/gtest.h>

#include "reference/polytope/lattice.hpp"
#include "reference/solve/depth.hpp"
#include "tests/expanding/same_expansion.hpp"
#include "tests/solve/same_depth.hpp"

namespace fathom::solve {
namespace {

TEST(NarrowDepth, EqualsTheTwinsOnTwoThousandPairsOfEveryFamily) {
  Workspace workspace;
  Options options;
  options.workspace = &workspace;
  for (const families::Family& family : families::families()) {
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
      const Case input = family.make(seed, 4 + seed % 5);
      expanding::expect_same_expansions(input, workspace);
      kernels::Context context;
      const NarrowResult narrow = depth_on_narrow_lattice(context, input.a.points, input.b.points, options);
      if (narrow.depth)
        expect_equal(*narrow.depth, depth_by_method(context, polytope::place(input.a.points, input.b.points), {}));
      ASSERT_FALSE(::testing::Test::HasFailure()) << family.name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace fathom::solve
