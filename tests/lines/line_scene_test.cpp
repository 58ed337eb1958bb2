// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a chart against those of the polytopes; and what does not compile: an edge of A in place of one of B.
#include "reference/lines/line_scene.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "reference/lines/line_search.hpp"
#include "tests/support/grids.hpp"

namespace fathom::lines {
namespace {

using testing::cases_of_all_families;
using testing::PreparedGrids;

using A = const EdgeLinesOfA&;
using B = const EdgeLinesOfB&;
using Nearest = kernels::NearestPlanes&;
static_assert(std::is_invocable_v<decltype(offer_edges), A, gaussian::EdgeOfA, B, gaussian::EdgeOfB, Nearest>);
static_assert(!std::is_invocable_v<decltype(offer_edges), A, gaussian::EdgeOfB, B, gaussian::EdgeOfA, Nearest>,
              "the edges of A and of B exchanged");
static_assert(!std::is_invocable_v<decltype(offer_edges), B, gaussian::EdgeOfA, A, gaussian::EdgeOfB, Nearest>, "the bodies exchanged");
static_assert(!std::is_invocable_v<decltype(offer_edges), A, gaussian::ArcId, B, gaussian::ArcId, Nearest>, "arcs of diagrams");
static_assert(!std::is_invocable_v<decltype(offer_edges), A, chart::ChartArcOfA, B, chart::ChartArcOfB, Nearest>, "arcs of charts");
static_assert(!std::is_invocable_v<decltype(offer_edges), A, std::uint32_t, B, std::uint32_t, Nearest>, "numbers");

static_assert(std::is_invocable_v<decltype(offer_arcs), const LineScene&, chart::ChartArcOfA, chart::ChartArcOfB, Nearest>);
static_assert(!std::is_invocable_v<decltype(offer_arcs), const LineScene&, chart::ChartArcOfB, chart::ChartArcOfA, Nearest>);
static_assert(!std::is_invocable_v<decltype(offer_arcs), const LineScene&, gaussian::EdgeOfA, gaussian::EdgeOfB, Nearest>);
static_assert(std::is_invocable_v<decltype(&LineSearch::offer), LineSearch, chart::ChartArcOfA, chart::ChartArcOfB>);
static_assert(!std::is_invocable_v<decltype(&LineSearch::offer), LineSearch, chart::ChartArcOfB, chart::ChartArcOfA>);
static_assert(!std::is_constructible_v<LineScene, const chart::Charts&, B, A>);

TEST(LineScene, CarriesTheEdgesOfTheArcsDirectedUpward) {
  std::size_t flipped = 0, arcs = 0;
  for (const Case& input : cases_of_all_families(1, 10)) {
    const PreparedGrids grids(input);
    for (std::size_t h = 0; h < 2; ++h) {
      const chart::Charts& charts = grids.prepared->charts[h];
      const ChartLines<gaussian::Colour::b>& lines = grids.scenes[h].b;
      ASSERT_EQ(lines.images().size(), charts.of.b.arcs.size());
      for (const chart::ChartArcId i : charts.of.b.arcs.ids()) {
        const chart::ChartArcOfB line(i.value);
        const polytope::Edge& edge = grids.prepared->b.edges[charts.of.b.arcs[i].arc.value];
        EXPECT_EQ(lines.point(line), grids.prepared->b.vertices[edge.from]) << input.id;
        const Vector d = lines.direction(line);
        EXPECT_TRUE(is_zero(cross(d, grids.prepared->b.vertices[edge.to] - grids.prepared->b.vertices[edge.from]))) << input.id;
        EXPECT_GE(dot(d, charts.frame.v.exact()), 0) << input.id << ", directed downward";
        kernels::LineImages image(lines.images().exponent());
        image.push_back(lines.point(line), d);
        EXPECT_EQ(image.dy[0], lines.images().dy[i.value]) << input.id << ", the image turned otherwise";
        flipped += charts.of.b.arcs[i].flipped;
        ++arcs;
      }
    }
  }
  EXPECT_GT(flipped, arcs / 10);
  EXPECT_LT(flipped, arcs - arcs / 10);
}

}  // namespace
}  // namespace fathom::lines
