// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of few points against its twin, quickhull, once the triangles of both are merged.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "reference/polytope/convexity.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "verify/families/families.hpp"

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
const std::vector<std::vector<std::uint32_t>> quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/// The boundary of unit cubes, whose corners are even.
Mesh cells(const std::vector<std::array<int, 3>>& all) {
  Mesh m;
  for (const auto& [x, y, z] : all)
    for (std::size_t f = 0; f < 6; ++f) {
      std::array<int, 3> next = {x, y, z};
      next[f < 2 ? 2 : f < 4 ? 1 : 0] += f % 2 == 0 ? -1 : 1;
      if (std::ranges::find(all, next) != all.end()) continue;
      for (const std::uint32_t i : quads[f]) {
        m.faces.corners.push_back(static_cast<std::uint32_t>(m.points.size()));
        m.points.push_back({2 * x + (i & 1 ? 2 : 0), 2 * y + (i & 2 ? 2 : 0), 2 * z + (i & 4 ? 2 : 0)});
      }
      m.faces.ends.push_back(static_cast<std::uint32_t>(m.points.size()));
    }
  return m;
}

/// Sides are cut at all points on them, and the parts are counted.
Seam seam_naively(const std::vector<Vector>& points, const std::vector<MeshTriangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, long> parts;
  for (const MeshTriangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      const Vector along = points[to] - points[from];
      std::map<mpz_class, std::uint32_t> on_it;
      for (std::uint32_t p = 0; p < points.size(); ++p) {
        const Vector there = points[p] - points[from];
        const mpz_class place = dot(there, along);
        if (is_zero(cross(there, along)) && place >= 0 && place <= dot(along, along)) on_it.try_emplace(place, p);
      }
      for (auto p = on_it.begin(), q = std::next(p); q != on_it.end(); ++p, ++q)
        parts[std::minmax(p->second, q->second)] += p->second < q->second ? 1 : -1;
    }
  const auto is_odd = [](const auto& part) { return part.second % 2 != 0; };
  if (std::ranges::any_of(parts, is_odd)) return Seam::open;
  return std::ranges::any_of(parts, [](const auto& part) { return part.second != 0; }) ? Seam::even : Seam::closed;
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
  EXPECT_TRUE(convexity(open).open && !convexity(turned).open && !convexity(whole).open);
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

// The same seam from all points of a side as from its ends.
TEST(MeshConvexity, AddsUpSidesAsItsTwinDoes) {
  std::array<int, 3> seen{};
  EXPECT_TRUE(holds({.seed = 6, .runs = 300}, [&] {
    std::vector<std::array<int, 3>> all;
    for (int i = *rc::gen::inRange(1, 8); i > 0; --i)
      all.push_back({*rc::gen::inRange(0, 2), *rc::gen::inRange(0, 2), *rc::gen::inRange(0, 2)});
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    Mesh m = *rc::gen::element(true, false) ? cells(all) : together(cells(all), cube(0, *rc::gen::element(2, 4)));
    const auto face = 4 * *rc::gen::inRange<std::size_t>(0, m.faces.ends.size());
    const int change = *rc::gen::inRange(0, 3);
    if (change == 1) std::reverse(m.faces.corners.begin() + face, m.faces.corners.begin() + face + 4);
    if (change == 2) std::swap(m.faces.corners[face], m.faces.corners[face + 1]);
    if (*rc::gen::element(true, false)) {  // a corner on a side
      const auto corner = static_cast<std::uint32_t>(m.points.size());
      const Point &p = m.points[m.faces.corners[face]], &q = m.points[m.faces.corners[face + 1]];
      m.points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      m.faces.corners.insert(m.faces.corners.begin() + face + 1, corner);
      for (std::uint32_t& end : m.faces.ends) end += end > face ? 1 : 0;
    }
    const Seam seam = seam_of(lattice(m), triangles(m));
    ++seen[static_cast<std::size_t>(seam)];
    EXPECT_EQ(seam, seam_naively(lattice(m), triangles(m)));
  }));
  EXPECT_GT(*std::ranges::min_element(seen), 30);
}

mpq_class ratio(const Mesh& m) {
  const MeshConvexity found = convexity(m);
  return found.dents ? found.dents->volume_ratio.value_or(-1) : 1;
}

TEST(MeshConvexity, SaysHowMuchLargerTheHullIs) {
  std::vector<std::array<int, 3>> ring, cube_of_8;
  for (int i = 0; i < 9; ++i)
    if (i != 4) ring.push_back({i % 3, i / 3, 0});
  for (int i = 0; i < 8; ++i) cube_of_8.push_back({i & 1, i >> 1 & 1, i >> 2});
  const Mesh torus = cells(ring), bend = cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  for (const Mesh& m : {torus, soup(torus), inside_out(torus)}) EXPECT_EQ(ratio(m), mpq_class(9, 8)) << "9 cells, 8";
  Mesh turned = torus;
  std::reverse(turned.faces.corners.begin(), turned.faces.corners.begin() + 4);
  EXPECT_EQ(ratio(turned), -1) << "a face looks inwards";
  EXPECT_FALSE(convexity(turned).open);
  EXPECT_EQ(ratio(bend), mpq_class(7, 6)) << "an L of 3 cells, whose hull holds half of the fourth";
  EXPECT_EQ(ratio(together(cube(0, 4), inside_out(cube(1, 2)))), mpq_class(64, 63)) << "a cavity";
  EXPECT_EQ(ratio(together(cube(0, 4), cube(1, 2))), -1) << "more than the hull, as what is in both counts twice";
  EXPECT_EQ(ratio(together(cube(0, 2), cube(1, 3))), mpq_class(5, 4)) << "20 over 8 and 8";

  // Corners on sides of larger faces: one side of the cube is a single face, the others have four.
  const auto with_one_face = [](Mesh m) {
    Mesh result = mesh({{0, 0, 0}, {0, 4, 0}, {4, 4, 0}, {4, 0, 0}}, {{0, 1, 2, 3}});
    for (std::size_t f = 0; f < m.faces.ends.size(); ++f) {
      const std::vector<Point> face(m.points.begin() + 4 * f, m.points.begin() + 4 * (f + 1));
      if (std::ranges::any_of(face, [](const Point& p) { return p.z != 0; }))
        result = together(result, mesh(face, {{0, 1, 2, 3}}));
    }
    return result;
  };
  const Mesh whole = with_one_face(cells(cube_of_8));
  EXPECT_TRUE(is_convex(whole) && !is_seen_convex(whole));
  EXPECT_FALSE(convexity(whole).open || convexity(soup(whole)).open);
  cube_of_8.pop_back();
  EXPECT_EQ(ratio(with_one_face(cells(cube_of_8))), mpq_class(47, 42)) << "7 cells, and 5/6 of one";
  Mesh hole = with_one_face(cells(cube_of_8));
  hole.faces.ends.pop_back();
  hole.faces.corners.resize(hole.faces.ends.back());
  EXPECT_TRUE(convexity(hole).open);
  EXPECT_EQ(ratio(hole), -1) << "it encloses nothing";
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
