// SPDX-License-Identifier: GPL-3.0-or-later
// Where SHALLOW-PENETRATION, taken to the letter, does not compute the depth, or not within its
// bound.                                                                         [proofs/errata.md]

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "reference/approximate/separation.hpp"
#include "reference/approximate/shallow.hpp"
#include "tests/approximate/shallow_scene.hpp"
#include "tests/support/vectors.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

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

// Rays from coarse grids to fine ones: nothing that matters is skipped. Against P itself, by exact
// comparison.

using testing::factor_naive;
using testing::ShallowScene;
using testing::square;

mpq_class depth_squared(const polytope::Polytope& p) {
  mpq_class least = -1;
  for (const polytope::Facet& f : p.facets) {
    const mpz_class h = testing::height(p, f);
    const mpq_class here = kernels::ratio(h * h, dot(f.normal, f.normal));
    if (least < 0 || here < least) least = here;
  }
  return least;
}

/// The laws of `rays`, with P itself at hand.
void expect_laws(const NearRays& rays, const polytope::Polytope& p, const mpq_class& delta) {
  const mpq_class factor = square(1 + delta), least = depth_squared(p), limit = factor * rays.nearest_squared;
  EXPECT_GE(rays.nearest_squared, least);
  EXPECT_LE(rays.nearest_squared, factor * least);
  testing::NormalSet shot;
  for (const NearRay& ray : rays.in_reach) {
    EXPECT_EQ(ray.factor, factor_naive(p, ray.direction));
    EXPECT_EQ(ray.length_squared, square(ray.factor) * dot(ray.direction, ray.direction));
    EXPECT_LE(ray.length_squared, limit);
    EXPECT_TRUE(testing::is_hit(p, ray.normal, ray.factor, ray.direction));
    shot.insert(ray.direction);
  }
  kernels::Context context;
  const DirectionGrid grid(context, delta);
  for (std::uint64_t cell = 0; cell < grid.size(); ++cell) {
    const Vector u = grid.centre(cell);
    EXPECT_TRUE(shot.contains(u) || square(factor_naive(p, u)) * dot(u, u) > limit) << "skipped: " << u;
  }
  EXPECT_GE(rays.rays + rays.skipped, grid.size());
}

class RaysOfEveryFamily : public ::testing::TestWithParam<families::Family> {};

TEST_P(RaysOfEveryFamily, SkipsNoRayWithinReach) {
  kernels::Context context;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Case input = GetParam().make(seed, 6);
    SCOPED_TRACE(input.id);
    const ShallowScene scene(input);
    if (scene.sum.rank < 3) continue;
    const RayShooter shooter(scene.a, scene.b);
    const mpq_class delta = seed == 1 ? mpq_class(1, 16) : seed == 2 ? mpq_class(1, 2) : mpq_class(3);
    const NearRays rays = RayGrids(context, delta).shoot(context, shooter, {0, 0, 0});
    EXPECT_EQ(rays.inside, testing::holds_origin(scene.sum));
    if (rays.inside) expect_laws(rays, scene.sum, delta);
  }
}

// The bound against the gauge itself. It is never below it, and it is the gauge where the axes and
// the nearest ray meet one facet.
TEST_P(RaysOfEveryFamily, TheBoundIsNeverBelowTheGauge) {
  std::mt19937_64 random(3);
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const Case input = GetParam().make(seed, 5);
    const ShallowScene scene(input);
    if (!testing::holds_origin(scene.sum)) continue;
    GaugeBound bound;
    for (int i = 0; i < 12; ++i) {
      const Vector axis[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
      const Vector u = i < 6 ? axis[i] : testing::random_direction(random, 2 + static_cast<unsigned long>(i) % 3);
      bound.add({u, {}, factor_naive(scene.sum, u), 0});
      if (i < 5) continue;
      for (int j = 0; j < 8; ++j) {
        const Vector v = testing::random_direction(random, 3);
        EXPECT_FALSE(bound.below(v, square(factor_naive(scene.sum, v)))) << input.id << v;
      }
      EXPECT_TRUE(bound.below(u, square(factor_naive(scene.sum, u)) * mpq_class(999, 1000)))
          << input.id << u << ": a ray bounds itself";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ShallowRays, RaysOfEveryFamily,
                         ::testing::ValuesIn(families::families().begin(), families::families().end()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ShallowRays, FarSidesTakeFewRays) {
  kernels::Context context;
  const ShallowScene plate({"a plate", {{{0, 0, 0}}}, families::box(100, 100, 1)}),
      cube({"a cube", {{{0, 0, 0}}}, families::box(1, 1, 1)});
  const RayShooter through_plate(plate.a, plate.b), through_cube(cube.a, cube.b);
  for (const mpq_class& delta : {mpq_class(1, 16), mpq_class(1, 100)}) {
    const RayGrids grids(context, delta);
    const NearRays of_plate = grids.shoot(context, through_plate, {0, 0, 0}),
                   of_cube = grids.shoot(context, through_cube, {0, 0, 0});
    expect_laws(of_plate, plate.sum, delta);
    expect_laws(of_cube, cube.sum, delta);
    EXPECT_LE(of_plate.rays, of_plate.skipped / 4);
    EXPECT_GT(of_cube.rays, 0U);
    EXPECT_EQ(of_cube.nearest_squared, 1);
  }
}

TEST(ShallowRays, FromOtherPlacesAndOutside) {
  kernels::Context context;
  const ShallowScene scene({"a box", {{{0, 0, 0}}}, families::box(4, 5, 6)});
  const RayShooter shooter(scene.a, scene.b);
  const RayGrids grids(context, mpq_class(1, 4));
  const Vector b = scene.placed.b[0] - scene.placed.a[0];  // a corner of P
  EXPECT_FALSE(grids.shoot(context, shooter, b).inside);
  EXPECT_FALSE(grids.shoot(context, shooter, {b.x * 2, b.y, b.z}).inside);
  const Vector inside{0, 2, 0};
  const NearRays rays = grids.shoot(context, shooter, inside);
  EXPECT_TRUE(rays.inside);
  expect_laws(rays, testing::differences(scene.placed, inside), mpq_class(1, 4));
}

TEST(ShallowRays, RefusesWhatIsNoDelta) {
  kernels::Context context;
  EXPECT_THROW(RayGrids(context, mpq_class(0)), std::invalid_argument);
  EXPECT_THROW(RayGrids(context, mpq_class(-1, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::approximate
