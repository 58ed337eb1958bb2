// SPDX-License-Identifier: GPL-3.0-or-later
// Faces by their definition against the faces of convex hulls.
#include "verify/golden/records/faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/families.hpp"

namespace fathom::golden {
namespace {

// Every facet, every edge (in the sum of its facets' directions) and every vertex of bodies with
// repeated, collinear and interior points.
TEST(Faces, AreThoseOfTheHull) {
  for (const char* name :
       {"redundant_points", "boxes_aligned", "degraded_coplanar_points", "solid_polygon", "random_lattice"}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Case pair = families::find_family(name)->make(seed, 10);
      const Integers bodies = integers_of(pair.a.points, pair.b.points);
      for (const std::vector<Vector>* points : {&bodies.a, &bodies.b}) {
        const polytope::Polytope hull = polytope::convex_hull(*points);
        for (const polytope::Facet& facet : hull.facets) {
          std::vector<std::uint32_t> corners;
          for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.input_ids[hull.corners[i]]);
          std::ranges::sort(corners);
          EXPECT_EQ(face_in_direction(*points, facet.normal).corners, corners) << pair.id;
        }
        if (hull.rank < 3) continue;
        for (const polytope::Edge& edge : hull.edges) {
          const std::vector<std::uint32_t> ends{hull.input_ids[edge.from], hull.input_ids[edge.to]};
          EXPECT_EQ(face_in_direction(*points, hull.facets[edge.left].normal + hull.facets[edge.right].normal).corners,
                    ends)
              << pair.id;
        }
      }
    }
  }
}

TEST(Faces, HoldTheirPointsAndNoOthers) {
  const std::vector<Point> points{
      {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {2, 2, 0}, {1, 1, 3}, {mpq_class(1, 3), 0, 0}};
  const Integers bodies = integers_of(points, points);
  EXPECT_EQ(bodies.denominator, 3);
  const Vector down{0, 0, -1}, side{-3, 0, 1}, corner{-1, -2, -3};
  const SupportingFace square = face_in_direction(bodies.a, down), edge = face_in_direction(bodies.a, side),
                       tip = face_in_direction(bodies.a, corner);
  EXPECT_EQ(square.corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(tip.corners, (std::vector<std::uint32_t>{0}));
  const auto in = [&](const SupportingFace& face, const Vector& n, const Point& p) {
    return contains(face, n, bodies.denominator, p);
  };
  for (const Point& p : {points[0], points[4], points[6], mpq_class(1, 2) * (points[1] + points[3]),
                         Point{mpq_class(1, 7), mpq_class(1, 5), 0}})
    EXPECT_TRUE(in(square, down, p));
  for (const Point& p : {points[5], Point{2, 2, mpq_class(1, 9)}, Point{mpq_class(-1, 99), 1, 0}, Point{5, 0, 0},
                         Point{4, mpq_class(41, 10), 0}})
    EXPECT_FALSE(in(square, down, p));
  EXPECT_TRUE(in(tip, corner, points[0]));
  EXPECT_FALSE(in(tip, corner, points[6]));
  ASSERT_EQ(edge.corners.size(), 3u) << "0, 2 and 5 lie in one plane";
}

TEST(Faces, EdgesEndAtTheirEnds) {
  const std::vector<Point> points{{0, 0, 0}, {2, 4, 6}, {1, 2, 3}, {5, 0, 0}};
  const Vector n{-7, 2, 1};  // <n, (1,2,3)> = 0
  const Integers bodies = integers_of(points, points);
  const SupportingFace edge = face_in_direction(bodies.a, n);
  EXPECT_EQ(edge.corners, (std::vector<std::uint32_t>{0, 1}));
  const auto in = [&](const Point& p) { return contains(edge, n, bodies.denominator, p); };
  EXPECT_TRUE(in(points[0]) && in(points[1]) && in(points[2]));
  EXPECT_TRUE(in({mpq_class(1, 3), mpq_class(2, 3), 1}));
  EXPECT_FALSE(in({3, 6, 9}));
  EXPECT_FALSE(in({-1, -2, -3}));
  EXPECT_FALSE(in({0, -1, 2}));
}

}  // namespace
}  // namespace fathom::golden
