// SPDX-License-Identifier: GPL-3.0-or-later
// The projection of pictures: lengths in its plane, close-ups of tiny things far away, clipping, outlines.
#include "view/picture/view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>

namespace fathom::picture {
namespace {

[[maybe_unused]] const int configured = setenv("RC_PARAMS", "seed=74 max_success=1000", 0);

double length(const Dot& d) { return std::hypot(d.x, d.y); }

TEST(View, BothTranslationsKeepTheirLength) {
  EXPECT_TRUE(rc::check("true lengths", [] {
    const auto coordinate = rc::gen::inRange(-50, 51);
    const Point along{*coordinate, *coordinate, *coordinate}, second{*coordinate, *coordinate, *coordinate}, at{*coordinate, 1, -7};
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

TEST(View, UnitVectors) {
  const auto huge =
      unit_vector(Point{mpq_class(mpz_class("3" + std::string(400, '0'))), 0, mpq_class(mpz_class("-4" + std::string(400, '0')))});
  EXPECT_DOUBLE_EQ(huge.x, 0.6);
  EXPECT_DOUBLE_EQ(huge.z, -0.8);
  EXPECT_EQ(unit_vector(Point{}), (Vec3<double>{0, 0, 0}));
}

TEST(Clipped, Segments) {
  const auto cut = [](Dot from, Dot to) { return clipped({from, to}, false, {0, 0}, {1, 2}); };
  auto part = cut({-3, 0}, {3, 0});
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(std::pair(part[0].x, part[1].x), std::pair(-1.0, 1.0));
  part = cut({0, 0}, {0, 8});
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(part[1].y, 2);
  EXPECT_TRUE(cut({-3, 0}, {0, 9}).empty()) << "past the corner";
  EXPECT_TRUE(cut({0, 0}, {std::nan(""), 0}).empty());
  EXPECT_TRUE(cut({0, 0}, {INFINITY, 0}).empty());
}

TEST(Clipped, PolygonsStayInTheBox) {
  EXPECT_TRUE(rc::check("inside", [] {
    const auto coordinate = rc::gen::inRange(-30, 31);
    std::vector<Dot> dots;
    for (int i = 0; i < 8; ++i) dots.push_back({*coordinate / 10.0, *coordinate / 10.0});
    for (const Dot& d : clipped(outline(dots), true, {0, 0}, {1, 1})) RC_ASSERT(std::abs(d.x) < 1 + 1e-12 && std::abs(d.y) < 1 + 1e-12);
  }));
  EXPECT_EQ(clipped({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, true, {0, 0}, {1, 1}).size(), 4u);
}

TEST(Outline, HasTheCornersOfTheHullOnly) {
  EXPECT_EQ(outline({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {2, 2}, {0, 2}, {0, 0}, {1, 2}}).size(), 4u);
  EXPECT_EQ(outline({{0, 0}, {1, 1}, {2, 2}}).size(), 2u) << "a segment";
  EXPECT_EQ(outline({{3, 4}}).size(), 1u);
}

}  // namespace
}  // namespace fathom::picture
