// SPDX-License-Identifier: GPL-3.0-or-later
// Rays through P against the hull of all vertex differences: the same factor, and a true facet of P
// at the hit point.

#include "reference/approximate/ray.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iostream>
#include <map>
#include <random>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "fathom/approximate.hpp"
#include "kernels/vector.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::approximate {
namespace {

using testing::cases_of_all_families;

/// Where O lies in P of any rank: -1 inside, 0 on the boundary or in a flat P, 1 outside.
int place_of_origin(const polytope::Polytope& p) {
  int place = p.rank == 3 ? -1 : 0;
  for (const polytope::Facet& f : p.facets) place = std::max(place, -sgn(testing::height(p, f)));
  if (p.rank == 3) return place;
  std::vector<Vector> with_origin = p.vertices;
  with_origin.emplace_back();
  return polytope::convex_hull(with_origin).vertices == p.vertices ? 0 : 1;
}

/// A body with its hierarchy.
struct Prepared {
  explicit Prepared(std::span<const Vector> points) : polytope(polytope::convex_hull(points)), hierarchy(polytope) {}
  polytope::Polytope polytope;
  polytope::Hierarchy hierarchy;
};

/// All laws of one ray from O, where P stands at `p`, moved by -start.
void expect_ray(const RayShooter& rays, const polytope::Polytope& p, const Vector& u, const Vector& start) {
  const RayHit hit = rays.shoot(u, start);
  const int place = place_of_origin(p);
  ASSERT_EQ(rays.rank(), p.rank);
  ASSERT_EQ(hit.hits, place <= 0);
  ASSERT_EQ(hit.interior, place < 0);
  ASSERT_EQ(primitive(hit.normal), hit.normal);
  const mpz_class height = hit.height - dot(hit.normal, start);
  const auto below = [&](const Vector& v) { return dot(hit.normal, v) <= height; };
  ASSERT_TRUE(std::ranges::all_of(p.vertices, below));
  ASSERT_TRUE(std::ranges::any_of(p.vertices, [&](const Vector& v) { return dot(hit.normal, v) == height; }));
  if (!hit.hits) {
    ASSERT_LT(height, 0);
    ASSERT_EQ(hit.factor, 0);
  } else if (p.rank < 3) {
    ASSERT_EQ(hit.factor, 0);
    ASSERT_GE(dot(hit.normal, u), 0);
    ASSERT_TRUE(std::ranges::all_of(p.vertices, [&](const Vector& v) { return dot(hit.normal, v) == height; }));
  } else {
    ASSERT_EQ(hit.factor, testing::factor_naive(p, u));
    ASSERT_TRUE(testing::is_hit(p, hit.normal, hit.factor, u));
    ASSERT_GT(dot(hit.normal, u), 0);
  }
}

/// Through vertices, edges and facets of P and at random; back from each, too.
std::vector<Vector> telling_directions(const polytope::Polytope& p, std::mt19937_64& random) {
  std::vector<Vector> directions{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, -1}};
  const auto vertex = [&](polytope::VertexId v) { return p.vertices[v]; };
  for (int i = 0; i < 3; ++i) {
    directions.push_back(p.vertices.at(random() % p.vertices.size()));
    if (!p.edges.empty()) {
      const polytope::Edge& e = p.edges[random() % p.edges.size()];
      directions.insert(directions.end(), {vertex(e.from) + vertex(e.to), vertex(e.from) - vertex(e.to),
                                           vertex(e.from) + 3 * vertex(e.to)});
    }
    if (!p.facets.empty()) {
      const polytope::Facet& f = p.facets.at(random() % p.facets.size());
      directions.push_back(vertex(p.corners[f.begin]) + vertex(p.corners[f.begin + 1]) +
                           vertex(p.corners[f.begin + 2]));
      directions.push_back(f.normal);
    }
    directions.push_back(testing::random_direction(random, i == 0 ? 2 : 60));
  }
  for (std::size_t i = directions.size(); i-- > 0;) directions.push_back(-directions[i]);
  std::erase_if(directions, [](const Vector& u) { return is_zero(u); });
  return directions;
}

/// O, and a vertex of P, the sum of two or half of it: on the boundary, outside or somewhere in P.
std::vector<Vector> telling_starts(const polytope::Polytope& p, std::mt19937_64& random) {
  const Vector v = p.vertices.at(random() % p.vertices.size()), sum = v + p.vertices.at(random() % p.vertices.size());
  const std::array<Vector, 3> starts{v, sum, Vector{sum.x / 2, sum.y / 2, sum.z / 2}};
  return {{0, 0, 0}, starts[random() % 3]};
}

void expect_rays(std::span<const Vector> a, std::span<const Vector> b, unsigned seed) {
  const Prepared body_a(a), body_b(b);
  const RayShooter rays(body_a.hierarchy, body_b.hierarchy), by_levels(body_a.hierarchy, body_b.hierarchy, 0);
  const polytope::PlacedPair placed = polytope::place_integers({a.begin(), a.end()}, {b.begin(), b.end()});
  std::mt19937_64 random(seed);
  const polytope::Polytope p = testing::differences(placed);
  for (const Vector& start : telling_starts(p, random)) {
    polytope::Polytope moved = p;
    for (Vector& v : moved.vertices) v = v - start;
    for (const Vector& u : telling_directions(moved, random)) {
      SCOPED_TRACE(::testing::Message() << "from " << start << " along " << u);
      expect_ray(rays, moved, u, start);
      if (seed++ % 3 == 0) expect_ray(by_levels, moved, u, start);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Ray, AgreesWithTheHullOfDifferencesOnAllFamilies) {
  for (const Case& input : cases_of_all_families(2, 9)) {
    SCOPED_TRACE(input.id);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    expect_rays(placed.a.points(), placed.b.points(), static_cast<unsigned>(input.id.back()));
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST(Ray, AgreesWithTheHullOfDifferencesOnSmallLattices) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const auto body = [] {
      const int count = *rc::gen::inRange(1, 9), x = *rc::gen::inRange(1, 4), y = *rc::gen::inRange(1, 4),
                z = *rc::gen::inRange(1, 4);
      std::vector<Vector> points;
      for (int i = 0; i < count; ++i)
        points.push_back({*rc::gen::inRange(-x, x), *rc::gen::inRange(-y, y), *rc::gen::inRange(-z, z)});
      return points;
    };
    const std::vector<Vector> a = body(), b = body();
    expect_rays(a, b, *rc::gen::inRange(0U, 1000U));
    RC_ASSERT(!::testing::Test::HasFatalFailure());
  }));
}

/// Queries and steps of rays from points near O in P = B (+) (-A).
struct Growth {
  std::uint64_t queries = 0, steps = 0;  // the greatest of any ray
};

Growth greatest_of_rays(const polytope::Hierarchy& a, const polytope::Hierarchy& b) {
  const RayShooter rays(a, b);
  std::mt19937_64 random(7);
  Growth greatest;
  for (int i = 0; i < 300; ++i) {
    const Vector u = testing::random_direction(random, i % 2 ? 3 : 40);
    const RayHit hit = rays.shoot(u);
    EXPECT_TRUE(hit.interior);
    EXPECT_EQ(hit.height, dot(hit.normal, b.polytope().vertices[b.extreme(hit.normal)]) -
                              dot(hit.normal, a.polytope().vertices[a.extreme(-hit.normal)]));
    EXPECT_EQ(hit.factor, kernels::ratio(hit.height, dot(hit.normal, u)));
    greatest.queries = std::max(greatest.queries, hit.queries);
    greatest.steps = std::max(greatest.steps, hit.steps);
  }
  return greatest;
}

// Queries grow like log n, steps like its square; with room for about half as many again.
void expect_growth(const char* family, unsigned n, bool with_itself) {
  SCOPED_TRACE(std::string(family) + " " + std::to_string(n));
  const Case input = families::find_family(family)->make(1, n);
  const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
  const Prepared b(placed.b.points());
  const Growth growth = with_itself ? greatest_of_rays(b.hierarchy, b.hierarchy)
                                    : greatest_of_rays(Prepared(placed.a.points()).hierarchy, b.hierarchy);
  const std::uint64_t doublings = std::bit_width(b.polytope.vertices.size());
  std::cout << family << " vertices " << b.polytope.vertices.size() << " queries " << growth.queries << " steps "
            << growth.steps << '\n';
  EXPECT_LE(growth.queries, 5 * doublings);
  EXPECT_LE(growth.steps, 100 * doublings * doublings);
}

TEST(Ray, QueriesGrowLikeTheLogarithmAndStepsLikeItsSquare) {
  for (const unsigned n : {100U, 1000U, 10000U}) expect_growth("random_sphere", n, false);
  expect_growth("random_sphere", 100000, true);
  for (const char* family : {"crossed_parabolas", "crossed_fans", "prisms_posed", "plates"})
    for (const unsigned n : {100U, 2000U}) expect_growth(family, n, false);
}

/// Rings of the paraboloid z = -(x^2 + y^2) / 17 that shrink by a factor of 2: near the tip every
/// portal is cut down ring by ring.
std::vector<Vector> shrinking_rings(unsigned rings) {
  std::vector<Vector> points;
  for (unsigned i = 0; i < rings; ++i) {
    const mpz_class s = testing::power_of_two(i);
    for (const auto& [x, y] : {std::pair{4, 1}, {1, 4}, {-4, 1}, {-1, 4}, {4, -1}, {1, -4}, {-4, -1}, {-1, -4}})
      points.push_back({s * x, s * y, -s * s});
  }
  return points;
}

// The worst case of portals is real; the descent of both hierarchies takes over, and bounds the
// steps of all.
TEST(Ray, StepsStayPolylogarithmicWherePortalsAreSlow) {
  const std::vector<Vector> corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const unsigned rings : {20U, 80U, 160U}) {
    SCOPED_TRACE(rings);
    const Prepared a(corner), b(shrinking_rings(rings));
    const RayShooter usual(a.hierarchy, b.hierarchy), by_levels(a.hierarchy, b.hierarchy, 0),
        by_portals(a.hierarchy, b.hierarchy, ~0UL);
    const mpz_class height = testing::power_of_two(2 * rings - 4);
    const std::uint64_t doublings = std::bit_width(b.polytope.vertices.size());
    std::mt19937_64 random(2);
    std::uint64_t most = 0;
    for (int i = 0; i < 30; ++i) {
      const mpz_class wide = testing::power_of_two(random() % rings);
      const Vector u{wide * static_cast<long>(random() % 5), wide * static_cast<long>(random() % 7), height};
      const RayHit hit = usual.shoot(u, {0, 0, -height}), slow = by_portals.shoot(u, {0, 0, -height}),
                   down = by_levels.shoot(u, {0, 0, -height});
      ASSERT_TRUE(hit.interior);
      ASSERT_EQ(std::tie(hit.factor, hit.normal), std::tie(slow.factor, slow.normal));
      ASSERT_EQ(std::tie(hit.factor, hit.normal), std::tie(down.factor, down.normal));
      most = std::max(most, slow.queries);
      EXPECT_LE(down.steps, 60 * doublings * doublings);
      EXPECT_LE(hit.steps, 160 * doublings * doublings);
    }
    EXPECT_GE(most, rings);
  }
}

TEST(Ray, LevelsAndPortalsFindTheSameFacet) {
  for (const char* family : {"random_sphere", "crossed_parabolas", "prisms_posed", "crossed_prisms", "parallel_edges",
                             "common_normals", "plates"}) {
    SCOPED_TRACE(family);
    const Case input = families::find_family(family)->make(2, 300);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    const Prepared a(placed.a.points()), b(placed.b.points());
    const RayShooter usual(a.hierarchy, b.hierarchy), by_levels(a.hierarchy, b.hierarchy, 0);
    std::mt19937_64 random(3);
    const Vector on = b.polytope.vertices[polytope::VertexId(5)] - a.polytope.vertices[polytope::VertexId(7)];
    for (const Vector& start : {Vector{0, 0, 0}, on, Vector{on.x / 2, on.y / 2, on.z / 2}, on + on}) {
      for (int i = 0; i < 4; ++i) {
        const Vector u = i == 0 ? b.polytope.facets[polytope::FacetId(9)].normal
                                : testing::random_direction(random, i == 1 ? 2 : 30);
        const RayHit hit = usual.shoot(u, start), down = by_levels.shoot(u, start);
        ASSERT_EQ(std::tie(hit.hits, hit.interior, hit.factor, hit.normal, hit.height),
                  std::tie(down.hits, down.interior, down.factor, down.normal, down.height));
      }
    }
  }
}

TEST(Ray, RefusesAZeroDirection) {
  const Prepared cube(std::vector<Vector>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_THROW((void)shoot_ray(cube.hierarchy, cube.hierarchy, {0, 0, 0}), std::invalid_argument);
}

// Polyhedral norms and gauges against the hull of all differences, and against closed forms.

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
