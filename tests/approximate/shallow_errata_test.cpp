// SPDX-License-Identifier: GPL-3.0-or-later
// Where SHALLOW-PENETRATION, taken to the letter, does not compute the depth, or not within its
// bound.                                                                         [proofs/errata.md]
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "reference/approximate/directions.hpp"
#include "reference/approximate/shallow.hpp"

namespace fathom::approximate {
namespace {

/// P as B, A being the point O; all in units of the input.
struct JustP {
  explicit JustP(const std::vector<Vector>& corners)
      : origin(polytope::convex_hull(std::vector<Vector>{{0, 0, 0}})),
        p(polytope::convex_hull(corners)),
        a(origin),
        b(p),
        surface(origin, p) {}

  [[nodiscard]] SumFacet facet(const Vector& n) const {
    return surface.facet(a.extreme_face(-n), b.extreme_face(n), n);
  }
  /// The nearest facets that a walk in the ball finds.
  [[nodiscard]] kernels::NearestPlanes nearest(const Ball& ball, const std::vector<SumFacet>& starts) const {
    kernels::NearestPlanes planes;
    kernels::Context context;
    walk(context, surface, ball, starts,
         [&](const SumFacet& f) { planes.offer(f.normal, dot(f.normal, surface.point(f))); });
    return planes;
  }

  polytope::Polytope origin, p;
  polytope::Hierarchy a, b;
  SumSurface surface;
};

mpq_class squared(const kernels::NearestPlanes& planes) {
  mpq_class q(planes.numerator(), planes.denominator());
  q.canonicalize();
  return q;
}

mpq_class squared_reach(const JustP& p, const Vector& u) {
  const RayHit hit = shoot_ray(p.a, p.b, u);
  return hit.factor * hit.factor * dot(u, u);
}

/// The ball of radius (1 + delta/2) reach.
Ball ball(const mpq_class& delta, const mpq_class& reach_squared) {
  const mpq_class radius_squared = (1 + delta / 2) * (1 + delta / 2) * reach_squared;
  return {{0, 0, 0}, radius_squared.get_num(), radius_squared.get_den()};
}

bool in_reach(const mpq_class& delta, const mpq_class& reach_squared, const mpq_class& least_squared) {
  return reach_squared <= (1 + delta / 4) * (1 + delta / 4) * least_squared;
}

/// The box [-r,r]^2 x [-z,z].
std::vector<Vector> box(long r, long z) {
  std::vector<Vector> corners;
  for (const long x : {-r, r})
    for (const long y : {-r, r})
      for (const long h : {-z, z}) corners.push_back({x, y, h});
  return corners;
}

// ---- the start ----

// "Compute the face f of P supported by the plane orthogonal to u": for u = (.001,.002,1) a vertex
// at a distance of 141, where the ball has the radius 1.125 (delta = 1/4). No connected component
// of the boundary within the ball contains it. The ray u hits the top, at 1.
TEST(ShallowErrata, TheFaceThatUSupportsIsFarFromTheBall) {
  const JustP p(box(100, 1));
  const Vector u{1, 2, 1000};
  const mpq_class delta(1, 4), depth_squared = 1;
  EXPECT_TRUE(in_reach(delta, squared_reach(p, u), depth_squared)) << "u is in G', whatever grid it comes from";
  const std::vector<polytope::VertexId> supported = p.b.extreme_face(u);
  ASSERT_EQ(supported.size(), 1U);
  const Vector& vertex = p.p.vertices[supported.front()];
  EXPECT_EQ(vertex, (Vector{100, 100, 1}));
  EXPECT_FALSE(ball(delta, depth_squared).holds(vertex));
  EXPECT_EQ(shoot_ray(p.a, p.b, u).normal, (Vector{0, 0, 1}));
}

// The box with a rim that slopes down a little, in units of 1/1000: no facet at the vertex that u
// supports comes within 50 of O. From whichever of them the walk starts, it ends there, with a
// plane farther than the depth, which is 1.
TEST(ShallowErrata, AWalkFromTheFaceThatUSupportsMissesTheDepth) {
  kernels::Context context;
  std::vector<Vector> corners = box(50000, 1000);
  for (const Vector& v : box(100000, 995)) corners.push_back(v);
  const JustP p(corners);
  ASSERT_EQ(p.p.vertices.size(), 16U);
  const Vector u{1, 2, 1000};
  const mpq_class delta(1, 4), depth_squared = 1000000;
  EXPECT_TRUE(in_reach(delta, squared_reach(p, u), depth_squared));
  const std::vector<polytope::VertexId> supported = p.b.extreme_face(u);
  ASSERT_EQ(supported.size(), 1U);
  EXPECT_EQ(p.p.vertices[supported.front()], (Vector{100000, 100000, 995}));
  const Ball near = ball(delta, depth_squared);
  std::size_t facets = 0;
  for (const polytope::Facet& f : p.p.facets) {
    const auto first = p.p.corners.begin() + f.begin, last = p.p.corners.begin() + f.end;
    if (std::find(first, last, supported.front()) == last) continue;
    ++facets;
    const kernels::NearestPlanes found = p.nearest(near, {p.facet(f.normal)});
    ASSERT_EQ(found.directions().size(), 1U) << "it stays where it is";
    EXPECT_GT(squared(found), depth_squared);
  }
  EXPECT_EQ(facets, 4U);
  EXPECT_EQ(squared(p.nearest(near, {p.facet(shoot_ray(p.a, p.b, u).normal)})), depth_squared);
  const ShallowResult result = ShallowPenetration(context, p.a, p.b, delta).query(context);
  EXPECT_EQ(squared(result.nearest), depth_squared);
  EXPECT_EQ(result.nearest.directions().size(), 2U);
}

// ---- the grid ----

// Step 1 takes the grid for delta, step 2 an approximation within 1 + delta/4. With delta = 1 the
// grid may be the six axes. P is a tetrahedron: x + y + z <= 17 is at 17 / sqrt 3 = 9.81, x >= -10
// at 10, the others at 60. The shortest ray, 10 along -x, is within 5/4 of the depth. The rays that
// cover (1,1,1) have the length 17 > 12.5: not in G'. The walk from x = -10 stays there: the edge
// to the nearest facet is at a distance of 21, the ball has the radius 15.
TEST(ShallowErrata, TheGridForDeltaMissesTheDepth) {
  kernels::Context context;
  const JustP p({{-10, -60, -60}, {137, -60, -60}, {-10, 87, -60}, {-10, -60, 87}});
  const mpq_class delta = 1;
  const DirectionGrid coarse(context, delta);
  std::vector<Vector> directions;
  for (std::uint64_t cell = 0; cell < coarse.size(); ++cell) directions.push_back(coarse.centre(cell));
  ASSERT_EQ(directions.size(), 6U);
  mpq_class least_squared = squared_reach(p, directions.front());
  for (const Vector& u : directions) least_squared = std::min(least_squared, squared_reach(p, u));
  EXPECT_EQ(least_squared, 100);
  const mpq_class depth_squared(289, 3);
  EXPECT_LE(least_squared, (1 + delta / 4) * (1 + delta / 4) * depth_squared) << "as step 2 promises";

  std::vector<SumFacet> starts;
  for (const Vector& u : directions) {
    if (in_reach(delta, squared_reach(p, u), least_squared)) starts.push_back(p.facet(shoot_ray(p.a, p.b, u).normal));
  }
  EXPECT_EQ(squared(p.nearest(ball(delta, least_squared), starts)), 100) << "the letter of the text";
  EXPECT_EQ(squared(ShallowPenetration(context, p.a, p.b, delta).query(context).nearest), depth_squared)
      << "with the grid for delta / 4";
}

// ---- delta ----

// (1 + delta/2) (1 + delta/4) <= 1 + delta, which puts the ball within (1 + delta) depth, holds up
// to delta = 2 and no farther.
TEST(ShallowErrata, TheBallIsWithinItsBoundUpToDeltaTwo) {
  kernels::Context context;
  const auto ball_within_bound = [](const mpq_class& d) { return (1 + d / 2) * (1 + d / 4) <= 1 + d; };
  for (int i = 1; i <= 200; ++i) EXPECT_TRUE(ball_within_bound(mpq_class(i, 100)));
  EXPECT_FALSE(ball_within_bound(mpq_class(201, 100)));
  const JustP p(box(3, 1));
  EXPECT_NO_THROW(ShallowPenetration(context, p.a, p.b, 2));
  EXPECT_THROW(ShallowPenetration(context, p.a, p.b, mpq_class(201, 100)), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::approximate
