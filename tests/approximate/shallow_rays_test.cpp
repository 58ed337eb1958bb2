// SPDX-License-Identifier: GPL-3.0-or-later
// Rays from coarse grids to fine ones: nothing that matters is skipped. Against P itself, by exact
// comparison.
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "reference/approximate/directions.hpp"
#include "reference/approximate/shallow.hpp"
#include "tests/approximate/shallow_scene.hpp"
#include "tests/support/vectors.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

namespace fathom::approximate {
namespace {

using testing::factor_naive;
using testing::ShallowScene;

mpq_class square(const mpq_class& q) { return q * q; }

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
