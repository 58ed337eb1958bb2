// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest counterexample to each sentence of the paper that had to be mended.
//                                                                                [proofs/errata.md]
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "reference/canonical/canonical_subsets.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/signs.hpp"

namespace fathom::canonical {
namespace {

using testing::perturbations;
using testing::prepare;
using testing::unperturbed;

/// By the exact method.
Depth depth_of(const std::vector<Point>& a, const std::vector<Point>& b,
               const kernels::Perturbation& perturbation = {}) {
  kernels::Context context;
  return depth::penetration_depth(context, polytope::place(a, b), {.perturbation = perturbation});
}

// ---- the paper's rule, to the letter, on x-ranges ----

struct Range {
  int left, right;
  [[nodiscard]] bool contains(const Range& r) const { return left <= r.left && r.right <= right; }
  [[nodiscard]] bool contains(int x) const { return left <= x && x <= right; }
};
constexpr Range whole_line{std::numeric_limits<int>::min(), std::numeric_limits<int>::max()};

/// The strips between neighbouring walls, halved again and again: the skeleton of a segment tree.
using Walls = std::vector<int>;

Walls walls_of(std::initializer_list<std::vector<Range>> colours) {
  Walls walls;
  for (const std::vector<Range>& ranges : colours) {
    for (const Range& r : ranges) walls.insert(walls.end(), {r.left, r.right});
  }
  std::ranges::sort(walls);
  return walls;
}

/// Whether the tree, asked by `query`, reports `stored` for their crossing at x: at the node that
/// stores it and whose strip holds x, if an end of the query lies in the strip of the node's
/// parent. The root counts as having the whole line as parent.
bool paper_reports(const Walls& walls, const Range& stored, const Range& query, int x) {
  std::size_t first = 0, last = walls.size() + 1;
  const auto strip = [&] {
    return Range{first == 0 ? whole_line.left : walls[first - 1],
                 last > walls.size() ? whole_line.right : walls[last - 1]};
  };
  Range parent = whole_line;
  while (!stored.contains(strip())) {
    parent = strip();
    const std::size_t middle = (first + last) / 2;
    (x < walls[middle - 1] ? last : first) = middle;
  }
  return parent.contains(query.left) || parent.contains(query.right);
}

/// How often the paper's rule reports the crossing at x of e[0] and f[0]: by T_A, which stores the
/// e, and by T_B.
int paper_reports(const Walls& of_t_a, const Walls& of_t_b, const Range& e, const Range& f, int x) {
  return paper_reports(of_t_a, e, f, x) + paper_reports(of_t_b, f, e, x);
}

// ---- the same pictures as charts ----

struct Segment {
  int x1, y1, x2, y2;
};

/// A diagram whose arcs project to these segments of the plane z = 1. Of two that lie above one
/// another the higher one has the higher y1; the faces between them are numbered in that order.
gaussian::GaussianDiagram diagram_of(const std::vector<Segment>& segments) {
  gaussian::GaussianDiagram diagram;
  diagram.rank = 3;
  for (const Segment& s : segments) {
    const auto from = static_cast<std::uint32_t>(diagram.nodes.size());
    const Vector left{s.x1, s.y1, 1}, right{s.x2, s.y2, 1};
    diagram.nodes.emplace_back(left);
    diagram.nodes.emplace_back(right);
    const auto lower =
        static_cast<std::uint32_t>(std::ranges::count_if(segments, [&](const Segment& t) { return t.y1 < s.y1; }));
    diagram.arcs.push_back({kernels::Direction(cross(left, right)), gaussian::NodeId(from), gaussian::NodeId(from + 1),
                            gaussian::VertexId(lower + 1), gaussian::VertexId(lower)});
  }
  return diagram;
}

CanonicalSubsets family_of(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  const gaussian::GaussianDiagram diagram_a = diagram_of(a), diagram_b = diagram_of(b);
  kernels::Context context;
  const chart::Charts charts =
      chart::make_charts(context, diagram_a, diagram_b, chart::chart_frame(chart::Hemisphere::upper));
  CanonicalSubsets subsets = canonical_subsets(context, charts);
  EXPECT_TRUE(validate(subsets, charts).ok()) << testing::text(validate(subsets, charts));
  return subsets;
}

// ---- 1. one skeleton ----

const std::vector<Range> e_ranges{{0, 10}, {6, 12}, {2, 14}}, f_ranges{{5, 15}, {4, 9}, {1, 3}};

TEST(Errata, TwoSkeletonsLoseACrossingThatOneFinds) {
  const Walls of_e = walls_of({e_ranges}), of_f = walls_of({f_ranges}), common = walls_of({e_ranges, f_ranges});
  EXPECT_EQ(paper_reports(of_e, of_f, e_ranges[0], f_ranges[0], 7), 0)
      << "[0,10] and [5,15] cross at 7, and nobody sees it";
  EXPECT_GE(paper_reports(common, common, e_ranges[0], f_ranges[0], 7), 1);

  const CanonicalSubsets subsets = family_of({{0, 0, 10, 0}, {6, 100, 12, 100}, {2, 50, 14, 50}},
                                             {{5, -2, 15, 8}, {4, 200, 9, 200}, {1, 300, 3, 300}});
  ASSERT_EQ(subsets.sums().product, 1U);
  EXPECT_EQ(subsets[0].a[0], chart::ChartArcOfA(0)) << "the lowest of each colour";
  EXPECT_EQ(subsets[0].b[0], chart::ChartArcOfB(0));
}

/// All ways to give 2 (of_e + of_f) abscissae to the two colours: calls `look` with e, f, the two
/// sets of walls, and the crossing.
template <class Look>
void for_all_pictures(int of_e, int of_f, const Look& look) {
  const int walls = 2 * (of_e + of_f);
  for (unsigned mask = 0; mask < 1U << walls; ++mask) {
    if (std::popcount(mask) != 2 * of_e) continue;
    Walls e_walls, f_walls;  // even numbers; crossings are odd
    for (int i = 0; i < walls; ++i) (mask >> i & 1 ? e_walls : f_walls).push_back(2 * i);
    for (std::size_t i = 0; i < e_walls.size(); ++i) {
      for (std::size_t j = i + 1; j < e_walls.size(); ++j) {
        for (std::size_t k = 0; k < f_walls.size(); ++k) {
          for (std::size_t l = k + 1; l < f_walls.size(); ++l) {
            const Range e{e_walls[i], e_walls[j]}, f{f_walls[k], f_walls[l]};
            for (int x = std::max(e.left, f.left) + 1; x < std::min(e.right, f.right); x += 2)
              look(e, f, e_walls, f_walls, x);
          }
        }
      }
    }
  }
}

TEST(Errata, FewerThanSixSegmentsLoseNothing) {
  for (int segments = 2; segments <= 6; ++segments) {
    int lost = 0, lost_by_one_skeleton = 0;
    for (int of_e = 1; of_e < segments; ++of_e) {
      for_all_pictures(of_e, segments - of_e,
                       [&](const Range& e, const Range& f, const Walls& of_t_a, const Walls& of_t_b, int x) {
                         if (paper_reports(of_t_a, of_t_b, e, f, x) == 0) ++lost;
                         Walls common;
                         std::ranges::merge(of_t_a, of_t_b, std::back_inserter(common));
                         if (paper_reports(common, common, e, f, x) == 0) ++lost_by_one_skeleton;
                       });
    }
    EXPECT_EQ(lost > 0, segments == 6) << segments;
    EXPECT_EQ(lost_by_one_skeleton, 0) << segments;
  }
}

// ---- 2. each pair once ----

TEST(Errata, TwoSegmentsAreReportedTwiceByThePaperAndOnceHere) {
  const Range e{0, 10}, f{5, 15};
  const Walls common = walls_of({{e}, {f}});
  EXPECT_EQ(paper_reports(common, common, e, f, 7), 2);
  EXPECT_EQ(family_of({{0, 0, 10, 0}}, {{5, -2, 15, 8}}).sums().product, 1U);
}

// ---- 3. the colours of T_A and T_B ----

/// Of the family's part whose canonical subsets are of the first diagram's arcs, how many pairs
/// have one arc of the given colour.
std::size_t singles(const CanonicalSubsets& subsets, gaussian::Colour colour) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < subsets.size(); ++i) {
    const CanonicalPair pair = subsets[i];
    if (pair.stored_of == gaussian::Colour::a && (colour == gaussian::Colour::a ? pair.a.size() : pair.b.size()) == 1)
      ++count;
  }
  return count;
}

// One steep arc of A, m = 1, crosses n arcs of B, which all span it. (C5)(i) allows a number of
// pairs with |A_j| = 1 in F^A that depends on m alone. If T_A stores "the segments of E", which are
// B's, each of its pairs has |A_j| = 1, and there are more the larger n is.
TEST(Errata, WithTheTextsColoursPairsOfOneArcOfADependOnB) {
  for (const int k : {3, 5, 7}) {
    const int n = (1 << k) - 1;
    const std::vector<Segment> a{{-1, -1, 1, n}};
    std::vector<Segment> b;
    for (int i = 0; i < n; ++i) b.push_back({-10 - i, i, 10 + i, i});
    const CanonicalSubsets text = family_of(b, a), here = family_of(a, b);
    EXPECT_EQ(text.sums().product, static_cast<std::uint64_t>(n));
    EXPECT_EQ(here.sums().product, static_cast<std::uint64_t>(n));
    EXPECT_GE(singles(text, gaussian::Colour::b), static_cast<std::size_t>(k))
        << "A's arc is of the second colour here";
    EXPECT_LE(singles(here, gaussian::Colour::a), 2U);
  }
}

// ---- 4. "above" ----

struct Pair {
  gaussian::ArcId of_a, of_b;
};

/// The edges on which <u,.> is least on A and greatest on B.
Pair edges_towards(const polytope::Polytope& a, const polytope::Polytope& b, const Vector& u) {
  const auto edge = [](const polytope::Polytope& p, const Vector& up) {
    mpz_class highest = dot(p.vertices.front(), up);
    for (const Vector& v : p.vertices) highest = std::max(highest, dot(v, up));
    for (std::uint32_t i = 0; i < p.edges.size(); ++i) {
      if (dot(p.vertices[p.edges[i].from], up) == highest && dot(p.vertices[p.edges[i].to], up) == highest)
        return gaussian::ArcId(i);
    }
    ADD_FAILURE() << "no edge is extreme";
    return gaussian::ArcId::none();
  };
  return {edge(a, -u), edge(b, u)};
}

std::ptrdiff_t times_reported(const testing::Prepared& p, const Pair& pair) {
  std::ptrdiff_t times = 0;
  kernels::Context context;
  for (const chart::Charts& charts : p.charts) {
    const auto count = [](const chart::ColourChart& chart, const auto& ids, gaussian::ArcId arc) {
      return std::ranges::count_if(ids, [&](auto id) { return chart.arcs[chart::ChartArcId(id.value)].arc == arc; });
    };
    const CanonicalSubsets subsets = canonical_subsets(context, charts);
    for (std::size_t i = 0; i < subsets.size(); ++i) {
      times += count(charts.of.a, subsets[i].a, pair.of_a) * count(charts.of.b, subsets[i].b, pair.of_b);
    }
  }
  return times;
}

const Body edge_up{{{1, 1, 1}, {1, -1, -1}, {-5, 4, 0}, {-5, -4, 1}}},
    edge_down{{{-1, 1, -1}, {-1, -1, 1}, {5, 3, 0}, {5, -5, 1}}};

// The arcs of these two edges cross at (1,0,0), on the equator: the lines lie in the planes x = 1
// and x = -1, and no vertical meets both.
TEST(Errata, NoVerticalMeetsTheLinesOfACrossingOnTheEquator) {
  const Case input{"equator", edge_down, edge_up};
  EXPECT_EQ(depth_of(input.a.points, input.b.points).status(), Status::penetrating);
  for (const kernels::Perturbation& perturbation : perturbations()) {
    const auto p = prepare(input, perturbation);
    const Pair pair = edges_towards(p->a, p->b, {1, 0, 0});
    const gaussian::Arc& e = p->of_b.arcs[pair.of_b];
    const gaussian::Arc& f = p->minus_a.arcs[pair.of_a];
    const std::vector<kernels::Sign> signs =
        gaussian::strict_crossings(unperturbed().kernel, p->minus_a, f, p->of_b, e);
    ASSERT_EQ(signs.size(), 1U);
    const Vector normal = cross(f.circle.exact(), e.circle.exact());
    const Vector w = signs[0] == kernels::Sign::positive ? normal : -normal;
    EXPECT_TRUE(same_direction(w, {1, 0, 0}));
    const Vector step = p->b.vertices[e.above] - p->a.vertices[f.above];
    EXPECT_GT(dot(step, w), 0) << "C4 as a sign";
    EXPECT_EQ(times_reported(*p, pair), 1) << "in one of the two hemispheres";
  }
}

// Two cubes: parallel edges have arcs on one great circle, which cross or do not, as the
// perturbation likes. They span no plane.
TEST(Errata, PairsOfParallelEdgesAreReportedAndSpanNoPlane) {
  const Case input{"cubes",
                   {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}}},
                   {{{1, 1, 1}, {3, 1, 1}, {1, 3, 1}, {1, 1, 3}, {3, 3, 1}, {3, 1, 3}, {1, 3, 3}, {3, 3, 3}}}};
  std::size_t parallel = 0;
  for (const kernels::Perturbation& perturbation : perturbations()) {
    const auto p = prepare(input, perturbation);
    for (const chart::Charts& charts : p->charts) {
      for (const auto& [i, j] : crossings_naive(charts)) {
        if (is_zero(cross(p->minus_a.arcs[gaussian::ArcId(i.value)].circle.exact(),
                          p->of_b.arcs[gaussian::ArcId(j.value)].circle.exact())))
          ++parallel;
      }
    }
    EXPECT_EQ(depth_of(input.a.points, input.b.points, perturbation).squared(), 1);
  }
  EXPECT_GT(parallel, 0U);
}

// Moved until the edges touch, the bodies still intersect, and the paper's algorithm goes on: the
// lines meet, and neither is above.
TEST(Errata, LinesOfTouchingBodiesMeet) {
  const Body top{{{-1, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}}},
      bottom{{{0, -1, 0}, {0, 1, 0}, {1, 0, 1}, {-1, 0, 1}}};
  const Case input{"touching", top, bottom};
  const Depth depth = depth_of(input.a.points, input.b.points);
  EXPECT_EQ(depth.status(), Status::touching);
  EXPECT_EQ(depth.squared(), 0);
  const auto p = prepare(input);
  const Pair pair = edges_towards(p->a, p->b, {0, 0, -1});
  const gaussian::Arc& e = p->of_b.arcs[pair.of_b];
  const gaussian::Arc& f = p->minus_a.arcs[pair.of_a];
  EXPECT_EQ(times_reported(*p, pair), 1);
  EXPECT_EQ(dot(p->b.vertices[e.above] - p->a.vertices[f.above], cross(f.circle.exact(), e.circle.exact())), 0);
}

// ---- 5. what the depth is ----

const Body cube{{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}}},
    point{{{0, 0, 0}}};

// A point has no interior, so t = 0 satisfies the definition of pi(A,B); but O is inside P, and min
// d(O, boundary of P) is 1.
TEST(Errata, AFlatAHasAPositiveDepthThroughP) {
  const Depth depth = depth_of(point.points, cube.points), swapped = depth_of(cube.points, point.points);
  EXPECT_TRUE(depth.flat_a && !depth.flat_b);
  EXPECT_EQ(depth.status(), Status::penetrating);
  EXPECT_EQ(depth.squared(), 1);
  EXPECT_EQ(swapped.squared(), 1) << "a flat B: both definitions agree, and so do both orders here";
}

// A and B intersect, but so do all translates that slide in their plane: P is flat, O on its
// boundary as every point of P is.
TEST(Errata, IntersectingBodiesInOnePlaneOnlyTouch) {
  const Body square{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}}, beside{{{1, 1, 0}, {3, 1, 0}, {1, 3, 0}, {3, 3, 0}}};
  const Depth depth = depth_of(square.points, beside.points);
  EXPECT_EQ(depth.status(), Status::touching);
  EXPECT_EQ(depth.squared(), 0);
}

// Outside P the distance to its boundary is positive, and the depth is not.
TEST(Errata, ThroughTheDistanceToTheBoundaryOnlyInsideP) {
  const Depth depth = depth_of({{5, 0, 0}}, cube.points);
  EXPECT_EQ(depth.status(), Status::disjoint);
  EXPECT_EQ(depth.squared(), 0);
}

}  // namespace
}  // namespace fathom::canonical
