// SPDX-License-Identifier: GPL-3.0-or-later
// Where an expanding polytope starts, and its surface, with integers of both kinds.
#include "reference/expanding/surface.hpp"

#include <gtest/gtest.h>

#include "kernels/filters/rounded_plane.hpp"
#include "kernels/predicates/direction.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/expanding/small_bodies.hpp"

namespace fathom::expanding {
namespace {

TEST(StartingTetrahedron, IsFoundExactlyIfPIsSolidAndTheSameWithAllIntegers) {
  Random random(4);
  std::size_t solid = 0, flat = 0;
  kernels::ScanMemory memory;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vector> a = small_body(random, i % 3), b = small_body(random, i % 2);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    std::vector<Vector> differences;
    for (const Vector& p : a)
      for (const Vector& q : b) differences.push_back(q - p);
    polytope::Differences search{clouds.a, clouds.b};
    const auto start = starting_tetrahedron(search);
    ASSERT_EQ(start.has_value(), polytope::affine_rank(differences) == 3) << i;
    polytope::NarrowDifferences narrow{{clouds.a, memory}, {clouds.b, memory}};
    ASSERT_EQ(starting_tetrahedron(narrow), start) << i;
    ++(start ? solid : flat);
    if (!start) continue;
    const Vector p = search[(*start)[0]];
    EXPECT_NE(det(search[(*start)[1]] - p, search[(*start)[2]] - p, search[(*start)[3]] - p), 0);
  }
  EXPECT_GT(solid, 200U);
  EXPECT_GT(flat, 200U);
}

template <class Integer>
class SurfaceOf : public ::testing::Test {
 public:
  static SurfaceVertex<Integer> vertex(const Vector& v, std::uint32_t name = 0) {
    const Vec3<Integer> exact{Integer(v.x), Integer(v.y), Integer(v.z)};
    return {{0, name}, exact, kernels::image(exact, 4)};
  }
};
using AllIntegers = ::testing::Types<mpz_class, polytope::NarrowInteger>;
TYPED_TEST_SUITE(SurfaceOf, AllIntegers);

TYPED_TEST(SurfaceOf, IsTheHullWhateverTheOrderOfThePoints) {
  Random random(5);
  Surface<TypeParam> surface;
  MergeMemory memory;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Vector> points;
    const std::size_t reach = 2 + i % 3;
    const auto coordinate = [&] { return mpz_class(static_cast<unsigned long>(random() % reach)); };
    for (int k = 0; k < 14; ++k) points.push_back({coordinate(), coordinate(), coordinate()});
    const auto vertex = [&](std::uint32_t j) { return this->vertex(points[j], j); };
    if (det(Vector(points[1] - points[0]), Vector(points[2] - points[0]), Vector(points[3] - points[0])) == 0) continue;
    surface.start({vertex(0), vertex(1), vertex(2), vertex(3)});
    for (std::uint32_t j = 4; j < points.size(); ++j) {
      for (const TriangleId t : surface.triangles().ids()) {
        if (!surface.triangles()[t].alive || surface.side(t, vertex(j)) <= 0) continue;
        for (const TriangleId fresh : surface.insert(vertex(j), t)) ASSERT_FALSE(is_zero(surface.plane(fresh).normal));
        break;
      }
    }
    expect_hull(inner_polytope(surface, memory), kernels::PointCloud({{0, 0, 0}}), kernels::PointCloud(points));
  }
}

TYPED_TEST(SurfaceOf, RefusesAFlatStartAndPointsThatAreNotAbove) {
  const auto vertex = [](long x, long y, long z) { return SurfaceOf<TypeParam>::vertex({x, y, z}); };
  Surface<TypeParam> surface;
  EXPECT_THROW(surface.start({vertex(0, 0, 0), vertex(1, 0, 0), vertex(0, 1, 0), vertex(1, 1, 0)}), std::logic_error);
  surface.start({vertex(0, 0, 0), vertex(4, 0, 0), vertex(0, 4, 0), vertex(0, 0, 4)});
  EXPECT_EQ(surface.alive(), 4U);
  for (const TriangleId t : surface.triangles().ids()) {
    EXPECT_EQ(surface.side(t, vertex(1, 1, 1)), -1);
    EXPECT_THROW(surface.insert(vertex(1, 1, 1), t), std::logic_error);
  }
}

}  // namespace
}  // namespace fathom::expanding
