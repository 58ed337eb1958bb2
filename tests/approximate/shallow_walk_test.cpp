// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit boundary of P and the walk over it, against P itself: the hull of all vertex
// differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "reference/approximate/shallow.hpp"
#include "tests/approximate/shallow_scene.hpp"
#include "tests/support/vectors.hpp"
#include "verify/families/families.hpp"

namespace fathom::approximate {
namespace {

using testing::NormalSet;
using testing::ShallowScene;

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
