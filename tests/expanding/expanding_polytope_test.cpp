// SPDX-License-Identifier: GPL-3.0-or-later
// The expanding polytope against the hull of all differences.
#include "reference/expanding/expanding_polytope.hpp"

#include <gtest/gtest.h>

#include "kernels/number/ratio.hpp"
#include "reference/depth/naive_depth.hpp"
#include "reference/expanding/inner_polytope.hpp"
#include "reference/expanding/start.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::expanding {
namespace {

using Random = std::mt19937_64;

/// Few points on a small lattice: ties, coplanar and collinear points, flat bodies everywhere.
std::vector<Vector> small_body(Random& random, long reach) {
  std::vector<Vector> points(1 + random() % 9);
  const auto coordinate = [&] { return mpz_class(static_cast<long>(random() % static_cast<unsigned long>(2 * reach + 1)) - reach); };
  for (Vector& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

std::vector<Vector> directions(const kernels::NearestPlanes& nearest) { return {nearest.directions().begin(), nearest.directions().end()}; }

/// Q by definition: corners of its facets are all vertices on the facet's plane, and these are all facets of the hull of its vertices.
void expect_hull(const InnerPolytope& inner, const kernels::PointCloud& a, const kernels::PointCloud& b) {
  std::vector<Vector> vertices;
  for (const auto& [i, j] : inner.vertices) vertices.push_back(b[j] - a[i]);
  const polytope::Polytope hull = polytope::convex_hull(vertices);
  ASSERT_EQ(hull.vertices.size(), vertices.size()) << "a vertex is not extreme";
  std::vector<std::vector<std::uint32_t>> found = inner.facets, expected;
  for (std::vector<std::uint32_t>& facet : found) std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  for (const polytope::Facet& facet : hull.facets)
    expected.emplace_back(hull.corners.begin() + facet.begin, hull.corners.begin() + facet.end);
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(found, expected);
}

TEST(ExpandingPolytope, FindsTheNearestFacetsOfTheHullOfDifferences) {
  kernels::Context context;
  Random random(1);
  std::size_t penetrating = 0, ties = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::vector<Vector> a = small_body(random, 1 + i % 4), b = i % 3 == 0 ? a : small_body(random, 2 + i % 5);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    const Expansion expansion = nearest_by_expansion(context, clouds.a, clouds.b);
    ASSERT_EQ(expansion.end, naive.status == Status::penetrating ? ExpansionEnd::proved : ExpansionEnd::not_inside) << i;
    if (naive.status != Status::penetrating) continue;
    ++penetrating;
    ties += naive.directions.size() > 1 ? 1U : 0U;
    EXPECT_EQ(directions(expansion.nearest), naive.directions) << i;
    EXPECT_EQ(kernels::ratio(expansion.nearest.numerator(), expansion.nearest.denominator()), naive.squared) << i;
    expect_hull(expansion.inner, clouds.a, clouds.b);
  }
  EXPECT_GT(penetrating, 300U);
  EXPECT_GT(ties, 100U);
}

TEST(ExpandingPolytope, GrowsOnFamiliesToAHullThatHoldsTheBall) {
  kernels::Context context;
  for (const Case& input : testing::cases_of_all_families(2, 24)) {
    const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
    const Expansion expansion = nearest_by_expansion(context, clouds.a, clouds.b);
    if (expansion.end != ExpansionEnd::proved) continue;
    SCOPED_TRACE(input.id);
    expect_hull(expansion.inner, clouds.a, clouds.b);
    const kernels::Report report = validate(expansion, clouds.a, clouds.b);
    EXPECT_TRUE(report.ok()) << testing::text(report);
  }
}

TEST(ExpandingPolytope, ValidateSeesEachKindOfFault) {
  kernels::Context context;
  const Case input = families::find_family("crossed_fans")->make(1, 12);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  const Expansion right = nearest_by_expansion(context, clouds.a, clouds.b);
  ASSERT_TRUE(validate(right, clouds.a, clouds.b).ok());
  using Change = void (*)(Expansion&);
  const Change changes[] = {
      [](Expansion& e) { e.end = ExpansionEnd::spent; },
      [](Expansion& e) { e.nearest = {}; },
      [](Expansion& e) {
        e.nearest.offer({1, 2, 3}, 1);
      },
      [](Expansion& e) {
        const mpz_class numerator = e.nearest.numerator();
        e.nearest = {};
        e.nearest.offer({1, 0, 0}, numerator);
      },
      [](Expansion& e) { e.inner.facets.pop_back(); },
      [](Expansion& e) { e.inner.facets.push_back(e.inner.facets.front()); },
      [](Expansion& e) { std::reverse(e.inner.facets.front().begin(), e.inner.facets.front().end()); },
      [](Expansion& e) { e.inner.facets.front().pop_back(); },
      [](Expansion& e) { e.inner.facets.front().front() = 1000; },
      [](Expansion& e) { e.inner.vertices.front().second = 1000; },
      [](Expansion& e) { std::swap(e.inner.vertices[0], e.inner.vertices[1]); },
      [](Expansion& e) {
        e.inner.vertices.push_back({0, 0});
      },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Expansion wrong = right;
    changes[i](wrong);
    EXPECT_FALSE(validate(wrong, clouds.a, clouds.b).ok()) << "change " << i;
  }
}

TEST(ExpandingPolytope, GivesUpAtItsBudgetAndAsksAtEachStepWhetherToGoOn) {
  const Case input = families::find_family("crossed_patch")->make(1, 20);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  struct Steps final : Monitor {
    void report(std::string_view, double) override {}
    bool stopped() override { return ++asked > most; }
    std::size_t asked = 0, most = unlimited;
  } steps;
  kernels::Context context(&steps);
  const Expansion whole = nearest_by_expansion(context, clouds.a, clouds.b);
  ASSERT_EQ(whole.end, ExpansionEnd::proved);
  EXPECT_GE(steps.asked, whole.points);
  EXPECT_GT(whole.points, 50U);
  EXPECT_EQ(nearest_by_expansion(context, clouds.a, clouds.b, whole.points - 1).end, ExpansionEnd::spent);
  EXPECT_EQ(nearest_by_expansion(context, clouds.a, clouds.b, whole.points).end, ExpansionEnd::proved);
  steps = {};
  steps.most = whole.points / 2;
  EXPECT_THROW(nearest_by_expansion(context, clouds.a, clouds.b), Interrupted);
  EXPECT_EQ(steps.asked, steps.most + 1);
}

TEST(ExpandingPolytope, ABallIsHeldExactlyIfItFits) {
  kernels::Context context;
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    const std::vector<Vector> a = small_body(random, 3), b = small_body(random, 4);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    if (naive.status != Status::penetrating) continue;
    const mpq_class little(1, 1000), q = naive.squared;
    for (const mpq_class& low : {mpq_class(0), mpq_class(q / 2), q, mpq_class(q * (1 + little))}) {
      for (const mpq_class& high : {mpq_class(q * (1 - little)), q, mpq_class(q * 3)}) {
        const BallExpansion ball = expand_to_ball(context, clouds.a, clouds.b, low, high);
        ASSERT_EQ(ball.end, ExpansionEnd::proved);
        EXPECT_EQ(ball.low_holds, low <= q);
        EXPECT_EQ(ball.high_holds, high >= q);
        if (ball.low_holds) expect_hull(ball.inner, clouds.a, clouds.b);
      }
    }
    const Vector& n = naive.directions.front();
    EXPECT_EQ(expand_to_ball(context, clouds.a, clouds.b, 0, q, n).direction, n) << "the hint is used";
    EXPECT_EQ(expand_to_ball(context, clouds.a, clouds.b, 0, q, Vector{0, 0, 0}).high_holds, true) << "a useless hint does no harm";
  }
}

TEST(ExpandingPolytope, RefusesCloudsThatDoNotBelongTogether) {
  kernels::Context context;
  const kernels::PointCloud none, one({{1, 2, 3}}), fine({{1, 2, 3}}, 10);
  EXPECT_THROW(nearest_by_expansion(context, none, one), std::invalid_argument);
  EXPECT_THROW(nearest_by_expansion(context, one, fine), std::invalid_argument);
}

TEST(StartingTetrahedron, IsFoundExactlyIfPIsSolid) {
  Random random(4);
  std::size_t solid = 0, flat = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vector> a = small_body(random, i % 3), b = small_body(random, i % 2);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    std::vector<Vector> differences;
    for (const Vector& p : a)
      for (const Vector& q : b) differences.push_back(q - p);
    polytope::Differences search{clouds.a, clouds.b};
    const auto start = starting_tetrahedron(search);
    ASSERT_EQ(start.has_value(), polytope::affine_rank(differences) == 3) << i;
    ++(start ? solid : flat);
    if (!start) continue;
    const Vector p = search[(*start)[0]];
    EXPECT_NE(det(search[(*start)[1]] - p, search[(*start)[2]] - p, search[(*start)[3]] - p), 0);
  }
  EXPECT_GT(solid, 200U);
  EXPECT_GT(flat, 200U);
}

TEST(Surface, IsTheHullWhateverTheOrderOfThePoints) {
  Random random(5);
  for (int i = 0; i < 1500; ++i) {
    std::vector<Vector> points;
    const std::size_t reach = 2 + i % 3;
    const auto coordinate = [&] { return mpz_class(static_cast<unsigned long>(random() % reach)); };
    for (int k = 0; k < 14; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    const auto vertex = [&](std::uint32_t j) { return SurfaceVertex{{0, j}, points[j], kernels::image(points[j], 3)}; };
    if (det(Vector(points[1] - points[0]), Vector(points[2] - points[0]), Vector(points[3] - points[0])) == 0) continue;
    Surface surface({vertex(0), vertex(1), vertex(2), vertex(3)}, 3);
    for (std::uint32_t j = 4; j < points.size(); ++j) {
      for (const TriangleId t : surface.triangles().ids()) {
        if (!surface.triangles()[t].alive || surface.side(t, vertex(j)) <= 0) continue;
        for (const TriangleId fresh : surface.insert(vertex(j), t)) ASSERT_FALSE(is_zero(surface.plane(fresh).normal));
        break;
      }
    }
    expect_hull(inner_polytope(surface), kernels::PointCloud({{0, 0, 0}}), kernels::PointCloud(points));
  }
}

TEST(Surface, RefusesAFlatStartAndPointsThatAreNotAbove) {
  const auto vertex = [](long x, long y, long z) {
    const Vector v{x, y, z};
    return SurfaceVertex{{0, 0}, v, kernels::image(v, 4)};
  };
  EXPECT_THROW(Surface({vertex(0, 0, 0), vertex(1, 0, 0), vertex(0, 1, 0), vertex(1, 1, 0)}, 4), std::logic_error);
  Surface surface({vertex(0, 0, 0), vertex(4, 0, 0), vertex(0, 4, 0), vertex(0, 0, 4)}, 4);
  EXPECT_EQ(surface.alive(), 4U);
  for (const TriangleId t : surface.triangles().ids()) {
    EXPECT_EQ(surface.side(t, vertex(1, 1, 1)), -1);
    EXPECT_THROW(surface.insert(vertex(1, 1, 1), t), std::logic_error);
  }
}

}  // namespace
}  // namespace fathom::expanding
