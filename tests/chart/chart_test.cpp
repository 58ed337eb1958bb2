// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernels/filter.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/random.hpp"

namespace fathom {
namespace {

using families::ratio;
using testing::cases_of_all_families;
using testing::prepare;
using testing::text;

// Chart coordinates, as rationals up to one positive factor: y is the coordinate along v, x along v x z.
struct ChartPoint {
  mpq_class x, y;
};

ChartPoint project(const Vector& n, const Frame& frame) {
  const Vector right = cross(frame.v.exact(), frame.z.exact());
  const mpz_class depth = dot(n, frame.z.exact());
  return {ratio(dot(n, right), depth), ratio(dot(n, frame.v.exact()), depth)};
}

// Height of the arc's line over x: the chart point with right-coordinate x lies at X = v*y/|v|^2 + r*x/|r|^2 + z/|z|^2.
mpq_class height(const Vector& d, const Frame& frame, const mpq_class& x) {
  const Vector& v = frame.v.exact();
  const Vector& z = frame.z.exact();
  const Vector r = cross(v, z);
  const mpq_class along_v = ratio(dot(d, v), dot(v, v)), along_r = ratio(dot(d, r), dot(r, r)), along_z = ratio(dot(d, z), dot(z, z));
  return -(along_r * x + along_z) / along_v;
}

TEST(ChartFrame, PoleIsNormalToTheVertical) {
  for (unsigned attempt = 0; attempt < 100; ++attempt) {
    for (const bool lower : {false, true}) {
      const Frame frame = chart_frame(attempt, lower);
      EXPECT_EQ(dot(frame.v.exact(), frame.z.exact()), 0);
      EXPECT_NE(frame.v.exact(), chart_frame(attempt + 1, lower).v.exact());
    }
    EXPECT_EQ(chart_frame(attempt, false).z.exact(), -chart_frame(attempt, true).z.exact());
  }
}

TEST(Chart, LawsHoldOnEveryFamily) {
  for (const Case& input : cases_of_all_families(3, 10)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) EXPECT_TRUE(validate(charts).ok()) << input.id << "\n" << text(validate(charts));
  }
}

TEST(Chart, WallsAreTheDistinctAbscissae) {
  for (const Case& input : cases_of_all_families(2, 9)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      std::set<mpq_class> distinct;
      for (const Colour c : {Colour::a, Colour::b}) {
        for (const Direction& n : charts.diagram(c).nodes) {
          if (dot(n.exact(), charts.frame.z.exact()) > 0) distinct.insert(project(n.exact(), charts.frame).x);
        }
      }
      ASSERT_EQ(charts.walls.size(), distinct.size()) << input.id;
      std::size_t i = 0;
      for (const mpq_class& x : distinct) {
        const Charts::Wall wall = charts.walls[i++];
        EXPECT_EQ(project(charts.node(wall.colour, wall.node).exact(), charts.frame).x, x) << input.id;
      }
    }
  }
}

// Left and right ends of an arc as abscissae; none at infinity.
std::pair<std::optional<mpq_class>, std::optional<mpq_class>> range(const Charts& charts, Colour c, const ChartArc& arc) {
  const auto x = [&](std::uint32_t node) {
    return node == at_infinity ? std::nullopt : std::optional(project(charts.node(c, node).exact(), charts.frame).x);
  };
  return {x(arc.left), x(arc.right)};
}

// An abscissa strictly inside both ranges, if there is one.
std::optional<mpq_class> common_abscissa(const Charts& charts, Colour c, const ChartArc& e, const ChartArc& f) {
  const auto [e_left, e_right] = range(charts, c, e);
  const auto [f_left, f_right] = range(charts, c, f);
  const std::optional<mpq_class> left = !e_left ? f_left : !f_left ? e_left : std::optional(std::max(*e_left, *f_left));
  const std::optional<mpq_class> right = !e_right ? f_right : !f_right ? e_right : std::optional(std::min(*e_right, *f_right));
  if (left && right) return *left < *right ? std::optional<mpq_class>((*left + *right) / 2) : std::nullopt;
  return left ? std::optional<mpq_class>(*left + 1) : right ? std::optional<mpq_class>(*right - 1) : std::optional<mpq_class>(0);
}

TEST(Chart, OrderOfOneColourIsTheOrderOfHeights) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(2, 9)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      for (const Colour c : {Colour::a, Colour::b}) {
        for (const ChartArc& e : charts.arcs_of(c)) {
          for (const ChartArc& f : charts.arcs_of(c)) {
            if (e.arc == f.arc) continue;
            const std::optional<mpq_class> x = common_abscissa(charts, c, e, f);
            if (!x) continue;
            const mpq_class difference =
                height(charts.circle(c, e).exact(), charts.frame, *x) - height(charts.circle(c, f).exact(), charts.frame, *x);
            EXPECT_EQ(above_same_colour(charts, c, e, f), sgn(difference)) << input.id << " arcs " << e.arc << ", " << f.arc;
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 10000U);
}

TEST(Chart, OrderOnWallsIsTheOrderOfHeights) {
  for (const Case& input : cases_of_all_families(1, 8)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      for (const ChartArc& e : charts.arcs_of(Colour::a)) {
        for (const ChartArc& f : charts.arcs_of(Colour::b)) {
          const Vector& d_e = charts.circle(Colour::a, e).exact();
          const Vector& d_f = charts.circle(Colour::b, f).exact();
          for (const Charts::Wall& wall : charts.walls) {
            const mpq_class x = project(charts.node(wall.colour, wall.node).exact(), charts.frame).x;
            EXPECT_EQ(above_on_wall(charts, Colour::a, e, Colour::b, f, wall),
                      sgn(mpq_class(height(d_e, charts.frame, x) - height(d_f, charts.frame, x))))
                << input.id;
          }
          // Heights are linear in x: far to the left the slopes decide.
          const mpq_class slope_e = height(d_e, charts.frame, 1) - height(d_e, charts.frame, 0);
          const mpq_class slope_f = height(d_f, charts.frame, 1) - height(d_f, charts.frame, 0);
          EXPECT_EQ(above_far_left(charts, Colour::a, e, Colour::b, f), sgn(mpq_class(slope_f - slope_e))) << input.id;
        }
      }
    }
  }
}

TEST(Chart, FaceBesideAnArcPrefersItsVertex) {
  for (const Case& input : cases_of_all_families(1, 8)) {
    const auto p = prepare(input);
    for (const Charts& charts : p->charts) {
      for (const ChartArc& arc : charts.arcs_of(Colour::b)) {
        const Vector up = p->b.vertices[charts.vertex_above(Colour::b, arc)] - p->b.vertices[charts.vertex_below(Colour::b, arc)];
        EXPECT_GT(dot(up, charts.frame.v.exact()), 0) << input.id;
      }
      for (const ChartArc& arc : charts.arcs_of(Colour::a)) {
        const Vector down = p->a.vertices[charts.vertex_above(Colour::a, arc)] - p->a.vertices[charts.vertex_below(Colour::a, arc)];
        EXPECT_LT(dot(down, charts.frame.v.exact()), 0) << input.id << ": the diagram is that of -A";
      }
    }
  }
}

// A frame whose equator holds a node, or that sees an arc on a vertical, is refused.
TEST(Chart, RefusesFramesWithExactZeros) {
  const std::vector<Vector> box{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 5}, {2, 3, 0}, {2, 0, 5}, {0, 3, 5}, {2, 3, 5}};
  const Polytope body = convex_hull(box);
  const GaussianDiagram diagram = gaussian_diagram(body), reflected = gaussian_diagram_of_reflection(body);
  EXPECT_FALSE(make_charts(reflected, diagram, {Direction(Vector{0, 1, 0}), Direction(Vector{0, 0, 1})}));
  EXPECT_FALSE(make_charts(reflected, diagram, {Direction(Vector{0, 5, -3}), Direction(Vector{7, 3, 5})})) << "an arc on a vertical";
  EXPECT_TRUE(make_charts(reflected, diagram, {Direction(Vector{1, 5, -4}), Direction(Vector{7, 1, 3})}));
}

}  // namespace
}  // namespace fathom
