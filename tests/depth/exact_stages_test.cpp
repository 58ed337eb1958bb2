// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that are kept belong to the answer, and they are there for bodies that do not
// penetrate too.
#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/depth/penetration_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/catalogue.hpp"

namespace fathom::depth {
namespace {

TEST(ExactStages, AreThoseOfTheAnswer) {
  std::vector<Case> cases = testing::cases_of_all_families(1, 16);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t apart = 0;
  for (const Case& input : cases) {
    const polytope::PlacedPair pair = polytope::place(input.a.points, input.b.points);
    kernels::Context of_answer, of_stages;
    const Depth answer = penetration_depth(of_answer, pair);
    const std::unique_ptr<ExactStages> stages = exact_stages(of_stages, pair);
    EXPECT_EQ(stages->depth.status(), answer.status()) << input.id;
    EXPECT_EQ(stages->depth.optima(), answer.optima()) << input.id;
    EXPECT_EQ(stages->depth.counters.crossings, answer.counters.crossings) << input.id;
    EXPECT_EQ(stages->depth.counters.pairs_evaluated, answer.counters.pairs_evaluated) << input.id;
    EXPECT_EQ(stages->depth.counters.vertices_a, answer.counters.vertices_a) << input.id;
    EXPECT_EQ(stages->charts[0].of.a.diagram, &stages->diagrams.a) << input.id;
    std::uint64_t crossings = 0;
    for (std::size_t h = 0; h < 2; ++h) {
      EXPECT_EQ(testing::text(chart::validate(stages->charts[h])), "") << input.id;
      EXPECT_EQ(testing::text(canonical::validate(stages->subsets[h], stages->charts[h])), "") << input.id;
      EXPECT_EQ(stages->traces[h].pairs.size(), answer.penetration() ? stages->subsets[h].size() : 0) << input.id;
      crossings += stages->subsets[h].sums().product;
    }
    if (answer.penetration()) {
      EXPECT_EQ(crossings, answer.counters.crossings) << input.id;
      EXPECT_FALSE(stages->of_facets.directions().empty() &&
                   stages->hulls.a.facets.size() + stages->hulls.b.facets.size() > 0)
          << input.id;
    } else {
      EXPECT_EQ(answer.counters.crossings, 0U) << input.id;
      ++apart;
    }
  }
  EXPECT_GT(apart, 20U);
}

TEST(Stages, GoOnOnlyWhileLawsHoldIfThatIsAskedFor) {
  struct Count {
    int made = 0;
  };
  const auto make = [](kernels::Context&, Count& count) { ++count.made; };
  const auto insist = [](const Count& count) {
    if (count.made == 2) throw std::logic_error("broken law");
  };
  const Stage<Count> stages[] = {{make, nullptr}, {make, insist}, {make, insist}};
  kernels::Context context;
  Count looked_at, trusted;
  EXPECT_THROW(run_stages<Count>(context, looked_at, stages, true), std::logic_error);
  EXPECT_EQ(looked_at.made, 2);
  run_stages<Count>(context, trusted, stages, false);
  EXPECT_EQ(trusted.made, 3);
}

}  // namespace
}  // namespace fathom::depth
