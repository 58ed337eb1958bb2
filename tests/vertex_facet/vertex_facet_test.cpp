// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/vertex_facet/vertex_facet.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <type_traits>

#include "tests/support/prepared.hpp"

namespace fathom::vertex_facet {
namespace {

using testing::cases_of_all_families;
using testing::prepare;
using testing::text;

static_assert(!std::is_constructible_v<VertexFacetPair, gaussian::Colour, gaussian::VertexId, gaussian::NodeId>,
              "vertex and facet exchanged");

TEST(VertexFacet, SweepFindsAnExtremeVertexForEveryFacet) {
  for (const Case& input : cases_of_all_families(6, 12)) {
    const auto p = prepare(input);
    std::size_t located = 0;
    for (const chart::Charts& charts : p->charts) {
      const std::vector<VertexFacetPair> pairs = vertex_facet_pairs(charts);
      const kernels::Report report = validate(pairs, charts, p->a, p->b);
      EXPECT_TRUE(report.ok()) << input.id << "\n" << text(report);
      located += pairs.size();
    }
    EXPECT_EQ(located, p->a.facets.size() + p->b.facets.size()) << input.id;
  }
}

TEST(VertexFacet, ValidateCatchesAWrongVertexAndAMissingFacet) {
  const auto p = prepare(families::find_family("random_sphere")->make(1, 20));
  const chart::Charts& charts = p->charts[0];
  std::vector<VertexFacetPair> pairs = vertex_facet_pairs(charts);
  pairs[0].vertex = gaussian::VertexId((pairs[0].vertex.value + 1) % 20);
  EXPECT_FALSE(validate(pairs, charts, p->a, p->b).ok());
  pairs = vertex_facet_pairs(charts);
  pairs.pop_back();
  EXPECT_FALSE(validate(pairs, charts, p->a, p->b).ok());
}

// Growth: comparisons a facet grow like the logarithm of the size. The charts make them; each edge
// has its orientation asked as well.
TEST(VertexFacet, ComparisonsGrowLikeNLogN) {
  for (const unsigned n : {64U, 256U, 1024U, 4096U}) {
    const Case input = families::find_family("random_sphere")->make(1, n);
    const auto p = prepare(input);
    const TierCounts& made = p->context.counters.predicates[static_cast<std::size_t>(Predicate::side_of_arc)];
    EXPECT_LE(made.calls, 6 * std::uint64_t{n} * std::bit_width(n)) << n;
  }
}

}  // namespace
}  // namespace fathom::vertex_facet
