// SPDX-License-Identifier: GPL-3.0-or-later
// Polyhedral norms and gauges against the hull of all differences, and against closed forms.

#include "reference/approximate/metric.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "fathom/approximate.hpp"
#include "kernels/vector.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::approximate {
namespace {

using testing::differences;

std::vector<Point> cube(const mpq_class& r) {
  std::vector<Point> q;
  for (int i = 0; i < 8; ++i)
    q.push_back({i & 1 ? r : mpq_class(-r), i & 2 ? r : mpq_class(-r), i & 4 ? r : mpq_class(-r)});
  return q;
}

std::vector<Point> octahedron() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

/// Not symmetric; with an interior point, a repeated one, and denominators of its own.
std::vector<Point> skew_ball() {
  return {
      {0, 0, 0}, {mpq_class(1, 3), 0, 0}, {0, mpq_class(5, 7), 0}, {0, mpq_class(5, 7), 0}, {-1, -1, mpq_class(-1, 2)},
      {0, 0, 2}};
}

/// Depth and deciding points by the definition: P, and each point of Q that is extreme in it.
struct NaiveMetric {
  mpq_class depth;
  std::map<std::uint32_t, Point> translations;
};

NaiveMetric naive(const Case& input, std::span<const Point> q) {
  const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
  const polytope::Polytope p = differences(placed);
  NaiveMetric result;
  if (!testing::holds_origin(p)) return result;
  const Point origin{0, 0, 0};
  const polytope::PlacedPair placed_q = polytope::place(q, {&origin, 1});
  const polytope::Polytope hull = polytope::convex_hull(placed_q.a.points());
  for (const polytope::VertexId i : hull.vertices.ids()) {
    const std::uint32_t id = hull.input_ids[i];
    const mpq_class factor = testing::factor_naive(p, hull.vertices[i]) * placed_q.denominator / placed.denominator;
    if (!result.translations.empty() && factor > result.depth) continue;
    if (factor < result.depth) result.translations.clear();
    result.depth = factor;
    result.translations[id] = {factor * q[id].x, factor * q[id].y, factor * q[id].z};
  }
  return result;
}

void expect_equal(const MetricResult& result, const NaiveMetric& twin, const Case& input) {
  EXPECT_EQ(result.depth(), twin.depth) << input.id;
  ASSERT_EQ(result.optima().size(), twin.translations.size()) << input.id;
  auto expected = twin.translations.begin();
  for (const MetricOptimum& optimum : result.optima()) {
    EXPECT_EQ(optimum.vertex, expected->first) << input.id;
    const Point& t = optimum.translation;
    EXPECT_EQ(t, (expected++)->second) << input.id;
    const Vector& n = optimum.direction;
    EXPECT_EQ(testing::support(input.a.points, input.b.points, n), n.x * t.x + n.y * t.y + n.z * t.z)
        << input.id << ": separates";
    const Witness& w = optimum.witness;
    EXPECT_EQ(w.b - w.a, t) << input.id;
    EXPECT_TRUE(testing::in_hull(w.a, input.a.points, optimum.contact.a)) << input.id;
    EXPECT_TRUE(testing::in_hull(w.b, input.b.points, optimum.contact.b)) << input.id;
  }
}

TEST(Metric, EqualsTheHullOfAllDifferencesOnEveryFamily) {
  const std::vector<Point> balls[] = {cube(1), octahedron(), skew_ball()};
  std::size_t penetrating = 0, ties = 0;
  for (const Case& input : testing::cases_of_all_families(2, 8)) {
    for (const std::vector<Point>& q : balls) {
      const UnitBall ball = unit_ball(q);
      const MetricResult result = fathom::metric_depth(input.a.points, input.b.points, ball);
      expect_equal(result, naive(input, q), input);
      if (result.status() != Status::penetrating) {
        EXPECT_TRUE(result.optima().empty()) << input.id;
        continue;
      }
      ++penetrating;
      EXPECT_EQ(result.penetration()->rays, ball.vertices.size()) << input.id;
      if (result.optima().size() > 1) ++ties;
    }
  }
  EXPECT_GT(penetrating, 100U);
  EXPECT_GT(ties, 20U);
}

// Boxes: along axes the octahedron's norm sees the least overlap, the cube's norm the same; twice
// the ball, half the depth.
TEST(Metric, OfTwoBoxes) {
  Case input{"boxes", {cube(1)}, {cube(1)}};
  for (Point& p : input.b.points.edit()) p = {p.x + 1, p.y + mpq_class(3, 2), p.z + mpq_class(1, 4)};
  const MetricResult one = fathom::metric_depth(input.a.points, input.b.points, unit_ball(octahedron()));
  EXPECT_EQ(one.depth(), mpq_class(1, 2));
  ASSERT_EQ(one.optima().size(), 1U);
  EXPECT_EQ(one.optima()[0].vertex, 3U);
  EXPECT_EQ(one.optima()[0].translation, (Point{0, mpq_class(-1, 2), 0}));
  EXPECT_EQ(one.optima()[0].contact, (Contact{ContactKind::facet_facet, {2, 3, 6, 7}, {0, 1, 4, 5}}));
  const MetricResult largest = fathom::metric_depth(input.a.points, input.b.points, unit_ball(cube(1)));
  EXPECT_EQ(largest.depth(), mpq_class(1, 2));
  EXPECT_EQ(largest.optima().size(), 4U) << "all corners of the cube's lower facet";
  EXPECT_EQ(fathom::metric_depth(input.a.points, input.b.points, unit_ball(cube(2))).depth(), mpq_class(1, 4));
}

// The Euclidean depth lies between those of an inscribed and of a circumscribed ball.
TEST(Metric, EnclosesTheEuclideanDepth) {
  for (const Case& input : testing::cases_of_all_families(1, 9)) {
    const mpq_class squared = testing::exact_depth(input.a.points, input.b.points).squared();
    const mpq_class inner = fathom::metric_depth(input.a.points, input.b.points, unit_ball(octahedron())).depth();
    const mpq_class outer = fathom::metric_depth(input.a.points, input.b.points, unit_ball(cube(1))).depth();
    EXPECT_LE(squared, inner * inner) << input.id;
    EXPECT_LE(outer * outer, squared) << input.id;
  }
}

// The gauge of -Q is that of Q for the bodies exchanged: P becomes -P.
TEST(Metric, OfTheReflectedBall) {
  std::vector<Point> reflected = skew_ball();
  for (Point& p : reflected) p = {-p.x, -p.y, -p.z};
  for (const Case& input : testing::cases_of_all_families(1, 9)) {
    const MetricResult one = fathom::metric_depth(input.a.points, input.b.points, unit_ball(skew_ball()));
    const MetricResult other = fathom::metric_depth(input.b.points, input.a.points, unit_ball(reflected));
    EXPECT_EQ(one.depth(), other.depth()) << input.id;
    EXPECT_EQ(one.optima().size(), other.optima().size()) << input.id;
  }
}

TEST(UnitBall, KeepsExtremePointsAndKnowsSymmetry) {
  EXPECT_TRUE(unit_ball(cube(mpq_class(1, 3))).symmetric);
  EXPECT_TRUE(unit_ball(octahedron()).symmetric);
  const UnitBall skew = unit_ball(skew_ball());
  EXPECT_FALSE(skew.symmetric);
  EXPECT_EQ(skew.input_ids, (std::vector<std::uint32_t>{1, 2, 4, 5}));
  std::vector<Point> nearly = cube(1);
  nearly[7].x += mpq_class(1, 1000000000);
  EXPECT_FALSE(unit_ball(nearly).symmetric);
  nearly = cube(1);
  nearly.push_back({mpq_class(1, 2), 0, 0});
  EXPECT_TRUE(unit_ball(nearly).symmetric) << "points inside do not count";
}

TEST(UnitBall, RefusesWhatIsNone) {
  const auto why = [](const std::vector<Point>& points) -> std::string {
    try {
      unit_ball(points);
    } catch (const NoUnitBall& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(why({{0, 0, 0}}).find("flat"), std::string::npos);
  EXPECT_NE(why({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}).find("flat"), std::string::npos);
  EXPECT_NE(why({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).find("boundary"), std::string::npos);
  EXPECT_NE(why({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}).find("does not contain O"), std::string::npos);
  EXPECT_THROW(unit_ball(std::vector<Point>{}), std::invalid_argument);
}

// Ten thousand vertices, every one of them extreme, against the naive twin.
TEST(Metric, ManyVertices) {
  std::mt19937_64 random(9);
  std::vector<Point> q;
  while (q.size() < 10000) {  // on a sphere: the inverse stereographic image of a rational point
    const mpq_class x = kernels::ratio(testing::random_integer(random, 30), testing::power_of_two(28)),
                    y = kernels::ratio(testing::random_integer(random, 30), testing::power_of_two(28)),
                    s = 1 + x * x + y * y;
    q.push_back({2 * x / s, 2 * y / s, (s - 2) / s});
    for (mpq_class* c : {&q.back().x, &q.back().y, &q.back().z}) {  // and near it in binary64
      *c = mpq_class(c->get_d());
    }
  }
  const Case input = families::find_family("random_sphere")->make(2, 12);
  const UnitBall ball = unit_ball(q);
  EXPECT_GT(ball.vertices.size(), 9000U);
  expect_equal(fathom::metric_depth(input.a.points, input.b.points, ball), naive(input, q), input);
}

// The exact directional depth against the hull of all differences.

const Point directions[] = {
    {1, 0, 0}, {0, -3, 0}, {1, 1, 1}, {mpq_class(1, 3), mpq_class(-2, 7), 0}, {mpq_class(1, 1000), 0, 1}};

TEST(Directional, EqualsTheHullOfAllDifferencesOnEveryFamily) {
  std::size_t penetrating = 0;
  for (const Case& input : testing::cases_of_all_families(2, 8)) {
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    const Depth exact = testing::exact_depth(a, b);
    const polytope::PlacedPair placed = polytope::place(a, b);
    const polytope::Polytope p = testing::differences(placed);
    for (const Point& u : directions) {
      const DirectionalDepth found = directional_depth(a, b, u);
      ASSERT_EQ(found.status(), exact.status()) << input.id;
      EXPECT_EQ(found.translation(), (Point{found.factor() * u.x, found.factor() * u.y, found.factor() * u.z}))
          << input.id;
      EXPECT_GE(found.squared(), exact.squared()) << input.id;
      if (found.status() != Status::penetrating) {
        EXPECT_EQ(found.factor(), 0) << input.id;
        EXPECT_EQ(sgn(testing::support(a, b, found.normal())), found.status() == Status::disjoint ? -1 : 0) << input.id;
        continue;
      }
      ++penetrating;
      const RayExit& exit = *found.penetration();
      const Vector scaled{mpq_class(21000 * u.x).get_num(), mpq_class(21000 * u.y).get_num(),
                          mpq_class(21000 * u.z).get_num()};
      const mpq_class factor = testing::factor_naive(p, scaled);
      EXPECT_EQ(found.factor(), factor * 21000 / placed.denominator) << input.id;
      EXPECT_TRUE(testing::is_hit(p, found.normal(), factor, scaled)) << input.id;
      EXPECT_EQ(exit.contact.kind, testing::kind_of(exit.contact, a, b)) << input.id;
      EXPECT_EQ(exit.contact.a, testing::face(a, -exit.normal)) << input.id;
      EXPECT_EQ(exit.contact.b, testing::face(b, exit.normal)) << input.id;
      EXPECT_EQ(exit.witness.b - exit.witness.a, found.translation()) << input.id;
      EXPECT_TRUE(testing::in_hull(exit.witness.a, a, exit.contact.a)) << input.id;
      EXPECT_TRUE(testing::in_hull(exit.witness.b, b, exit.contact.b)) << input.id;
    }
  }
  EXPECT_GT(penetrating, 200U);
}

// Along the direction of an optimum the directional depth is the depth.
TEST(Directional, AlongAnOptimumItIsTheDepth) {
  for (const Case& input : testing::cases_of_all_families(2, 10)) {
    const Depth exact = testing::exact_depth(input.a.points, input.b.points);
    for (const Optimum& optimum : exact.optima()) {
      const DirectionalDepth found = directional_depth(input.a.points, input.b.points, optimum.translation());
      EXPECT_EQ(found.factor(), 1) << input.id;
      EXPECT_EQ(found.squared(), exact.squared()) << input.id;
      EXPECT_EQ(found.normal(), optimum.direction) << input.id;
      EXPECT_EQ(found.penetration()->contact, optimum.contact) << input.id;
    }
  }
}

TEST(Directional, RefusesZero) {
  const std::vector<Point> one{{0, 0, 0}}, none;
  EXPECT_THROW(directional_depth(one, one, {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(directional_depth(none, one, {1, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::approximate
