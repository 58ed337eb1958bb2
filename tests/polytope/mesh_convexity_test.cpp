// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of few points against its twin, quickhull, once the triangles of both are merged.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "reference/polytope/convexity.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "verify/families/catalogue.hpp"

namespace fathom::polytope {
namespace {

using Ids = std::vector<std::uint32_t>;

Ids distinct(const std::vector<Vector>& points) {
  DistinctPoints seen = no_points_yet(points, points.size());
  Ids ids;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (seen.insert(i).second) ids.push_back(i);
  return ids;
}

void expect_equal(const Polytope& x, const Polytope& y) {
  ASSERT_EQ(std::vector<std::uint32_t>(x.input_ids.begin(), x.input_ids.end()),
            std::vector<std::uint32_t>(y.input_ids.begin(), y.input_ids.end()));
  ASSERT_EQ(x.corners, y.corners);
  ASSERT_EQ(x.facets.size(), y.facets.size());
  for (const FacetId f : x.facets.ids()) {
    EXPECT_EQ(x.facets[f].normal, y.facets[f].normal);
    EXPECT_EQ(x.facets[f].begin, y.facets[f].begin);
  }
  ASSERT_EQ(x.edges.size(), y.edges.size());
  for (std::size_t i = 0; i < x.edges.size(); ++i)
    EXPECT_TRUE(x.edges[i].from == y.edges[i].from && x.edges[i].to == y.edges[i].to);
}

/// Whether the points are solid; then both ways must agree.
bool agrees(const std::vector<Vector>& points) {
  if (affine_rank(points) < 3) return false;
  const Ids ids = distinct(points);
  const Polytope few = merge_coplanar(points, hull_triangles_of_few(points, ids)),
                 twin = merge_coplanar(points, hull_triangles(points, ids));
  expect_equal(few, twin);
  EXPECT_TRUE(validate(few, points).ok());
  return true;
}

TEST(HullOfFew, IsQuickhullsOnSmallLattices) {
  std::mt19937_64 random(3);
  std::size_t solid = 0;
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE(i);
    const auto reach = static_cast<unsigned long>(1 + i % 4);
    std::vector<Vector> points(4 + random() % 30);
    for (Vector& p : points)
      for (mpz_class* c : {&p.x, &p.y, &p.z}) *c = random() % (reach + 1);
    solid += agrees(points) ? 1U : 0U;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(solid, 3000U);
}

TEST(HullOfFew, IsQuickhullsOnFamiliesAndTheCatalogue) {
  std::vector<Case> cases = testing::cases_of_all_families(2, 9);
  for (const Case& more : testing::cases_of_all_families(1, 40)) cases.push_back(more);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t solid = 0;
  for (const Case& input : cases) {
    SCOPED_TRACE(input.id);
    const PlacedPair pair = place(input.a.points, input.b.points);
    for (const kernels::PointCloud* cloud : {&pair.a, &pair.b}) solid += agrees(cloud->points()) ? 1U : 0U;
  }
  EXPECT_GT(solid, 400U);
}

// Points of a cube with others added whose place is known.

const std::vector<Point> cube1{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

std::vector<Point> with(std::vector<Point> points, const std::vector<Point>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

TEST(InnerPoints, AreCounted) {
  const mpq_class half(1, 2);
  EXPECT_EQ(count_inner_points(cube1), 0U);
  EXPECT_EQ(count_inner_points(std::vector<Point>{{half, 0, 0}}), 0U);
  EXPECT_EQ(count_inner_points(with(cube1, {{half, half, half}})), 1U) << "inside";
  EXPECT_EQ(count_inner_points(with(cube1, {{half, half, 0}, {half, 0, 0}})), 2U) << "in a facet, on an edge";
  EXPECT_EQ(count_inner_points(with(cube1, cube1)), 0U) << "vertices again";
  EXPECT_EQ(count_inner_points(with(with(cube1, cube1), {{half, half, half}})), 1U) << "vertices again, and one inside";
  EXPECT_EQ(count_inner_points(with(cube1, {{half, half, half}, {half, half, half}})), 2U) << "one inner point twice";
}

TEST(InnerPoints, AreNotTriedIfDenominatorsShareLittle) {
  std::vector<Point> points = cube1;
  mpz_class prime = mpz_class(1) << 200;
  for (int i = 0; i < 100; ++i) {
    mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
    points.push_back({mpq_class(1, prime), mpq_class(1, 2), mpq_class(1, 2)});
  }
  EXPECT_EQ(count_inner_points(points), std::nullopt);
}

struct Mesh {
  std::vector<Point> points;
  MeshFaces faces;
};

Mesh mesh(std::vector<Point> points, const std::vector<std::vector<std::uint32_t>>& faces) {
  Mesh result{std::move(points), {}};
  for (const auto& face : faces) {
    result.faces.corners.insert(result.faces.corners.end(), face.begin(), face.end());
    result.faces.ends.push_back(static_cast<std::uint32_t>(result.faces.corners.size()));
  }
  return result;
}

MeshConvexity convexity(const Mesh& m) { return mesh_convexity(m.points, m.faces); }
bool is_convex(const Mesh& m) {
  const MeshConvexity result = convexity(m);
  EXPECT_TRUE(result.tried);
  return !result.dents;
}

std::vector<Vector> lattice(const Mesh& m) {
  std::vector<Vector> points;
  for (const Point& p : m.points) points.push_back({p.x.get_num(), p.y.get_num(), p.z.get_num()});
  return points;
}
std::vector<MeshTriangle> triangles(const Mesh& m) {
  std::vector<std::uint32_t> names(m.points.size());
  for (std::uint32_t i = 0; i < names.size(); ++i)
    names[i] = static_cast<std::uint32_t>(std::ranges::find(m.points, m.points[i]) - m.points.begin());
  return triangles_of(m.faces, names);
}
/// In linear time alone, without a hull.
bool is_seen_convex(const Mesh& m) { return is_convex_boundary(lattice(m), triangles(m)); }

/// Whether all points, or all corners, lie on one side of each face.
bool is_convex_naively(const Mesh& m, bool corners_alone = false) {
  const std::vector<Vector> points = lattice(m);
  std::vector<Vector> others = points;
  if (corners_alone) {
    others.clear();
    for (const std::uint32_t corner : m.faces.corners) others.push_back(points[corner]);
  }
  for (const auto& [p, q, r] : triangles(m)) {
    bool above = false, below = false;
    for (const Vector& s : others) {
      const int side = sgn(det(points[q] - points[p], points[r] - points[p], s - points[p]));
      above = above || side > 0;
      below = below || side < 0;
    }
    if (above && below) return false;
  }
  return true;
}

/// The boundary of the points' hull.
Mesh boundary(const std::vector<Point>& points) {
  std::vector<Vector> vectors;
  for (const Point& p : points) vectors.push_back({p.x.get_num(), p.y.get_num(), p.z.get_num()});
  const Polytope hull = convex_hull(vectors);
  std::vector<std::vector<std::uint32_t>> faces;
  for (const Facet& facet : hull.facets) {
    std::vector<std::uint32_t>& face = faces.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) face.push_back(hull.input_ids[hull.corners[i]]);
  }
  return mesh(points, faces);
}

Point random_point(int range) {
  return {*rc::gen::inRange(-range, range), *rc::gen::inRange(-range, range), *rc::gen::inRange(-range, range)};
}

const std::vector<std::vector<std::uint32_t>> quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
Mesh cube(int low, int high) {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low});
  return mesh(points, quads);
}
Mesh soup(const Mesh& m) {
  Mesh result;
  for (const MeshTriangle& t : triangles(m))
    for (const std::uint32_t i : t) result.points.push_back(m.points[i]);
  return result;
}
Mesh inside_out(Mesh m) {
  std::uint32_t begin = 0;
  for (const std::uint32_t end : m.faces.ends) {
    std::reverse(m.faces.corners.begin() + begin, m.faces.corners.begin() + end);
    begin = end;
  }
  return m;
}
Mesh together(const Mesh& one, const Mesh& other) {
  Mesh result = one;
  const auto points = static_cast<std::uint32_t>(one.points.size()),
             corners = static_cast<std::uint32_t>(one.faces.corners.size());
  result.points.insert(result.points.end(), other.points.begin(), other.points.end());
  for (const std::uint32_t corner : other.faces.corners) result.faces.corners.push_back(corner + points);
  for (const std::uint32_t end : other.faces.ends) result.faces.ends.push_back(end + corners);
  return result;
}

TEST(MeshConvexity, OfHullsIsSeenInLinearTime) {
  EXPECT_TRUE(holds({.seed = 5, .runs = 300}, [] {
    std::vector<Point> points;
    for (int i = *rc::gen::inRange(4, 30); i > 0; --i) points.push_back(random_point(*rc::gen::element(2, 10, 1000)));
    const Mesh m = boundary(points);
    if (m.faces.ends.size() < 4) return;  // flat
    EXPECT_TRUE(is_seen_convex(m));
    EXPECT_TRUE(is_seen_convex(inside_out(m)));
    EXPECT_TRUE(is_seen_convex(soup(m)));
    EXPECT_TRUE(is_convex_naively(m));
  }));
}

// A corner of a hull goes elsewhere: the surface stays closed.
TEST(MeshConvexity, AgreesWithItsTwin) {
  int dented = 0, found_convex = 0;
  EXPECT_TRUE(holds({.seed = 5, .runs = 300}, [&] {
    std::vector<Point> points;
    for (int i = *rc::gen::inRange(4, 12); i > 0; --i) points.push_back(random_point(4));
    Mesh m = boundary(points);
    if (m.faces.ends.size() < 4) return;
    m.points[m.faces.corners[*rc::gen::inRange<std::size_t>(0, m.faces.corners.size())]] = random_point(6);
    if (*rc::gen::element(true, false, false)) m.faces.ends.pop_back();  // and with a hole
    const bool convex = is_convex_naively(m);
    ++(convex ? found_convex : dented);
    EXPECT_EQ(is_convex(m), convex);
    EXPECT_TRUE(!is_seen_convex(m) || is_convex_naively(m, true));
  }));
  EXPECT_GT(dented, 50);
  EXPECT_GT(found_convex, 10);
}

TEST(MeshConvexity, OfEveryKindOfCube) {
  const Mesh whole = cube(0, 2);
  EXPECT_TRUE(is_seen_convex(whole));
  EXPECT_TRUE(is_seen_convex(soup(whole))) << "equal points are one";
  Mesh turned = whole;
  std::reverse(turned.faces.corners.begin(), turned.faces.corners.begin() + 4);
  EXPECT_FALSE(is_seen_convex(turned));
  EXPECT_TRUE(is_convex(turned)) << "faces need not agree on what is outside";
  Mesh open = whole;
  open.faces.ends.pop_back();
  open.faces.corners.resize(20);
  EXPECT_TRUE(is_convex(open)) << "a hole is no dent";
  Mesh wall = whole;
  wall.faces.corners.insert(wall.faces.corners.end(), {0, 3, 7, 4});
  wall.faces.ends.push_back(28);
  const MeshConvexity walled = convexity(wall);
  ASSERT_TRUE(walled.dents) << "a wall through the inside";
  EXPECT_FALSE(walled.dents->volume_ratio) << "it is not closed";
  EXPECT_EQ(walled.dents->deepest->squared_depth, 0);
  EXPECT_FALSE(is_convex(together(cube(0, 2), cube(3, 4)))) << "two";
  EXPECT_FALSE(is_convex(together(cube(0, 4), cube(1, 2)))) << "one in the other";
  EXPECT_FALSE(is_seen_convex(together(cube(0, 4), cube(0, 4)))) << "twice the same, by other corners";
  EXPECT_TRUE(is_convex(mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}))) << "flat";
}

TEST(MeshConvexity, CountsPointsThatAreNoCorners) {
  Mesh inside = cube(0, 2), outside = cube(0, 2);
  inside.points.push_back({1, 1, 1});
  outside.points.push_back({1, 1, 4});
  EXPECT_TRUE(is_convex(inside));
  EXPECT_FALSE(is_convex(outside)) << "the hull is larger than the mesh";
  EXPECT_EQ(convexity(outside).dents->volume_ratio, mpq_class(4, 3));
}

TEST(MeshConvexity, SaysHowDeepADentIs) {
  // A cube of side 4 whose top is a pyramid down to its centre.
  Mesh m = cube(0, 4);
  m.points.push_back({2, 2, 1});
  m.faces = mesh({}, {{0, 2, 3, 1},
                      {0, 1, 5, 4},
                      {2, 6, 7, 3},
                      {0, 4, 6, 2},
                      {1, 3, 7, 5},
                      {4, 5, 8},
                      {5, 7, 8},
                      {7, 6, 8},
                      {6, 4, 8}})
                .faces;
  for (const Mesh& either : {m, inside_out(m)}) {
    const MeshConvexity result = convexity(either);
    ASSERT_TRUE(result.dents);
    EXPECT_EQ(result.dents->volume_ratio, mpq_class(4, 3)) << "64 against 48";
    EXPECT_EQ(result.dents->deepest->point, 8U);
    EXPECT_EQ(result.dents->deepest->squared_depth, 1) << "the bottom is nearest";
  }
  EXPECT_TRUE(mesh_convexity(m.points, m.faces, 6).dents->deepest)
      << "one point that is no corner of the hull, and six facets";
  EXPECT_FALSE(mesh_convexity(m.points, m.faces, 5).dents->deepest);
  for (Point& p : m.points) p = {p.x / 3, p.y / 3, p.z / 3};
  EXPECT_EQ(convexity(m).dents->deepest->squared_depth, mpq_class(1, 9));
}

// An octahedron with a diagonal through its inside: all its points are extreme.
TEST(MeshConvexity, SeesDentsBetweenExtremePoints) {
  const std::vector<Point> points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Mesh dented = mesh(
      points,
      {{0, 2, 5}, {0, 5, 2}, {2, 4, 5}, {0, 5, 4}, {2, 1, 4}, {1, 2, 5}, {1, 3, 4}, {3, 1, 5}, {3, 0, 4}, {0, 3, 5}});
  const MeshConvexity result = convexity(dented);
  ASSERT_TRUE(result.dents);
  EXPECT_EQ(result.dents->deepest->squared_depth, 0);
}

// Convex at every edge, and closed, but it goes around twice.
TEST(MeshConvexity, IsNotFooledByAStar) {
  std::vector<Point> points = {{0, 1000, 0},   {951, 309, 0}, {588, -809, 0}, {-588, -809, 0},
                               {-951, 309, 0}, {0, 0, 500},   {0, 0, -500}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t j = (i + 3) % 5;  // every second point, counter-clockwise
    faces.push_back({i, j, 5});
    faces.push_back({j, i, 6});
  }
  const Mesh star = mesh(points, faces);
  EXPECT_FALSE(is_seen_convex(star));
  EXPECT_FALSE(is_convex(star));
}

TEST(MeshConvexity, IsNotTriedWithoutFaces) {
  EXPECT_FALSE(convexity(mesh({{0, 0, 0}}, {{0, 0, 0}})).tried);
  EXPECT_THROW(mesh_convexity({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::polytope
