// SPDX-License-Identifier: GPL-3.0-or-later
// The projection of pictures: lengths in its plane, close-ups of tiny things far away, and a look
// at which something can be seen.
#include "view/picture/view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/property.hpp"

namespace fathom::picture {
namespace {

double length(const Dot& d) { return std::hypot(d.x, d.y); }

TEST(View, BothTranslationsKeepTheirLength) {
  EXPECT_TRUE(holds({.seed = 74, .runs = 1000}, [] {
    const auto coordinate = rc::gen::inRange(-50, 51);
    const Point along{*coordinate, *coordinate, *coordinate}, second{*coordinate, *coordinate, *coordinate},
        at{*coordinate, 1, -7};
    RC_PRE(along != Point{} && second != Point{});
    const View view(along, second);
    const auto end = [&](const Point& by) {
      return view.project({mpq_class(at.x + by.x), mpq_class(at.y + by.y), mpq_class(at.z + by.z)}, at, 1);
    };
    const auto size = [](const Point& p) { return std::sqrt(mpq_class(p.x * p.x + p.y * p.y + p.z * p.z).get_d()); };
    RC_ASSERT(std::abs(end(along).x - size(along)) < 1e-9 && std::abs(end(along).y) < 1e-9);
    RC_ASSERT(std::abs(length(end(second)) - size(second)) < 1e-4 * size(second));
  }));
}

// Doubles would lose the gap of 1e-40 between bodies at 1e20.
TEST(View, CloseUpsAreExact) {
  const mpq_class far("100000000000000000000"), tiny("1/10000000000000000000000000000000000000000");
  const Point n{3, -5, 7}, a{far, far, far};
  const Point b{mpq_class(a.x + 3 * tiny), mpq_class(a.y - 5 * tiny), mpq_class(a.z + 7 * tiny)};
  const Point beside{mpq_class(a.x + 5 * far), mpq_class(a.y + 3 * far), a.z};  // across n from a
  const View view(n, std::nullopt);
  EXPECT_NEAR(view.project(b, a, tiny).x, std::sqrt(83.0), 1e-12);
  EXPECT_EQ(view.project(a, a, tiny).x, 0);
  EXPECT_EQ(view.project(beside, a, tiny).x, 0) << "points of one plane across the view's axis";
}

TEST(View, SeesOneSideOfAFacet) {
  const View view(Point{1, 0, 0}, Point{1, 1, 0});  // from +z, or from -z
  EXPECT_NE(view.faces_us({0, 0, 1}), view.faces_us({0, 0, -1}));
}

// A box that moves along an axis shows two of its sides, and none of its edges across the way hides
// another.
TEST(View, LooksFromALittleAbove) {
  for (const Point& along : {Point{1, 0, 0}, Point{0, -3, 0}, Point{0, 0, 2}}) {
    const View view(along, std::nullopt);
    std::vector<double> heights;
    for (const int x : {-1, 1})
      for (const int y : {-1, 1})
        for (const int z : {-1, 1}) {
          const Point corner{x, y, z};
          if (dot(corner, along) > 0) heights.push_back(view.project(corner, Point{}, 1).y);
        }
    std::ranges::sort(heights);
    for (std::size_t i = 1; i < heights.size(); ++i)
      EXPECT_GT(heights[i] - heights[i - 1], 0.3) << along.x << along.y << along.z;
  }
  EXPECT_TRUE(View(Point{1, 0, 0}, std::nullopt).faces_us({0, 0, 1})) << "from above";
}

TEST(View, ShowsTheEdgesInContact) {
  EXPECT_TRUE(holds({.seed = 74, .runs = 1000}, [] {
    const auto coordinate = rc::gen::inRange(-50, 51);
    const Point along{*coordinate, *coordinate, *coordinate};
    std::vector<Point> edges;
    for (int i = 0; i < 2; ++i) {  // across the way
      const Point v{*coordinate, *coordinate, *coordinate};
      edges.push_back({mpq_class(along.y * v.z - along.z * v.y), mpq_class(along.z * v.x - along.x * v.z),
                       mpq_class(along.x * v.y - along.y * v.x)});
    }
    RC_PRE(along != Point{} && edges[0] != Point{} && edges[1] != Point{});
    const View view(along, std::nullopt, edges);
    for (const Point& edge : edges) {
      const double whole = std::sqrt(dot(edge, edge).get_d());
      RC_ASSERT(length(view.project(edge, Point{}, 1)) > 0.25 * whole);
    }
  }));
}

TEST(View, UnitVectors) {
  const auto huge = unit_vector(
      Point{mpq_class(mpz_class("3" + std::string(400, '0'))), 0, mpq_class(mpz_class("-4" + std::string(400, '0')))});
  EXPECT_DOUBLE_EQ(huge.x, 0.6);
  EXPECT_DOUBLE_EQ(huge.z, -0.8);
  EXPECT_EQ(unit_vector(Point{}), (Vec3<double>{0, 0, 0}));
}

}  // namespace
}  // namespace fathom::picture
