// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "tests/support/prepared.hpp"
#include "tests/support/signs.hpp"
#include "verify/families/random.hpp"

namespace fathom::chart {
namespace {

using families::ratio;
using testing::cases_of_all_families;
using testing::kernel_of;
using testing::perturbed;
using testing::prepare;
using testing::text;
using testing::unperturbed;

// Each index finds what it is an index of, and nothing else.
template <class Vector, class Index>
concept Indexed = requires(const Vector vector, Index index) {
  vector[index];
};
static_assert(Indexed<decltype(gaussian::GaussianDiagram::arcs), gaussian::ArcId> &&
              Indexed<decltype(gaussian::GaussianDiagram::nodes), gaussian::NodeId>);
static_assert(!Indexed<decltype(gaussian::GaussianDiagram::arcs), gaussian::NodeId> &&
              !Indexed<decltype(gaussian::GaussianDiagram::nodes), gaussian::ArcId>);
static_assert(Indexed<decltype(ColourChart::arcs), ChartArcId> &&
              !Indexed<decltype(ColourChart::arcs), gaussian::ArcId>);
static_assert(Indexed<decltype(Charts::walls), WallId> && !Indexed<decltype(Charts::walls), gaussian::NodeId>);
static_assert(!Indexed<decltype(ColourChart::wall_of), WallId> &&
              !Indexed<decltype(ColourChart::place_of), ChartArcId>);
static_assert(!std::is_invocable_v<decltype(chart_frame), bool>, "a hemisphere is no bool");
static_assert(std::is_invocable_v<decltype(node_above_arc), const kernels::PerturbedKernel&, const Charts&,
                                  gaussian::Colour, gaussian::NodeId, gaussian::Colour, const ChartArc&>);
static_assert(!std::is_invocable_v<decltype(node_above_arc), const kernels::PerturbedKernel&, const Charts&,
                                   gaussian::Colour, gaussian::VertexId, gaussian::Colour, const ChartArc&>);

// Chart coordinates, as rationals up to one positive factor: y is the coordinate along v, x along v
// x z.
struct ChartPoint {
  mpq_class x, y;
};

ChartPoint project(const fathom::Vector& n, const Frame& frame) {
  const fathom::Vector right = cross(frame.v.exact(), frame.z.exact());
  const mpz_class depth = dot(n, frame.z.exact());
  return {ratio(dot(n, right), depth), ratio(dot(n, frame.v.exact()), depth)};
}

// Height of the arc's line over x: the chart point with right-coordinate x lies at X = v*y/|v|^2 +
// r*x/|r|^2 + z/|z|^2.
mpq_class height(const fathom::Vector& d, const Frame& frame, const mpq_class& x) {
  const fathom::Vector& v = frame.v.exact();
  const fathom::Vector& z = frame.z.exact();
  const fathom::Vector r = cross(v, z);
  const mpq_class along_v = ratio(dot(d, v), dot(v, v)), along_r = ratio(dot(d, r), dot(r, r)),
                  along_z = ratio(dot(d, z), dot(z, z));
  return -(along_r * x + along_z) / along_v;
}

TEST(ChartFrame, PoleIsNormalToTheVerticalIdentically) {
  for (const Hemisphere hemisphere : both_hemispheres) {
    const Frame frame = chart_frame(hemisphere);
    const kernels::Perturbation p;
    for (unsigned level = 0; level <= kernels::infinitesimals; ++level) {
      EXPECT_EQ(dot(p.moved(frame.v.exact(), kernels::Role::vertical, level),
                    p.moved(frame.z.exact(), kernels::Role::pole, level)),
                kernels::Infinitesimal());
    }
  }
}

// A tilt of v alone is not enough: around the point in which the verticals then meet, "left of" is
// cyclic.
TEST(ChartFrame, ArbitraryTiltIsNoOrder) {
  const kernels::Direction v(fathom::Vector{0, 8, 1}), z(fathom::Vector{0, 0, 1});
  const std::array<kernels::Direction, 3> n{kernels::Direction(fathom::Vector{3, 7, 1}),
                                            kernels::Direction(fathom::Vector{0, 12, 1}),
                                            kernels::Direction(fathom::Vector{-3, 7, 1})};
  const auto signs = unperturbed();
  for (const kernels::Direction& d : n) ASSERT_GT(signs.side_of_equator(d, z), 0);
  EXPECT_EQ(signs.x_order(n[0], n[1], v), signs.x_order(n[1], n[2], v));
  EXPECT_EQ(signs.x_order(n[1], n[2], v), signs.x_order(n[2], n[0], v));
}

TEST(Chart, LawsHoldOnEveryFamily) {
  for (const Case& input : cases_of_all_families(3, 10)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts)
      EXPECT_TRUE(validate(charts).ok()) << input.id << "\n" << text(validate(charts));
  }
}

TEST(Chart, WallsAreTotallyOrdered) {
  for (const Case& input : cases_of_all_families(2, 9)) {
    const auto p = prepare(input);
    std::size_t walls = 0;
    for (const Charts& charts : p->charts) {
      walls += charts.walls.size();
      const auto node = [&](std::uint32_t i) -> const kernels::Direction& {
        return charts.node(charts.walls[WallId(i)]);
      };
      for (std::uint32_t i = 0; i < charts.walls.size(); ++i) {
        for (std::uint32_t j = 0; j < charts.walls.size(); ++j) {
          if (i == j) continue;
          EXPECT_EQ(perturbed(charts.perturbation).x_order(node(i), node(j), charts.frame.v), i < j ? 1 : -1)
              << input.id;
        }
      }
    }
    EXPECT_EQ(walls, p->a.facets.size() + p->b.facets.size()) << input.id << ": every node lies in one hemisphere";
  }
}

// Nodes (K + a, -K + b, 0) beside the pole (1,1,0): abscissae grow with a + b, which is lost in the
// images when K is large.
TEST(Chart, WallsAreSortedEvenWhereAbscissaeInBinary64AreWrong) {
  families::Random random(5);
  const mpz_class k = mpz_class(1) << 60;
  gaussian::GaussianDiagram a, b;
  a.rank = b.rank = 3;
  for (long sum = 1; sum <= 400; ++sum) {
    const auto part = static_cast<long>(random.between(0, 5000));
    b.nodes.emplace_back(fathom::Vector{k + part, sum - part - k, 0});
  }
  const Frame frame{kernels::Direction(fathom::Vector{0, 0, 1}), kernels::Direction(fathom::Vector{1, 1, 0})};
  kernels::Context context;
  const Charts charts = make_charts(context, a, b, frame);
  ASSERT_EQ(charts.walls.size(), b.nodes.size());
  for (const WallId i : charts.walls.ids()) EXPECT_EQ(charts.walls[i].node, gaussian::NodeId(i.value));
  EXPECT_TRUE(validate(charts).ok()) << text(validate(charts));
}

// Where the input has different abscissae, the walls have their order.
TEST(Chart, PerturbationKeepsTheOrderOfDifferentAbscissae) {
  for (const Case& input : cases_of_all_families(2, 9)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      std::optional<mpq_class> last;
      for (const Wall& wall : charts.walls) {
        const fathom::Vector& n = charts.node(wall).exact();
        if (dot(n, charts.frame.z.exact()) == 0) continue;
        const mpq_class x = project(n, charts.frame).x;
        EXPECT_TRUE(!last || *last <= x) << input.id;
        last = x;
      }
    }
  }
}

// The two ways to compare arcs of one colour: at an end, and at any wall strictly inside both
// ranges.
TEST(Chart, OrderOfOneColourHoldsOnEveryCommonWall) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(2, 9)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      for (const gaussian::Colour c : {gaussian::Colour::a, gaussian::Colour::b}) {
        const auto covers = [&](const ChartArc& arc, WallId wall) {
          return (arc.left == at_infinity || charts.of[c].wall_of[arc.left] < wall) &&
                 (arc.right == at_infinity || wall < charts.of[c].wall_of[arc.right]);
        };
        for (const ChartArc& e : charts.of[c].arcs) {
          for (const ChartArc& f : charts.of[c].arcs) {
            if (e.arc == f.arc) continue;
            for (const WallId w : charts.walls.ids()) {
              if (!covers(e, w) || !covers(f, w)) continue;
              EXPECT_EQ(above_same_colour(kernel_of(charts), charts, c, e, f),
                        above_on_wall(kernel_of(charts), charts, c, e, c, f, charts.walls[w]))
                  << input.id << " arcs " << e.arc.value << ", " << f.arc.value << " wall " << w.value;
              ++compared;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 10000U);
}

// The list of arcs against the naive twin: all pairs that overlap.
TEST(Chart, ArcsAreListedInHeightOrder) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(3, 12)) {
    for (const kernels::Perturbation& perturbation : testing::perturbations()) {
      const auto p = prepare(input, perturbation);
      for (const Charts& charts : p->charts) {
        for (const gaussian::Colour c : {gaussian::Colour::a, gaussian::Colour::b}) {
          // Walls count from 1 here: 0 is at infinity on the left.
          const auto left = [&](const ChartArc& arc) {
            return arc.left == at_infinity ? 0 : charts.of[c].wall_of[arc.left].value + 1;
          };
          const auto right = [&](const ChartArc& arc) {
            return arc.right == at_infinity ? UINT32_MAX : charts.of[c].wall_of[arc.right].value + 1;
          };
          const std::vector<ChartArc>& arcs = charts.of[c].arcs;
          for (std::size_t i = 0; i < arcs.size(); ++i) {
            for (std::size_t j = i + 1; j < arcs.size(); ++j) {
              if (std::max(left(arcs[i]), left(arcs[j])) >= std::min(right(arcs[i]), right(arcs[j]))) continue;
              EXPECT_EQ(above_same_colour(kernel_of(charts), charts, c, arcs[j], arcs[i]), kernels::Sign::positive)
                  << input.id << " arcs " << i << ", " << j;
              ++compared;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 100000U);
}

TEST(Chart, ValidateCatchesABrokenHeightOrder) {
  for (const char* family : {"random_sphere", "crossed_fans", "boxes_aligned"}) {
    auto p = prepare(families::find_family(family)->make(1, 12));
    for (Charts& charts : p->charts) {
      for (const gaussian::Colour c : gaussian::both_colours) {
        std::vector<ChartArc>& arcs = charts.of[c].arcs;
        if (arcs.size() < 2) continue;
        std::ranges::reverse(arcs);
        EXPECT_FALSE(validate(charts).ok()) << family;
        std::ranges::reverse(arcs);
      }
    }
  }
}

TEST(Chart, ArcsThatLieAboveEachOtherInACircleAreRefused) {
  const auto p = prepare(families::find_family("random_sphere")->make(1, 12));
  gaussian::GaussianDiagram broken = p->of_b;
  std::swap(broken.arcs[gaussian::ArcId(0)].above, broken.arcs[gaussian::ArcId(0)].below);
  const auto charts = [&](Hemisphere hemisphere) {
    return make_charts(p->context, p->minus_a, broken, chart_frame(hemisphere));
  };
  EXPECT_THROW((charts(Hemisphere::upper), charts(Hemisphere::lower)), std::logic_error);
}

// The place of a node against every arc over its abscissa.
TEST(Chart, PlacesAgreeWithEveryArcOverTheNode) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(3, 12)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      for (const Wall& wall : charts.walls) {
        const gaussian::Colour c = gaussian::other(wall.colour);
        const WallId at = charts.of[wall.colour].wall_of[wall.node];
        const ChartArcId height = charts.of[wall.colour].place_of[wall.node].height;
        const kernels::IdVector<ChartArcId, ChartArc>& arcs = charts.of[c].arcs;
        for (const ChartArcId i : arcs.ids()) {
          if (arcs[i].left != at_infinity && charts.of[c].wall_of[arcs[i].left] > at) continue;
          if (arcs[i].right != at_infinity && charts.of[c].wall_of[arcs[i].right] < at) continue;
          const kernels::Sign side = node_above_arc(kernel_of(charts), charts, wall.colour, wall.node, c, arcs[i]);
          EXPECT_EQ(i < height, side == kernels::Sign::positive);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 20000U);
}

// Where exact heights on the input differ, the perturbed order is theirs.
TEST(Chart, OrderOnWallsIsTheOrderOfHeights) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(1, 8)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      const auto vertical = [&](const fathom::Vector& d) { return dot(d, charts.frame.v.exact()) == 0; };
      for (const ChartArc& e : charts.of.a.arcs) {
        for (const ChartArc& f : charts.of.b.arcs) {
          const fathom::Vector& d_e = charts.of.a.circle(e).exact();
          const fathom::Vector& d_f = charts.of.b.circle(f).exact();
          if (vertical(d_e) || vertical(d_f)) continue;
          const auto difference = [&](const mpq_class& x) {
            return sgn(mpq_class(height(d_e, charts.frame, x) - height(d_f, charts.frame, x)));
          };
          for (const Wall& wall : charts.walls) {
            const fathom::Vector& n = charts.node(wall).exact();
            if (dot(n, charts.frame.z.exact()) == 0) continue;
            const int exact = difference(project(n, charts.frame).x);
            if (exact == 0) continue;
            EXPECT_EQ(kernels::to_int(above_on_wall(kernel_of(charts), charts, gaussian::Colour::a, e,
                                                    gaussian::Colour::b, f, wall)),
                      exact)
                << input.id;
            ++compared;
          }
          // Heights are linear in x: far to the left the slopes decide.
          const mpq_class slope_e = height(d_e, charts.frame, 1) - height(d_e, charts.frame, 0);
          const mpq_class slope_f = height(d_f, charts.frame, 1) - height(d_f, charts.frame, 0);
          if (slope_e == slope_f) continue;
          EXPECT_EQ(kernels::to_int(
                        above_far_left(kernel_of(charts), charts, gaussian::Colour::a, e, gaussian::Colour::b, f)),
                    slope_e < slope_f ? 1 : -1)
              << input.id;
        }
      }
    }
  }
  EXPECT_GT(compared, 10000U);
}

TEST(Chart, FaceBesideAnArcPrefersItsVertex) {
  for (const Case& input : cases_of_all_families(1, 8)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      for (const ChartArc& arc : charts.of.b.arcs) {
        const fathom::Vector up =
            p->b.vertices[charts.of.b.vertex_above(arc)] - p->b.vertices[charts.of.b.vertex_below(arc)];
        EXPECT_GE(dot(up, charts.frame.v.exact()), 0) << input.id;
      }
      for (const ChartArc& arc : charts.of.a.arcs) {
        const fathom::Vector down =
            p->a.vertices[charts.of.a.vertex_above(arc)] - p->a.vertices[charts.of.a.vertex_below(arc)];
        EXPECT_LE(dot(down, charts.frame.v.exact()), 0) << input.id << ": the diagram is that of -A";
      }
    }
  }
}

// Boxes: every normal on an axis, every edge parallel to one. All of it is resolved, and recorded
// by monomial.
TEST(Chart, RecordsWhichMonomialDecided) {
  const auto p = prepare(families::find_family("boxes_aligned")->make(1, 8));
  const PredicateCounts& counts = p->context.counters.predicates;
  for (const Predicate predicate : {Predicate::side_of_equator, Predicate::x_order, Predicate::side_of_arc}) {
    const TierCounts& tiers = counts[static_cast<std::size_t>(predicate)];
    std::uint64_t decided = 0;
    for (const auto& [monomial, count] : tiers.decided) decided += count;
    EXPECT_GT(tiers.zero, 0U);
    EXPECT_EQ(decided, tiers.zero) << "each zero is decided by one monomial";
  }
}

TEST(Chart, QuestionsWithinABodyThatNothingResolvesAreRefused) {
  const auto p = prepare(families::find_family("boxes_aligned")->make(1, 8));
  const Charts& charts = p->charts[0];
  const ChartArc& arc = charts.of.b.arcs.front();
  const gaussian::NodeId end = arc.left != at_infinity ? arc.left : arc.right;
  EXPECT_THROW(
      std::ignore = node_above_arc(kernel_of(charts), charts, gaussian::Colour::b, end, gaussian::Colour::b, arc),
      std::logic_error);
}

}  // namespace
}  // namespace fathom::chart
