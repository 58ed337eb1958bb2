// SPDX-License-Identifier: GPL-3.0-or-later
// What reference/polytope/hull_triangles.cpp relies on in CGAL's quickhull and no manual promises:
// where the first four corners come from, that a traits class decides alone which facets a point
// sees, and which way round the triangles come back. Each test fails if another version of CGAL
// does otherwise.
#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fathom::polytope {
namespace {

using K = CGAL::Simple_cartesian<double>;  // exact on the small integers below
using Point_3 = K::Point_3;
using Base = CGAL::Convex_hull_traits_3<K>;

// A plane, by the points that it is made of, in their order.
using Made = std::array<Point_3, 3>;

/// Writes down which planes are made, and counts points on a plane as moved inward if they are to.
struct TracingTraits : Base {
  std::vector<Made>* made;
  bool inward;

  struct Construct_plane_3 {
    std::vector<Made>* made;
    Base::Plane_3 operator()(const Point_3& p, const Point_3& q, const Point_3& r) const {
      made->push_back({p, q, r});
      return Base().construct_plane_3_object()(p, q, r);
    }
  };
  struct Has_on_positive_side_3 {
    bool inward;
    bool operator()(const Base::Plane_3& h, const Point_3& s) const {
      const CGAL::Orientation side = CGAL::orientation(h.p(), h.q(), h.r(), s);
      if (side != CGAL::COPLANAR || !inward) return side == CGAL::POSITIVE;
      return CGAL::orientation(h.p(), h.q(), h.r(), Point_3(0, 0, 0)) ==
             CGAL::POSITIVE;  // all hulls here hold the origin
    }
  };

  [[nodiscard]] Construct_plane_3 construct_plane_3_object() const { return {made}; }
  [[nodiscard]] Has_on_positive_side_3 has_on_positive_side_3_object() const { return {inward}; }
};

struct Hull {
  std::vector<Point_3> corners;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<Made> made;
};

Hull hull_of(std::vector<Point_3> points, bool inward) {
  Hull hull;
  const TracingTraits traits{{}, &hull.made, inward};
  CGAL::convex_hull_3<std::vector<Point_3>::iterator, void>(points.begin(), points.end(), hull.corners, hull.triangles,
                                                            traits);
  return hull;
}

// No four of its corners that hold no antipodal pair lie in one plane.
const std::vector<Point_3> octahedron{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-4, 0, 0}, {0, -4, 0}, {0, 0, -4}};

TEST(Quickhull, TakesItsFirstTriangleFromTheFront) {
  for (std::vector<Point_3> points = octahedron; std::next_permutation(points.begin(), points.end());) {
    const auto opposite = [](const Point_3& p, const Point_3& q) { return p - CGAL::ORIGIN == CGAL::ORIGIN - q; };
    if (opposite(points[0], points[1]) || opposite(points[0], points[2]) || opposite(points[1], points[2])) continue;
    ASSERT_EQ(hull_of(points, true).made.front(), (Made{points[2], points[1], points[0]}));
  }
}

// The planes that are made second to fifth are those of the first tetrahedron.
TEST(Quickhull, TakesTheFourthCornerFromTheNegativeSideIfAnyPointLiesThere) {
  const auto fourth = [](const std::vector<Point_3>& points) {
    const Hull hull = hull_of(points, true);
    EXPECT_GE(hull.made.size(), 5U);
    for (std::size_t i = 1; i < 5; ++i) {
      for (const Point_3& p : hull.made[i]) {
        if (std::find(points.begin(), points.begin() + 3, p) == points.begin() + 3) return p;
      }
    }
    ADD_FAILURE() << "the first tetrahedron has no fourth corner";
    return points[0];
  };
  const auto side = [](const std::vector<Point_3>& p, const Point_3& s) {
    return CGAL::orientation(p[0], p[1], p[2], s);
  };
  // All others on the negative side, all on the positive one, and on both.
  std::vector<Point_3> points = octahedron;
  ASSERT_EQ(side(points, points[3]), CGAL::NEGATIVE);
  EXPECT_EQ(side(points, fourth(points)), CGAL::NEGATIVE);
  std::swap(points[0], points[1]);
  ASSERT_EQ(side(points, points[3]), CGAL::POSITIVE);
  EXPECT_EQ(side(points, fourth(points)), CGAL::POSITIVE);
  for (const double near : {-1, 1}) {  // which side is the farther one does not matter
    const std::vector<Point_3> both{{4, 4, near}, {-4, 4, near}, {0, -4, near}, {0, 0, 9},
                                    {1, 0, 9},    {0, 1, -9},    {1, 1, -9},    {0, 0, -8}};
    EXPECT_EQ(side(both, fourth(both)), CGAL::NEGATIVE) << near;
  }
}

/// A prism with the origin inside whose two bases have k corners each, on a parabola, and all its
/// points in no particular order.
std::vector<Point_3> prism(int k) {
  std::vector<Point_3> points;
  for (int i = 0; i < k; ++i) {
    const int x = 2 * (i * 37 % k) - k;
    for (const double z : {-1, 1}) points.emplace_back(x, x * x - k, z);
  }
  return points;
}

// Which facets a point sees is asked of the traits class alone: points on a plane that count as
// inside are no trouble, and a facet with k corners costs O(k) planes. As they usually count it
// costs O(k^2).
TEST(Quickhull, BuildsFacetsOfManyCornersInLinearTimeIfPointsOnThemCountAsInside) {
  for (const int k : {37 * 2 + 1, 37 * 4 + 1, 37 * 8 + 1}) {
    const Hull inward = hull_of(prism(k), true);
    EXPECT_EQ(inward.corners.size(), 2U * static_cast<unsigned>(k));
    EXPECT_EQ(inward.triangles.size(), 4U * static_cast<unsigned>(k) - 4);
    EXPECT_LE(inward.made.size(), 20U * static_cast<unsigned>(k));
    const Hull usual = hull_of(prism(k), false);
    std::printf("k = %d: %zu planes, %zu as points usually count\n", k, inward.made.size(), usual.made.size());
    EXPECT_GT(usual.made.size(), static_cast<unsigned>(k * k / 4));
  }
}

TEST(Quickhull, FourPointsComeBackInsideOutAndMoreComeBackRight) {
  const auto outward = [](const Hull& hull) {
    std::size_t out = 0;
    for (const auto& [p, q, r] : hull.triangles) {
      out += CGAL::orientation(hull.corners[p], hull.corners[q], hull.corners[r], Point_3(0, 0, 0)) == CGAL::NEGATIVE;
    }
    return out;
  };
  const std::vector<Point_3> four{{3, 3, 3}, {-3, -3, 3}, {-3, 3, -3}, {3, -3, -3}};
  for (std::vector<Point_3> points = four; std::next_permutation(points.begin(), points.end());) {
    const Hull hull = hull_of(points, true);
    EXPECT_EQ(hull.triangles.size(), 4U);
    EXPECT_EQ(outward(hull), 0U);
  }
  std::vector<Point_3> five = four;
  five.emplace_back(0, 0, 5);
  for (const std::vector<Point_3>& points : {five, octahedron}) {
    const Hull hull = hull_of(points, true);
    EXPECT_EQ(outward(hull), hull.triangles.size());
    EXPECT_EQ(hull.triangles.size(), 2 * hull.corners.size() - 4);
  }
}

}  // namespace
}  // namespace fathom::polytope
