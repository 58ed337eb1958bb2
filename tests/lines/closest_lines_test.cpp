// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a chart against those of the polytopes; and what does not compile: an edge of A in
// place of one of B.

#include "reference/lines/closest_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "fathom/depth.hpp"
#include "reference/lines/cutting.hpp"
#include "reference/lines/grid.hpp"
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
static_assert(!std::is_invocable_v<decltype(offer_edges), B, gaussian::EdgeOfA, A, gaussian::EdgeOfB, Nearest>,
              "the bodies exchanged");
static_assert(!std::is_invocable_v<decltype(offer_edges), A, gaussian::ArcId, B, gaussian::ArcId, Nearest>,
              "arcs of diagrams");
static_assert(!std::is_invocable_v<decltype(offer_edges), A, chart::ChartArcOfA, B, chart::ChartArcOfB, Nearest>,
              "arcs of charts");
static_assert(!std::is_invocable_v<decltype(offer_edges), A, std::uint32_t, B, std::uint32_t, Nearest>, "numbers");

static_assert(
    std::is_invocable_v<decltype(offer_arcs), const LineScene&, chart::ChartArcOfA, chart::ChartArcOfB, Nearest>);
static_assert(
    !std::is_invocable_v<decltype(offer_arcs), const LineScene&, chart::ChartArcOfB, chart::ChartArcOfA, Nearest>);
static_assert(
    !std::is_invocable_v<decltype(offer_arcs), const LineScene&, gaussian::EdgeOfA, gaussian::EdgeOfB, Nearest>);
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
        EXPECT_TRUE(is_zero(cross(d, grids.prepared->b.vertices[edge.to] - grids.prepared->b.vertices[edge.from])))
            << input.id;
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

using testing::expect_equal;
using testing::prepare;
using testing::text;

// The filtered scan against exact arithmetic on every pair, one canonical pair at a time, so that
// ties and near ties that a better pair elsewhere would hide are seen as well.
TEST(ClosestLines, FilteredScanFindsWhatExactArithmeticFinds) {
  for (const Case& input : cases_of_all_families(2, 12)) {
    const PreparedGrids grids(input);
    for (std::size_t h = 0; h < 2; ++h) {
      const canonical::CanonicalSubsets& subsets = grids.subsets[h];
      kernels::NearestPlanes filtered, exact;
      kernels::Context context;
      closest_lines(context, subsets, grids.scenes[h], filtered, {.engine = ClosestLines::naive});
      for (std::size_t i = 0; i < subsets.size(); ++i) {
        for (const chart::ChartArcOfA e : subsets[i].a) {
          for (const chart::ChartArcOfB f : subsets[i].b) offer_arcs(grids.scenes[h], e, f, exact);
        }
      }
      expect_equal(filtered, exact, input.id);
      EXPECT_EQ(context.counters.pairs_evaluated, subsets.sums().product) << input.id;
    }
  }
}

// AGHRS, Lemma 2.2: the plane's distance from O is the distance of the two lines, here from the
// foot points of their common perpendicular.
TEST(ClosestLines, PlaneDistanceIsTheDistanceOfTheLines) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(1, 6)) {
    const auto p = prepare(input);
    const EdgeLinesOfA a(p->a, p->exponent);
    const EdgeLinesOfB b(p->b, p->exponent);
    for (const gaussian::EdgeOfA e : a.ids()) {
      for (const gaussian::EdgeOfB f : b.ids()) {
        kernels::NearestPlanes nearest;
        if (!offer_edges(a, e, b, f, nearest)) continue;
        // Feet p + s d and q + t g: <q + t g - p - s d, d> = <..., g> = 0, by Cramer's rule.
        const Vector d = a.direction(e), g = b.direction(f), r = b.point(f) - a.point(e);
        const mpz_class dd = dot(d, d), gg = dot(g, g), dg = dot(d, g), rd = dot(r, d), rg = dot(r, g);
        const mpz_class det2 = dd * gg - dg * dg;
        const mpz_class s = rd * gg - rg * dg, t = rd * dg - rg * dd;
        const Vector foot{det2 * r.x + t * g.x - s * d.x, det2 * r.y + t * g.y - s * d.y,
                          det2 * r.z + t * g.z - s * d.z};
        EXPECT_EQ(mpz_class(dot(foot, foot) * nearest.denominator()), mpz_class(nearest.numerator() * det2 * det2))
            << input.id;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(ClosestLines, SeparationHoldsWhereOIsInside) {
  std::size_t checked = 0;
  for (const Case& input : cases_of_all_families(3, 10)) {
    if (penetration_depth(input.a.points, input.b.points).status() != Status::penetrating) continue;
    const PreparedGrids grids(input);
    for (std::size_t h = 0; h < 2; ++h) {
      const kernels::Report report = validate_separation(grids.subsets[h], grids.scenes[h]);
      EXPECT_TRUE(report.ok()) << input.id << "\n" << text(report);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100U);
}

TEST(ClosestLines, SeparationIsNoticedToFail) {
  const PreparedGrids grids(families::find_family("random_disjoint")->make(1, 20));
  bool failed = false;
  for (std::size_t h = 0; h < 2; ++h) failed |= !validate_separation(grids.subsets[h], grids.scenes[h]).ok();
  EXPECT_TRUE(failed) << "disjoint bodies are not separated in every direction";
}

// In general position exact arithmetic is rare: it decides improvements and near ties only.
TEST(ClosestLines, FilterLeavesFewPairs) {
  const Case input = families::find_family("crossed_fans")->make(1, 300);
  Options options;
  options.closest_lines = ClosestLines::naive;
  const Depth depth = penetration_depth(input.a.points, input.b.points, options);
  EXPECT_GE(depth.counters.pairs_evaluated, 80000U);
  EXPECT_LE(depth.counters.pairs_exact, depth.counters.pairs_evaluated / 10);
}

// Ties below the precision of binary64, turned until the coordinates have 600 bits.
TEST(ClosestLines, TheFirstBitsOfLongCoordinatesLeaveFewPairs) {
  const Case input = families::find_family("crossed_vanishing_ties")->make(1, 600);
  families::Bodies bodies{input.a, input.b};
  for (const long k : {1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L, 10L})
    bodies = families::rotated(
        bodies, families::rotation((1L << 30) + k, (1L << 29) - k, (1L << 30) - 7 * k, (1L << 28) + 3 * k));
  const Options exact{.method = Method::exact, .closest_lines = ClosestLines::naive};
  const Depth depth = penetration_depth(bodies.a.points, bodies.b.points, exact);
  const Depth unturned = penetration_depth(input.a.points, input.b.points, exact);
  EXPECT_EQ(depth.squared(), unturned.squared());
  EXPECT_EQ(depth.optima().front().contact, unturned.optima().front().contact);
  EXPECT_GE(depth.counters.pairs_evaluated, 100000U);
  EXPECT_LE(depth.counters.pairs_exact, depth.counters.pairs_evaluated / 100);
}

// A trace says what a search did, and the search does the same without it.

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

// How the work of the cutting engine grows, in counts. The families are those of the closest-line
// study: rims with minima along an arc, the same at random, thin fans, near ties over a fixed and
// over a shrinking patch; and two of another kind, twisted chains and fillets.

struct Work {
  double edges = 0, crossings = 0, work = 0, memory = 0;
  Counters counters;
};

Work measure(const char* family, unsigned size, bool turned = false) {
  const Case input = families::find_family(family)->make(1, size);
  const PreparedGrids grids(turned ? testing::turned(input) : input);
  Work result;
  kernels::NearestPlanes nearest;
  kernels::Context context;
  for (std::size_t h = 0; h < 2; ++h) {
    closest_lines(context, grids.subsets[h], grids.scenes[h], nearest);
    const canonical::CanonicalSubsets::Sums sums = grids.subsets[h].sums();
    result.crossings += static_cast<double>(sums.product);
    result.memory += static_cast<double>(sums.a + sums.b);
  }
  result.edges = static_cast<double>(grids.a.size());
  const Counters& counters = context.counters;
  result.work = static_cast<double>(counters.cells + counters.block_tests + counters.pairs_evaluated);
  result.counters = counters;
  return result;
}

class Growth : public ::testing::TestWithParam<const char*> {};

TEST_P(Growth, OfWorkIsNearLinearWhileCrossingsAreQuadratic) {
  const Work small = measure(GetParam(), 512), large = measure(GetParam(), 4096);
  const double edges = large.edges / small.edges;
  EXPECT_GE(large.crossings / small.crossings, std::pow(edges, 1.9));
  EXPECT_LE(large.work / small.work, std::pow(edges, 1.2)) << small.work << " to " << large.work;
  EXPECT_LE(large.work, large.crossings / 20);
  // Where binary64 tells pairs apart, nothing is done in longer numbers.
  EXPECT_EQ(large.counters.wide_tests, 0U);
  // Storage: sum |A_i| + |B_i|, which may grow like n log^2 n.
  EXPECT_LE(large.memory / small.memory, std::pow(edges, 1.4));
}

// Ties beyond binary64: what the double filter cannot tell apart is told apart by blocks, in wide
// floats, and not pair by pair. How the bodies lie does not matter.
struct Ties {
  const char* family;
  bool turned;
};
class NearTies : public ::testing::TestWithParam<Ties> {};

TEST_P(NearTies, AreLookedAtByBlocks) {
  const auto [family, turned] = GetParam();
  const Work small = measure(family, 256, turned), large = measure(family, 8192, turned);
  const double edges = large.edges / small.edges;
  EXPECT_GE(large.crossings / small.crossings, std::pow(edges, 1.9));
  const auto pairs = [](const Work& w) { return static_cast<double>(w.counters.pairs_evaluated); };
  EXPECT_LE(pairs(large) / pairs(small), std::pow(edges, 1.3)) << pairs(small) << " to " << pairs(large);
  EXPECT_LE(large.work, large.crossings / 50);
  // Few are left to exact arithmetic, and those of the blocks that the offset test did are part of
  // all.
  EXPECT_LE(large.counters.pairs_exact, 8 * static_cast<std::uint64_t>(large.edges));
  EXPECT_GT(large.counters.wide_clears + large.counters.offset_blocks, 0U);
  EXPECT_LE(large.counters.wide_clears + large.counters.offset_blocks, large.counters.wide_tests);
  EXPECT_LE(large.counters.offset_pairs, large.counters.pairs_evaluated);
}

INSTANTIATE_TEST_SUITE_P(Families, NearTies,
                         ::testing::Values(Ties{"crossed_vanishing_ties", false}, Ties{"crossed_noisy_ties", false},
                                           Ties{"crossed_vanishing_ties", true}, Ties{"crossed_noisy_ties", true}),
                         [](const auto& info) {
                           return std::string(info.param.family) + (info.param.turned ? "_turned" : "");
                         });

// Where tests cost more than they can be worth, the rest of a grid is scanned: never far more work
// than every pair.
TEST(Fallback, WorkIsBoundedByTheCrossings) {
  const PreparedGrids grids(families::find_family("crossed_fans")->make(1, 400));
  for (const std::uint64_t allowance : {0ULL, 1ULL << 10, 1ULL << 20}) {
    kernels::NearestPlanes nearest;
    kernels::Context context;
    std::uint64_t crossings = 0;
    for (std::size_t h = 0; h < 2; ++h) {
      closest_lines(context, grids.subsets[h], grids.scenes[h], nearest,
                    {.cutting_size = {.few = 1, .base = 1, .allowance = allowance}});
      crossings += grids.subsets[h].sums().product;
    }
    const Counters& counters = context.counters;
    const std::uint64_t tests = 16 * counters.block_tests + 256 * counters.frame_tests + 4096 * counters.wide_tests;
    EXPECT_LE(tests, crossings / 8 + counters.grids_cut * (allowance + 5000)) << allowance;
    EXPECT_LE(counters.pairs_evaluated, 2 * crossings) << allowance;
    EXPECT_LE(counters.cells, crossings / 16) << allowance;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Growth,
                         ::testing::Values("crossed_prisms", "crossed_random_prisms", "crossed_fans", "crossed_ties",
                                           "crossed_shrinking_ties", "crossed_twists", "crossed_fillets",
                                           "crossed_parabolas"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace fathom::lines
