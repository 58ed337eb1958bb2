// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/canonical/canonical_subsets.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <type_traits>

#include "fathom/depth.hpp"
#include "reference/lines/closest_lines.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::canonical {
namespace {

using testing::cases_of_all_families;
using testing::prepare;
using testing::Prepared;
using testing::text;

static_assert(!std::is_constructible_v<CanonicalPair, gaussian::Colour, bool, Strip,
                                       std::span<const chart::ChartArcOfB>, std::span<const chart::ChartArcOfA>>,
              "the arcs of A and of B exchanged");

// C1 to C4 as the paper states them, under every perturbation, and the sum of products counts the
// crossings.
TEST(CanonicalSubsets, ConditionsHoldOnEveryFamilyUnderEveryPerturbation) {
  for (const Case& input : cases_of_all_families(3, 10)) {
    const bool overlap = penetration_depth(input.a.points, input.b.points).status() == Status::penetrating;
    for (const kernels::Perturbation& perturbation : testing::perturbations()) {
      const auto p = prepare(input, perturbation);
      const lines::EdgeLinesOfA a(p->a, p->exponent);
      const lines::EdgeLinesOfB b(p->b, p->exponent);
      for (const chart::Charts& charts : p->charts) {
        const CanonicalSubsets subsets = canonical_subsets(p->context, charts);
        const kernels::Report report = validate(subsets, charts);
        EXPECT_TRUE(report.ok()) << input.id << "\n" << text(report);
        EXPECT_EQ(subsets.sums().product, crossings_naive(charts).size()) << input.id;
        const kernels::Report separation = lines::validate_separation(subsets, lines::LineScene(charts, a, b));
        EXPECT_TRUE(!overlap || separation.ok()) << input.id << "\n" << text(separation);
      }
    }
  }
}

// In general position nothing is symbolic, and exact arithmetic is rare.
TEST(CanonicalSubsets, GeneralPositionNeedsNoInfinitesimals) {
  for (const char* family : {"random_sphere", "random_ball", "crossed_bands"}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const Case input = families::find_family(family)->make(seed, 60);
      const auto p = prepare(input);
      for (const chart::Charts& charts : p->charts)
        EXPECT_TRUE(validate(canonical_subsets(p->context, charts), charts).ok()) << input.id;
      const PredicateCounts& counts = p->context.counters.predicates;
      for (std::size_t i = 0; i < counts.size(); ++i) {
        EXPECT_EQ(counts[i].zero, 0U) << input.id << ", " << predicate_names[i];
        EXPECT_LE(1000 * counts[i].exact, counts[i].calls) << input.id << ", " << predicate_names[i];
      }
    }
  }
}

// (C5) and equation (1), measured: sums stay below (m + n) log^2(m + n), and do not follow the
//      number of crossings.
TEST(CanonicalSubsets, SumsAreNearLinear) {
  for (const char* family : {"random_sphere", "crossed_fans", "crossed_bands"}) {
    for (const unsigned n : {32U, 128U, 512U}) {
      const auto p = prepare(families::find_family(family)->make(1, n));
      const double edges = static_cast<double>(p->a.edges.size() + p->b.edges.size());
      double sum = 0, crossings = 0;
      for (const chart::Charts& charts : p->charts) {
        const CanonicalSubsets::Sums sums = canonical_subsets(p->context, charts).sums();
        sum += static_cast<double>(sums.a + sums.b);
        crossings += static_cast<double>(sums.product);
      }
      EXPECT_LE(sum, edges * std::log2(edges) * std::log2(edges)) << family << " " << n;
      if (std::string(family) == "crossed_fans") {
        EXPECT_GE(crossings, 0.9 * n * n);
        EXPECT_LE(sum, 8 * edges) << n;
      }
      RecordProperty(std::string(family) + std::to_string(n), std::to_string(sum / edges) + " ids an edge");
    }
  }
}

TEST(CanonicalSubsets, ComparisonsGrowLikeNLogSquaredN) {
  for (const unsigned n : {64U, 256U, 1024U}) {
    const auto p = prepare(families::find_family("random_sphere")->make(1, n));
    kernels::Context context;
    for (const chart::Charts& charts : p->charts) canonical_subsets(context, charts);
    std::uint64_t calls = 0;
    for (const TierCounts& tiers : context.counters.predicates) calls += tiers.calls;
    EXPECT_LE(calls, 6 * std::uint64_t{n} * std::bit_width(n) * std::bit_width(n)) << n;
  }
}

// Hand-made charts: stored over [0,10], query over [5,15], crossing at 7, with further walls of
// either colour around it. One skeleton finds it, whatever other walls there are; errata_test.cpp
// shows what two skeletons of their own lose.
TEST(CanonicalSubsets, OneSkeletonFindsACrossingAmongWallsOfBothColours) {
  const auto node = [](long x, long y) { return kernels::Direction(Vector{x, y, 1}); };
  const auto arc = [&](kernels::IdVector<gaussian::NodeId, kernels::Direction>& nodes, kernels::Direction from,
                       kernels::Direction to) {
    const auto first = static_cast<std::uint32_t>(nodes.size());
    kernels::Direction circle(cross(from.exact(), to.exact()));
    nodes.push_back(std::move(from));
    nodes.push_back(std::move(to));
    // Of the faces only the order from bottom to top matters.
    return gaussian::Arc{std::move(circle), gaussian::NodeId(first), gaussian::NodeId(first + 1),
                         gaussian::VertexId(first + 2), gaussian::VertexId(first)};
  };
  gaussian::GaussianDiagram a, b;
  a.rank = b.rank = 3;
  // Walls of their own besides the two arcs: the stored colour's at 6 and 12, the other's at 4 and
  // 9, far above.
  a.arcs = {arc(a.nodes, node(0, 0), node(10, 0)), arc(a.nodes, node(6, 100), node(12, 100))};
  b.arcs = {arc(b.nodes, node(5, -2), node(15, 8)), arc(b.nodes, node(4, 200), node(9, 200))};
  // x runs along v x z = (1,0,0) for v = (0,1,0), z = (0,0,1).
  kernels::Context context;
  const chart::Charts charts = chart::make_charts(context, a, b, chart::chart_frame(chart::Hemisphere::upper));
  EXPECT_EQ(
      crossings_naive(charts),
      (std::vector<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>>{{gaussian::EdgeOfA(0), gaussian::EdgeOfB(0)}}));
  const kernels::Report report = validate(canonical_subsets(context, charts), charts);
  EXPECT_TRUE(report.ok()) << text(report);
}

// The order of crossings and their sense, broken on purpose: a copy of the charts that says
// otherwise.
TEST(CanonicalSubsets, ValidateCatchesABrokenGrid) {
  const auto p = prepare(families::find_family("crossed_fans")->make(1, 12));
  const chart::Charts& charts = p->charts[0];
  const CanonicalSubsets subsets = canonical_subsets(p->context, charts);
  ASSERT_TRUE(validate(subsets, charts).ok()) << text(validate(subsets, charts));
  // Orientations of all arcs of one colour reversed: senses and orders no longer fit.
  chart::Charts turned = charts;
  for (chart::ChartArc& arc : turned.of.b.arcs) arc.flipped = !arc.flipped;
  const kernels::Report report = validate(subsets, turned);
  const auto says = [&](const char* words) {
    return std::ranges::any_of(report.faults,
                               [&](const std::string& fault) { return fault.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("in the other sense"));
  EXPECT_TRUE(says("not in the order in which they cross"));
  EXPECT_TRUE(says("not in height order"));
}

// Both senses occur, and each query set is split by them.
TEST(CanonicalSubsets, BothSensesOccur) {
  std::array<std::size_t, 2> pairs{};
  const auto p = prepare(families::find_family("random_sphere")->make(1, 60));
  for (const chart::Charts& charts : p->charts) {
    const CanonicalSubsets subsets = canonical_subsets(p->context, charts);
    for (std::size_t i = 0; i < subsets.size(); ++i) ++pairs[subsets[i].rising ? 1 : 0];
  }
  EXPECT_GT(pairs[0], 10U);
  EXPECT_GT(pairs[1], 10U);
}

// Hears the shares, and stops the work at one of them.
class Watch : public Monitor {
 public:
  explicit Watch(double stop) : stop_(stop) {}
  void report(std::string_view stage, double share) override {
    EXPECT_EQ(stage, "canonical subsets");
    shares.push_back(share);
  }
  [[nodiscard]] bool stopped() override { return shares.back() >= stop_; }

  std::vector<double> shares;

 private:
  double stop_;
};

// Progress rises from 0 to 1 at most, and a refusal ends the work.
TEST(CanonicalSubsets, StopsWhenTold) {
  const auto p = prepare(families::find_family("random_sphere")->make(1, 2000));
  Watch all(2), some(0.25);
  kernels::Context heard(&all), stopped(&some);
  canonical_subsets(heard, p->charts[0]);
  EXPECT_GT(all.shares.size(), 5U);
  EXPECT_TRUE(std::ranges::is_sorted(all.shares));
  EXPECT_TRUE(all.shares.front() == 0 && all.shares.back() <= 1);
  EXPECT_THROW(canonical_subsets(stopped, p->charts[0]), Interrupted);
  EXPECT_LT(some.shares.size(), all.shares.size());
}

TEST(CanonicalSubsets, TwoFullLinesCrossOnceInEachHemisphere) {
  Case input{"segments", {{{0, 0, 0}, {1, 0, 0}}}, {{{0, 0, 0}, {0, 1, 0}}}};
  const auto p = prepare(input);
  for (const chart::Charts& charts : p->charts) {
    const CanonicalSubsets subsets = canonical_subsets(p->context, charts);
    EXPECT_EQ(subsets.sums().product, 1U);
    EXPECT_TRUE(validate(subsets, charts).ok()) << text(validate(subsets, charts));
  }
}

}  // namespace
}  // namespace fathom::canonical
