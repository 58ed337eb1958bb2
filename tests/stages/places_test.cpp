// SPDX-License-Identifier: GPL-3.0-or-later
// Places, normals and angles are near the exact ones, and charts lie as the exact method sorts
// them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "fathom/numbers.hpp"
#include "kernels/nearest.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "tests/stages/staged_cases.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "view/stages/parts.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {
namespace {

using testing::dot;
using testing::prepare;
using testing::Prepared;
using testing::staged_cases;

constexpr double near = 1e-9;
// Above this latitude a longitude means nothing.
constexpr double polar = std::numbers::pi / 2 - 1e-6;

mpq_class power_of_two(long exponent) {
  mpq_class one = 1;
  if (exponent >= 0) mpq_mul_2exp(one.get_mpq_t(), one.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(one.get_mpq_t(), one.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return one;
}

void check_vertices(const Body& input, const StagedBody& body, const StagedScale& scale, const std::string& id) {
  double extent = 0;
  for (const Place& p : body.vertices) extent = std::max({extent, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  for (std::size_t i = 0; i < body.vertices.size(); ++i) {
    const Point& p = input.points[body.ids[i]];
    const mpq_class factor = power_of_two(scale.exponent);
    const Point exact{(p.x - scale.center.x) * factor, (p.y - scale.center.y) * factor,
                      (p.z - scale.center.z) * factor};
    const Place& found = body.vertices[i];
    const mpq_class off =
        std::max({mpq_class(abs(exact.x - exact_value(found[0]))), mpq_class(abs(exact.y - exact_value(found[1]))),
                  mpq_class(abs(exact.z - exact_value(found[2])))});
    EXPECT_LE(off, exact_value(extent) * mpq_class(1, 1000000)) << id << ", vertex " << i;
  }
}

// A node is extreme at the corners of its facet, and no vertex is farther: of -A for A.
void check_nodes(const StagedBody& body, double sign, const std::string& id) {
  ASSERT_EQ(body.nodes.size(), body.facets.size()) << id;
  double extent = 0;
  for (const Place& p : body.vertices) extent = std::max({extent, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    EXPECT_NEAR(dot(body.nodes[i], body.nodes[i]), 1, near) << id;
    double most = -std::numeric_limits<double>::infinity();
    for (const Place& p : body.vertices) most = std::max(most, sign * dot(body.nodes[i], p));
    for (const Index v : body.facets[i])
      EXPECT_NEAR(sign * dot(body.nodes[i], body.vertices[v]), most, extent * 1e-9) << id << ", facet " << i;
  }
}

TEST(Places, AreNearTheExactOnes) {
  for (const Case& input : staged_cases({20})) {
    const Stages stages = stages_of(input.a, input.b);
    check_vertices(input.a, stages.a, stages.scale, input.id);
    check_vertices(input.b, stages.b, stages.scale, input.id);
    check_nodes(stages.a, -1, input.id);
    check_nodes(stages.b, 1, input.id);
  }
}

TEST(Places, CountFromTheBodiesFarFromTheOrigin) {
  const Body unit{families::find_family("random_sphere")->make(1, 12).a};
  for (const char* offset : {"0", "1", "1000000000000", "1e300", "-1e-300"}) {
    Body a = unit, b = unit;
    const mpq_class by = *parse_number(offset, Decimals::exact).value;
    for (Body* body : {&a, &b}) {
      for (Point& p : body->points.edit()) p.x += by;
    }
    const Stages stages = stages_of(a, b);
    EXPECT_EQ(stages.scale.center == Point(), abs(by) < 10) << offset;
    check_vertices(a, stages.a, stages.scale, offset);
  }
}

TEST(Places, AreScaledByAPowerOfTwo) {
  for (const char* size : {"1e-400", "1e-290", "1e-80", "1e80", "1e290", "1e400"}) {
    Case input = families::find_family("random_sphere")->make(1, 12);
    const mpq_class factor = *parse_number(size, Decimals::exact).value;
    for (Body* body : {&input.a, &input.b}) {
      for (Point& p : body->points.edit()) p = {p.x * factor, p.y * factor, p.z * factor};
    }
    const Stages stages = stages_of(input.a, input.b);
    EXPECT_EQ(stages.scale.exponent == 0, std::string(size).find("80") != std::string::npos) << size;
    check_vertices(input.a, stages.a, stages.scale, size);
    const double length = std::sqrt(dot(stages.contact.translation, stages.contact.translation));
    const mpq_class scaled = *stages.squared * power_of_two(2 * stages.scale.exponent);
    EXPECT_NEAR(length / root_binary64(scaled), 1, near) << size;
  }
}

TEST(Places, ThatFallTogetherAreNamed) {
  const auto tetrahedron = [](const mpq_class& size) {
    return Body{{{Point{0, 0, 0}, Point{size, 0, 0}, Point{0, size, 0}, Point{0, 0, size}}}};
  };
  const auto named = [](const Stages& stages, const std::string& body) {
    return std::ranges::any_of(
        stages.left_out, [&](const std::string& s) { return s.starts_with("Vertices of " + body + " fall together"); });
  };
  const Stages far = stages_of(tetrahedron(*parse_number("1e-300", Decimals::exact).value),
                               tetrahedron(*parse_number("1e300", Decimals::exact).value));
  EXPECT_TRUE(named(far, "A"));
  EXPECT_FALSE(named(far, "B"));
  const Stages close = stages_of(tetrahedron(1), tetrahedron(2));
  EXPECT_FALSE(named(close, "A"));
}

const StagedNode* node_in(const StagedDiagram& diagram, Index node) {
  const auto found = std::ranges::find(diagram.nodes, node, &StagedNode::node);
  return found == diagram.nodes.end() ? nullptr : &*found;
}

void check_arcs(const StagedDiagram& diagram, const StagedBody& body, const std::string& id) {
  for (const StagedArc& arc : diagram.arcs) {
    const auto& [first, last] = body.arcs[arc.edge];
    for (const std::optional<Index>& end : {arc.from, arc.to}) {
      if (!end) continue;
      EXPECT_TRUE(end == first || end == last) << id << ": an end is not the arc's";
      ASSERT_NE(node_in(diagram, *end), nullptr) << id << ": an end is in the other hemisphere";
    }
    if (!arc.from || !arc.to) continue;
    EXPECT_NE(arc.from, arc.to) << id;
    const StagedNode &left = *node_in(diagram, *arc.from), &right = *node_in(diagram, *arc.to);
    if (std::max(std::abs(left.latitude), std::abs(right.latitude)) > polar) continue;
    EXPECT_LE(left.longitude, right.longitude + near) << id;
  }
}

// Each node is in one chart, at its place; each end of an arc is one of its nodes, or in the other
// chart.
TEST(Charts, HoldTheDiagrams) {
  for (const Case& input : staged_cases({15})) {
    const Stages stages = stages_of(input.a, input.b);
    ASSERT_EQ(stages.charts.size(), 2U) << input.id;
    for (const bool of_a : {true, false}) {
      const StagedBody& body = of_a ? stages.a : stages.b;
      std::vector<int> nodes(body.nodes.size()), ends(body.arcs.size());
      for (const StagedChart& chart : stages.charts) {
        const StagedDiagram& diagram = of_a ? chart.a : chart.b;
        check_arcs(diagram, body, input.id);
        for (const StagedNode& node : diagram.nodes) {
          ++nodes.at(node.node);
          const Place& n = body.nodes[node.node];
          EXPECT_GE(dot(n, chart.z), 0) << input.id;
          EXPECT_NEAR(std::sin(node.latitude), dot(n, chart.v), near) << input.id;
          const double right = chart.v[1] * chart.z[2] * n[0];  // r = v x z, for v along y and z along the z-axis
          EXPECT_NEAR(std::sin(node.longitude) * std::cos(node.latitude), right, near) << input.id;
        }
        for (const StagedArc& arc : diagram.arcs) ends.at(arc.edge) += arc.from.has_value() + arc.to.has_value();
      }
      EXPECT_TRUE(std::ranges::all_of(nodes, [](int n) { return n == 1; }))
          << input.id << ": a node is not in one chart";
      for (const int n : ends) EXPECT_EQ(n, body.rank == 1 ? 0 : 2) << input.id << ": an arc has not its two ends";
    }
  }
}

double longitude_of(const StagedChart& chart, const StagedWall& wall) {
  const StagedNode* const node = node_in(wall.of_a ? chart.a : chart.b, wall.node);
  return node == nullptr || std::abs(node->latitude) > polar ? std::numeric_limits<double>::quiet_NaN()
                                                             : node->longitude;
}

TEST(Charts, HaveTheirWallsFromLeftToRight) {
  for (const Case& input : staged_cases({20})) {
    const Stages stages = stages_of(input.a, input.b);
    for (const StagedChart& chart : stages.charts) {
      EXPECT_EQ(chart.walls.size(), chart.a.nodes.size() + chart.b.nodes.size()) << input.id;
      double last = -4;
      for (const StagedWall& wall : chart.walls) {
        const double longitude = longitude_of(chart, wall);
        if (std::isnan(longitude)) continue;
        EXPECT_GE(longitude, last - near) << input.id;
        last = std::max(last, longitude);
      }
    }
  }
}

// Where the arcs of two edges cross, if not on the equator.
std::optional<double> longitude_of_crossing(const Prepared& p, Index e, Index f) {
  const polytope::Edge &of_a = p.a.edges[e], &of_b = p.b.edges[f];
  const Vector w =
      cross(p.a.vertices[of_a.to] - p.a.vertices[of_a.from], p.b.vertices[of_b.to] - p.b.vertices[of_b.from]);
  if (w.z == 0) return std::nullopt;
  // w or -w is in this hemisphere; to the right is x in the upper one, -x in the lower one: the
  // quotient is the same.
  return std::atan(kernels::ratio(w.x, w.z).get_d());
}

TEST(Strips, HoldTheCrossings) {
  std::size_t crossings = 0;
  for (const Case& input : staged_cases({30})) {
    const auto p = prepare(input);
    const Stages stages = stages_of(input.a, input.b);
    for (const StagedPair& pair : stages.pairs) {
      const StagedChart& chart = stages.charts[pair.chart];
      const double left = pair.strip[0] ? longitude_of(chart, chart.walls.at(*pair.strip[0])) : -4;
      const double right = pair.strip[1] ? longitude_of(chart, chart.walls.at(*pair.strip[1])) : 4;
      EXPECT_LT(pair.strip[0] ? *pair.strip[0] + 1 : 0, pair.strip[1] ? *pair.strip[1] + 1 : chart.walls.size() + 1)
          << input.id;
      if (std::isnan(left) || std::isnan(right)) continue;
      for (const Index e : pair.a) {
        for (const Index f : pair.b) {
          const std::optional<double> at = longitude_of_crossing(*p, e, f);
          if (!at) continue;
          EXPECT_TRUE(left - 1e-6 <= *at && *at <= right + 1e-6)
              << input.id << ": " << left << " " << *at << " " << right;
          ++crossings;
        }
      }
    }
  }
  EXPECT_GT(crossings, 5000U);
}

// Arcs end at their nodes, stay in their hemisphere, and are drawn as smooth lines; lines of a
// projection keep to the arc.

using std::numbers::pi;

Stages staged_sample(std::string_view family, unsigned size = 12) {
  const Case pair = families::find_family(family)->make(3, size);
  return stages::stages_of(pair.a, pair.b);
}

double distance(const Place& p, const Place& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

TEST(Arcs, EndAtTheirNodes) {
  for (const char* family : {"random_sphere", "boxes_aligned", "crossed_fans"}) {
    const Stages all = staged_sample(family);
    for (const stages::StagedBody* body : {&all.a, &all.b})
      for (Index edge = 0; edge < body->arcs.size(); ++edge) {
        const std::optional<SphereArc> arc = arc_of(*body, edge);
        ASSERT_TRUE(arc);
        EXPECT_LT(distance(arc->at(arc->begin), body->nodes[*body->arcs[edge][0]]), near);
        EXPECT_LT(distance(arc->at(arc->end), body->nodes[*body->arcs[edge][1]]), near);
        EXPECT_LT(arc->end, pi) << "law: the shorter of the two";
      }
  }
}

TEST(Arcs, OfFlatBodiesGoRound) {
  const Stages flat = staged_sample("polygon_segment");
  bool half = false, full = false;
  for (const stages::StagedBody* body : {&flat.a, &flat.b})
    for (Index edge = 0; edge < body->arcs.size(); ++edge) {
      const std::optional<SphereArc> arc = arc_of(*body, edge);
      ASSERT_TRUE(arc);
      (body->rank == 2 ? half : full) = true;
      EXPECT_NEAR(arc->end - arc->begin, body->rank == 2 ? pi : 2 * pi, near);
      for (double t = arc->begin; t <= arc->end; t += 0.1) {
        EXPECT_NEAR(dot(arc->at(t), body->circles[edge]), 0, near) << "law: on its circle";
        EXPECT_NEAR(dot(arc->at(t), arc->at(t)), 1, near);
      }
    }
  EXPECT_TRUE(half && full);
}

TEST(Arcs, PartsLieInTheirHemisphere) {
  const Stages all = staged_sample("random_sphere", 40);
  for (const stages::StagedChart& chart : all.charts) {
    const Place other{-chart.z[0], -chart.z[1], -chart.z[2]};
    for (Index edge = 0; edge < all.a.arcs.size(); ++edge) {
      const SphereArc arc = *arc_of(all.a, edge);
      double length = 0;
      for (const Place& z : {chart.z, other})
        for (const SphereArc& part : parts_in(arc, z)) {
          length += part.end - part.begin;
          for (double share = 0; share <= 1; share += 0.25)
            EXPECT_GE(dot(part.at(part.begin + share * (part.end - part.begin)), z), -near);
        }
      EXPECT_NEAR(length, arc.end - arc.begin, 1e-7) << "law: both hemispheres together hold the arc";
    }
  }
}

TEST(Arcs, LinesKeepToTheArc) {
  const SphereArc arc{{1, 0, 0}, {0, 1, 0}, 0, 3};
  const auto project = [](const Place& p) { return Pixel{300 * p[0], 300 * p[1]}; };
  const std::vector<Pixel> line = polyline(arc, project);
  EXPECT_LT(line.size(), 200u);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double x = (line[i - 1].x + line[i].x) / 2, y = (line[i - 1].y + line[i].y) / 2;
    EXPECT_NEAR(std::hypot(x, y), 300, 0.5) << "law: off by less than half a pixel";
  }
  EXPECT_NEAR(line.front().x, 300, near);
  EXPECT_NEAR(line.back().x, 300 * std::cos(3), near);
}

}  // namespace
}  // namespace fathom::stages

// The facets of P from nodes and crossings against the naive twin: the hull of all vertex
// differences.

namespace {

using namespace fathom;
using fathom::testing::cases_of_all_families;

std::vector<Case> polytopes() {
  std::vector<Case> cases = cases_of_all_families(2, 8);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  return cases;
}

/// Facets by normal, each by its corners as differences, ascending.
using Facets = std::map<Vector, std::set<Vector, LexicographicOrder>, LexicographicOrder>;

Facets naive(const polytope::Polytope& a, const polytope::Polytope& b) {
  std::vector<Vector> differences;
  for (const Vector& p : a.vertices)
    for (const Vector& q : b.vertices) differences.push_back(q - p);
  const polytope::Polytope hull = polytope::convex_hull(differences);
  Facets facets;
  for (const polytope::Facet& facet : hull.facets)
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) facets[facet.normal].insert(hull.vertices[hull.corners[i]]);
  return facets;
}

struct ExactRun {
  polytope::PlacedPair pair;
  kernels::Context context;
  std::unique_ptr<depth::ExactStages> exact;

  explicit ExactRun(const Case& input)
      : pair(polytope::place(input.a.points.exact(), input.b.points.exact())),
        exact(depth::exact_stages(context, pair)) {}
};

TEST(Sum, FacetsAreThoseOfTheHullOfAllDifferences) {
  std::size_t seen = 0;
  for (const Case& input : polytopes()) {
    const ExactRun run(input);
    if (!run.exact->depth.penetration()) continue;
    ++seen;
    const auto found = stages::sum_facets(*run.exact, 100'000);
    ASSERT_TRUE(found) << input.id;
    const depth::Hulls& hulls = run.exact->hulls;
    Facets facets;
    for (const stages::ExactSumFacet& facet : *found) {
      auto& corners = facets[facet.normal];
      for (const stages::SumCorner& corner : facet.corners) {
        const Vector p = hulls.b.vertices[corner.b] - hulls.a.vertices[corner.a];
        EXPECT_TRUE(corners.insert(p).second) << input.id << ", law: a corner occurs once";
        EXPECT_EQ(dot(facet.normal, p), facet.height) << input.id << ", law: corners lie in the plane";
      }
      for (std::size_t i = 0; i < facet.corners.size(); ++i) {
        const auto at = [&](std::size_t k) {
          const stages::SumCorner& corner = facet.corners[(i + k) % facet.corners.size()];
          return Vector(hulls.b.vertices[corner.b] - hulls.a.vertices[corner.a]);
        };
        EXPECT_GT(det(facet.normal, at(1) - at(0), at(2) - at(1)), 0)
            << input.id << ", law: counter-clockwise, strictly convex";
      }
    }
    EXPECT_EQ(facets.size(), found->size()) << input.id << ", law: one facet for each normal";
    EXPECT_EQ(facets, naive(hulls.a, hulls.b)) << input.id << ", law: the facets are those of the hull of differences";
  }
  EXPECT_GT(seen, 50U);
}

TEST(Sum, TheNearestAreThoseOfTheNaiveTwin) {
  for (const Case& input : polytopes()) {
    const stages::Stages staged_sample = stages::stages_of(input.a, input.b);
    const polytope::PlacedPair pair = polytope::place(input.a.points.exact(), input.b.points.exact());
    const depth::NaiveDepth twin = depth::naive_depth(pair.a.points(), pair.b.points());
    if (twin.status != Status::penetrating) {
      EXPECT_EQ(staged_sample.sum.kind, stages::SumKind::none) << input.id;
      continue;
    }
    const std::vector<stages::StagedFacet>& facets = staged_sample.sum.facets;
    const mpq_class unit = kernels::ratio(1, pair.denominator * pair.denominator);
    ASSERT_FALSE(facets.empty()) << input.id;
    EXPECT_EQ(facets.front().squared, mpq_class(twin.squared * unit))
        << input.id << ", law: the nearest is as far as the depth";
    EXPECT_TRUE(std::ranges::is_sorted(facets, {}, &stages::StagedFacet::squared)) << input.id << ", law: ascending";
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(facets, true, &stages::StagedFacet::optimal)),
              twin.directions.size())
        << input.id << ", law: the optimal ones are the optima";
  }
}

/// The input points of the edges of a pair.
std::vector<std::vector<std::uint32_t>> edges(const stages::StagedBody& body, const stages::Indices& of_pair) {
  std::vector<std::vector<std::uint32_t>> result;
  for (const stages::Index e : of_pair) {
    std::vector<std::uint32_t> ids{body.ids[body.edges[e][0]], body.ids[body.edges[e][1]]};
    std::ranges::sort(ids);
    result.push_back(ids);
  }
  return result;
}

TEST(Sum, EachEdgeEdgeFacetNamesItsOnePair) {
  std::size_t seen = 0;
  for (const Case& input : polytopes()) {
    const stages::Stages staged_sample = stages::stages_of(input.a, input.b);
    for (const stages::StagedFacet& facet : staged_sample.sum.facets) {
      if (facet.kind != stages::SumFacetKind::edges) continue;
      ++seen;
      ASSERT_EQ(facet.pairs.size(), 1U) << input.id << ", law: each crossing once";
      const stages::StagedPair& pair = staged_sample.pairs[facet.pairs.front()];
      const auto a = edges(staged_sample.a, pair.a), b = edges(staged_sample.b, pair.b);
      EXPECT_TRUE(std::ranges::count(a, facet.a) == 1 && std::ranges::count(b, facet.b) == 1)
          << input.id << ", law: the pair holds both edges";
    }
  }
  EXPECT_GT(seen, 1000U);
}

TEST(Sum, StopsAtTheMostFacets) {
  const Case cubes = families::families().front().make(1, 12);
  const ExactRun run(cubes);
  const auto all = stages::sum_facets(*run.exact, 100'000);
  ASSERT_TRUE(all);
  EXPECT_TRUE(stages::sum_facets(*run.exact, all->size()));
  EXPECT_FALSE(stages::sum_facets(*run.exact, all->size() - 1));
}

}  // namespace
