// SPDX-License-Identifier: GPL-3.0-or-later
// SHALLOW-PENETRATION against the exact pipeline over all families, by exact equality; and which
// facets of P it looks at.

#include "reference/approximate/shallow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "tests/approximate/shallow_scene.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/same_answer.hpp"
#include "tests/support/vectors.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::approximate {
namespace {

using testing::NormalSet;
using testing::ShallowScene;

// ---- the answer ----

void expect_same(const Depth& depth, const Depth& exact) {
  testing::expect_same_answer(depth, exact);
  EXPECT_EQ(depth.extreme_a, exact.extreme_a);
  EXPECT_EQ(depth.extreme_b, exact.extreme_b);
}

class EveryFamily : public ::testing::TestWithParam<families::Family> {};

TEST_P(EveryFamily, EqualsTheExactPipeline) {
  for (const unsigned size : {1U, 5U, 10U}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Case input = GetParam().make(seed, size);
      SCOPED_TRACE(input.id);
      const Depth exact = testing::exact_depth(input.a.points, input.b.points);
      Options validated;
      validated.validate = true;
      const Depth depth =
          shallow_depth(input.a.points, input.b.points, validated, seed == 1 ? mpq_class(1, 4) : mpq_class(seed - 1));
      expect_same(depth, exact);
      EXPECT_EQ(depth.counters.facets_visited > 0, depth.status() == Status::penetrating);
      EXPECT_EQ(depth.counters.rays > 0, depth.status() == Status::penetrating);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shallow, EveryFamily,
                         ::testing::ValuesIn(families::families().begin(), families::families().end()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Shallow, EqualsTheExactPipelineOnTheCatalogue) {
  for (const families::CatalogueEntry& entry : families::catalogue()) {
    SCOPED_TRACE(entry.name);
    const Depth exact = testing::exact_depth(entry.pair.a.points, entry.pair.b.points);
    for (const mpq_class& delta : {mpq_class(1, 4), mpq_class(1)}) {
      const Depth depth = shallow_depth(entry.pair.a.points, entry.pair.b.points, {}, delta);
      expect_same(depth, exact);
      EXPECT_EQ(depth.optima().size(), entry.optima);
    }
  }
}

// ---- which facets it visits ----

/// The squared distance of a facet of P from O: at its foot, or on its boundary.
mpq_class squared_distance(const polytope::Polytope& p, const polytope::Facet& f) {
  const Vector& n = f.normal;
  const mpz_class h = testing::height(p, f), square = dot(n, n);
  std::optional<mpq_class> least;
  bool foot_inside = true;
  for (std::uint32_t i = f.begin; i < f.end; ++i) {
    const Vector &u = p.vertices[p.corners[i]], &v = p.vertices[p.corners[i + 1 == f.end ? f.begin : i + 1]];
    const Vector d = v - u;
    if (det(n, d, -u) < 0) foot_inside = false;  // the foot is O moved along n
    const mpq_class t = std::clamp(kernels::ratio(-dot(u, d), dot(d, d)), mpq_class(0), mpq_class(1));
    const mpq_class here = dot(u, u) + t * (2 * mpq_class(dot(u, d)) + t * dot(d, d));
    if (!least || here < *least) least = here;
  }
  return foot_inside ? kernels::ratio(h * h, square) : *least;
}

// Visited facets meet the ball, and the ball is such that those are within Theorem 3.5's count, (1
// + delta) depth of O.
TEST_P(EveryFamily, VisitsOnlyFacetsThatMeetTheBall) {
  kernels::Context context;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const Case input = GetParam().make(seed, 7);
    SCOPED_TRACE(input.id);
    const ShallowScene scene(input);
    for (const mpq_class& delta : {mpq_class(1, 2), mpq_class(2)}) {
      const ShallowResult result = ShallowPenetration(context, scene.a, scene.b, delta).query(context);
      EXPECT_EQ(result.inside, testing::holds_origin(scene.sum));
      if (!result.inside) continue;
      const mpq_class depth_squared = kernels::ratio(result.nearest.numerator(), result.nearest.denominator());
      EXPECT_LE(result.ball_radius_squared, (1 + delta) * (1 + delta) * depth_squared);
      EXPECT_GE(result.ball_radius_squared, (1 + delta / 2) * (1 + delta / 2) * depth_squared);
      std::uint64_t within = 0;
      for (const polytope::Facet& f : scene.sum.facets)
        within += squared_distance(scene.sum, f) <= result.ball_radius_squared ? 1 : 0;
      EXPECT_LE(result.facets, within);
      EXPECT_GE(result.facets, result.nearest.directions().size());
      EXPECT_GE(result.facets, result.starts);
    }
  }
}

/// Unit spheres of points, B's centre almost 2 away from A's: only their near sides overlap.
Case spheres_that_overlap_a_little(unsigned points, const mpq_class& apart) {
  families::Random random(points);
  const Body a = families::random_sphere_body(random, points), b = families::random_sphere_body(random, points);
  return {"shallow", a, families::translated(b, {apart, 0, 0})};
}

TEST(Shallow, LooksAtFewFacetsWhenThePenetrationIsShallow) {
  for (const unsigned points : {100U, 400U}) {
    const Case input = spheres_that_overlap_a_little(points, mpq_class(15, 8));
    const Depth exact = testing::exact_depth(input.a.points, input.b.points),
                depth = shallow_depth(input.a.points, input.b.points);
    expect_same(depth, exact);
    ASSERT_EQ(depth.status(), Status::penetrating) << points;
    EXPECT_GE(exact.counters.crossings, 2U * points) << "facets of P; there are others";
    EXPECT_LE(depth.counters.facets_visited, 20U) << points;
  }
}

TEST(Shallow, TheWalkDoesNotGrowWithTheBodies) {
  kernels::Context context;
  for (const unsigned points : {1000U, 8000U}) {
    const Case input = spheres_that_overlap_a_little(points, mpq_class(99, 50));
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    const polytope::Polytope hull_a = polytope::convex_hull(placed.a.points()),
                             hull_b = polytope::convex_hull(placed.b.points());
    const polytope::Hierarchy a(hull_a), b(hull_b);
    const ShallowResult result = ShallowPenetration(context, a, b).query(context);
    ASSERT_TRUE(result.inside);
    EXPECT_LE(result.facets, 40U) << points;
    EXPECT_LE(result.walk_steps, 1000U) << points;
  }
}

// Then it is only slower: all of P is within a few depths of O.
TEST(Shallow, ADeepPenetrationTakesItThroughAllOfP) {
  const Case input{"a cube in a cube", families::box(1, 1, 1), families::box(2, 2, 2)};
  const Depth depth = shallow_depth(input.a.points, input.b.points, {}, 2);
  EXPECT_EQ(depth.counters.facets_visited, 6U);
  EXPECT_EQ(depth.optima().size(), 6U);
}

// ---- bodies that move ----

TEST(Shallow, ABodyMovesWithoutNewPreparation) {
  kernels::Context context;
  for (const char* name : {"random_lattice", "boxes_aligned", "random_sphere", "polygon_solid", "exact_ties"}) {
    const families::Family* family = families::find_family(name);
    ASSERT_NE(family, nullptr) << name;
    const Case input = family->make(2, 8);
    const ShallowScene scene(input);
    ASSERT_EQ(scene.sum.rank, 3);
    const ShallowPenetration bodies(context, scene.a, scene.b);
    const mpz_class& unit = scene.placed.denominator;
    std::size_t inside = 0;
    for (int i = 0; i < 40; ++i) {
      const mpz_class step = unit > 4 ? mpz_class(unit / 4) : mpz_class(1);
      const Vector shift{step * (i % 5 - 2), step * (i / 5 % 4 - 1), step * (i / 20 - 1)};
      const Point by{kernels::ratio(shift.x, unit), kernels::ratio(shift.y, unit), kernels::ratio(shift.z, unit)};
      const Depth exact = testing::exact_depth(families::translated(input.a, by).points, input.b.points);
      const ShallowResult result = bodies.query(context, shift);
      EXPECT_TRUE(validate(result, scene.a, scene.b, shift).ok());
      ASSERT_EQ(result.inside, exact.status() == Status::penetrating) << name << i;
      if (!result.inside) {
        EXPECT_TRUE(result.nearest.empty());
        continue;
      }
      ++inside;
      EXPECT_EQ(kernels::ratio(result.nearest.numerator(), result.nearest.denominator() * unit * unit), exact.squared())
          << name << i;
      NormalSet directions;
      for (const Optimum& o : exact.optima()) directions.insert(o.direction);
      EXPECT_TRUE(std::ranges::equal(directions, result.nearest.directions())) << name << i;
    }
    EXPECT_GT(inside, 0U) << name;
  }
}

TEST(Shallow, ValidateSeesWhatIsBroken) {
  kernels::Context context;
  const ShallowScene scene({"a cube in a cube", families::box(1, 1, 1), families::box(2, 2, 2)});
  const ShallowResult result = ShallowPenetration(context, scene.a, scene.b).query(context);
  EXPECT_TRUE(validate(result, scene.a, scene.b).ok());
  ShallowResult broken = result;
  broken.inside = false;
  EXPECT_FALSE(validate(broken, scene.a, scene.b).ok());
  broken = {};
  broken.inside = true;
  broken.nearest.offer({1, 1, 0}, 6);  // supports P along an edge
  EXPECT_FALSE(validate(broken, scene.a, scene.b).ok());
  broken.nearest = {};
  broken.nearest.offer({1, 0, 0}, 2);  // a facet of P, and at 3
  EXPECT_FALSE(validate(broken, scene.a, scene.b).ok());
  EXPECT_FALSE(validate(result, scene.a, scene.b, {1, 0, 0}).ok());
}

TEST(Shallow, FlatSumsAndPlacesOutsideHaveNoDepth) {
  kernels::Context context;
  const families::Family* flat = families::find_family("segment_segment");
  const ShallowScene segments(flat->make(1, 4));
  EXPECT_FALSE(ShallowPenetration(context, segments.a, segments.b).query(context).inside);
  const ShallowScene solids(families::find_family("boxes_aligned")->make(1, 8));
  const ShallowPenetration bodies(context, solids.a, solids.b);
  EXPECT_FALSE(bodies.query(context, {1000000, 0, 0}).inside);
  EXPECT_FALSE(bodies.query(context, solids.sum.vertices.front()).inside) << "a vertex of P";
  EXPECT_EQ(bodies.query(context, solids.sum.vertices.front()).facets, 0U);
}

// ---- what may go wrong ----

TEST(Shallow, RefusesADeltaThatIsNotBetweenZeroAndTwo) {
  kernels::Context context;
  const Case input = families::find_family("boxes_aligned")->make(1, 8);
  for (const mpq_class& delta : {mpq_class(0), mpq_class(-1, 4), mpq_class(9, 4)}) {
    EXPECT_THROW(shallow_depth(input.a.points, input.b.points, {}, delta), std::invalid_argument) << delta;
    const ShallowScene scene(input);
    EXPECT_THROW(ShallowPenetration(context, scene.a, scene.b, delta), std::invalid_argument) << delta;
  }
  EXPECT_THROW(shallow_depth({}, input.b.points), std::invalid_argument);
}

TEST(Shallow, AMonitorHearsOfProgressAndCanStopTheRun) {
  const Case input = families::find_family("crossed_patch")->make(1, 40);
  testing::Recorder all;
  const Depth depth = shallow_depth(input.a.points, input.b.points, {.monitor = &all});
  ASSERT_EQ(depth.status(), Status::penetrating);
  EXPECT_GT(depth.counters.facets_visited, 1000U) << "near ties are all near O";
  EXPECT_GT(std::ranges::count(all.stages, "hierarchies"), 0);
  EXPECT_GT(std::ranges::count(all.stages, "facets near the origin"), 2);
  for (const double share : all.shares) EXPECT_TRUE(share >= 0 && share <= 1) << share;
  for (std::size_t stop = 1; stop <= all.stages.size(); ++stop) {
    testing::Recorder some(stop);
    EXPECT_THROW(shallow_depth(input.a.points, input.b.points, {.monitor = &some}), Interrupted);
    EXPECT_EQ(some.stages.size(), stop);
  }
}

// The implicit boundary of P and the walk over it, against P itself: the hull of all vertex
// differences.

NormalSet normals_of(const polytope::Polytope& p) {
  NormalSet normals;
  for (const polytope::Facet& f : p.facets) normals.insert(f.normal);
  return normals;
}

SumFacet facet_of(const SumSurface& surface, const ShallowScene& scene, const Vector& n) {
  return surface.facet(scene.a.extreme_face(-n), scene.b.extreme_face(n), n);
}

/// Whether the segment meets the ball, by another route than Ball::meets: the least of the
/// distances of the ends and of a foot between.
bool meets_naive(const Ball& ball, const Vector& p, const Vector& q) {
  const mpq_class radius_squared = kernels::ratio(ball.numerator, ball.denominator);
  const Vector r = p - ball.centre, s = q - ball.centre, d = q - p;
  mpq_class least = std::min(mpz_class(dot(r, r)), mpz_class(dot(s, s)));
  const mpq_class t = kernels::ratio(-dot(r, d), dot(d, d));
  if (t > 0 && t < 1) least = std::min(least, mpq_class(dot(r, r) - t * t * dot(d, d)));
  return least <= radius_squared;
}

/// The same walk over the hull of all differences.
NormalSet walk_naive(const polytope::Polytope& p, const Ball& ball, const NormalSet& starts) {
  kernels::IdVector<polytope::FacetId, bool> reached(p.facets.size());
  for (const polytope::FacetId i : p.facets.ids()) reached[i] = starts.contains(p.facets[i].normal);
  for (bool more = true; more;) {
    more = false;
    for (const polytope::Edge& e : p.edges) {
      if (reached[e.left] == reached[e.right] || !meets_naive(ball, p.vertices[e.from], p.vertices[e.to])) continue;
      reached[e.left] = reached[e.right] = more = true;
    }
  }
  NormalSet result;
  for (const polytope::FacetId i : p.facets.ids()) {
    if (reached[i]) result.insert(p.facets[i].normal);
  }
  return result;
}

NormalSet walk_from(const SumSurface& surface, const Ball& ball, const std::vector<SumFacet>& starts) {
  NormalSet visited;
  kernels::Context context;
  const WalkCounts counts = walk(context, surface, ball, starts, [&](const SumFacet& f) {
    EXPECT_TRUE(visited.insert(f.normal).second) << "visited twice";
  });
  EXPECT_EQ(counts.facets, visited.size());
  return visited;
}

/// The facet's corners, as an unordered set of points of P.
NormalSet corners_of(const polytope::Polytope& p, const polytope::Facet& facet) {
  NormalSet corners;
  for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.insert(p.vertices[p.corners[i]]);
  return corners;
}

// ---- the implicit surface is the boundary of P ----

/// Each facet's edges close up, turn left, and have the corners of P's facet; the way across an
/// edge and back leads home.
void expect_facet(const SumSurface& surface, const polytope::Polytope& p, const SumFacet& facet) {
  const std::vector<SumEdge> edges = surface.edges(facet);
  const auto same = std::ranges::find(p.facets, facet.normal, &polytope::Facet::normal);
  ASSERT_NE(same, p.facets.end()) << "no facet of P has the normal " << facet.normal;
  NormalSet corners;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const SumEdge &e = edges[i], &next = edges[(i + 1) % edges.size()];
    corners.insert(surface.from(e));
    EXPECT_EQ(surface.to(e), surface.from(next));
    EXPECT_GT(det(facet.normal, surface.to(e) - surface.from(e), surface.to(next) - surface.from(next)), 0);
    std::uint64_t steps = 0;
    const SumFacet across = surface.across(e, &steps);
    EXPECT_GT(steps, 0U);
    EXPECT_EQ(primitive(across.normal), across.normal);
    bool back = false;
    for (const SumEdge& f : surface.edges(across)) {
      if (f.a != e.a || f.b != e.b) continue;
      EXPECT_EQ(surface.from(f), surface.to(e));
      const SumFacet home = surface.across(f, &steps);
      back = home.a == facet.a && home.b == facet.b && home.normal == facet.normal;
    }
    EXPECT_TRUE(back) << "across an edge and back";
  }
  EXPECT_EQ(corners, corners_of(p, *same));
  EXPECT_EQ(edges.size(), corners.size());
  EXPECT_EQ(dot(facet.normal, surface.point(facet)), testing::height(p, *same));
}

class WalksOfEveryFamily : public ::testing::TestWithParam<families::Family> {};

TEST_P(WalksOfEveryFamily, TheImplicitSurfaceIsTheBoundaryOfP) {
  for (const unsigned size : {4U, 7U}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Case input = GetParam().make(seed, size);
      SCOPED_TRACE(input.id);
      const ShallowScene scene(input);
      if (scene.sum.rank < 3) continue;
      const SumSurface surface(scene.hull_a, scene.hull_b);
      for (const polytope::Facet& f : scene.sum.facets)
        expect_facet(surface, scene.sum, facet_of(surface, scene, f.normal));
    }
  }
}

TEST_P(WalksOfEveryFamily, AWalkInABallFindsWhatAWalkOverPFinds) {
  std::mt19937_64 random(5);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Case input = GetParam().make(seed, 6);
    SCOPED_TRACE(input.id);
    const ShallowScene scene(input);
    if (scene.sum.rank < 3) continue;
    const SumSurface surface(scene.hull_a, scene.hull_b);
    for (int i = 0; i < 6; ++i) {
      // Centre anywhere about P, the radius such that it reaches some vertex of P: edges that just
      // meet it.
      const Vector &p = scene.sum.vertices.at(random() % scene.sum.vertices.size()),
                   &q = scene.sum.vertices.at(random() % scene.sum.vertices.size());
      const Ball ball{i % 2 == 0 ? Vector{0, 0, 0} : p, i == 0 ? mpz_class(0) : mpz_class(dot(q - p, q - p)),
                      i % 3 + 1};
      const Vector n = scene.sum.facets.at(random() % scene.sum.facets.size()).normal;
      EXPECT_EQ(walk_from(surface, ball, {facet_of(surface, scene, n)}), walk_naive(scene.sum, ball, {n}));
    }
  }
}

TEST_P(WalksOfEveryFamily, ALargeBallHoldsAllOfP) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Case input = GetParam().make(seed, 8);
    SCOPED_TRACE(input.id);
    const ShallowScene scene(input);
    if (scene.sum.rank < 3) continue;
    const SumSurface surface(scene.hull_a, scene.hull_b);
    Ball ball{{0, 0, 0}, 0, 1};
    for (const Vector& v : scene.sum.vertices) ball.numerator = std::max(ball.numerator, mpz_class(dot(v, v)));
    EXPECT_EQ(walk_from(surface, ball, {facet_of(surface, scene, scene.sum.facets.front().normal)}),
              normals_of(scene.sum));
  }
}

INSTANTIATE_TEST_SUITE_P(ShallowWalk, WalksOfEveryFamily,
                         ::testing::ValuesIn(families::families().begin(), families::families().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace fathom::approximate
