// SPDX-License-Identifier: GPL-3.0-or-later
// Paths and polygons: cut at a box, around dots; and exactly, where doubles would lose what lies in
// the box.
#include "view/picture/polygon.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "tests/support/property.hpp"

namespace fathom::picture {
namespace {

TEST(Clipped, Segments) {
  const auto cut = [](Dot from, Dot to) { return clipped(std::vector<Dot>{from, to}, false, {-1, -2}, {1, 2}); };
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
  EXPECT_TRUE(holds({.seed = 75, .runs = 1000}, [] {
    const auto coordinate = rc::gen::inRange(-30, 31);
    std::vector<Dot> dots;
    for (int i = 0; i < 8; ++i) dots.push_back({*coordinate / 10.0, *coordinate / 10.0});
    for (const Dot& d : clipped(outline(dots), true, {-1, -1}, {1, 1}))
      RC_ASSERT(std::abs(d.x) < 1 + 1e-12 && std::abs(d.y) < 1 + 1e-12);
  }));
  EXPECT_EQ(clipped(std::vector<Dot>{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, true, {-1, -1}, {1, 1}).size(), 4u);
}

TEST(Outline, HasTheCornersOfTheHullOnly) {
  EXPECT_EQ(outline(std::vector<Dot>{{0, 0}, {2, 0}, {1, 0}, {1, 1}, {2, 2}, {0, 2}, {0, 0}, {1, 2}}).size(), 4u);
  EXPECT_EQ(outline(std::vector<Dot>{{0, 0}, {1, 1}, {2, 2}}).size(), 2u) << "a segment";
  EXPECT_EQ(outline(std::vector<Dot>{{3, 4}}).size(), 1u);
}

// Through the box at a third of its height, between ends that doubles cannot tell from whole ones.
TEST(Clipped, OfPlacesIsExact) {
  const mpq_class far("1" + std::string(600, '0')), third(1, 3);
  const Spot low{-1, -1}, high{1, 1};
  const std::vector<Spot> part = clipped(std::vector<Spot>{{mpq_class(-far), third}, {far, third}}, false, low, high);
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(part[0].x, -1);
  EXPECT_EQ(part[0].y, third);
  const std::vector<Spot> wedge{{0, 0}, {far, far}, {far, mpq_class(-far)}, {far, 0}};
  const std::vector<Spot> seen = clipped(outline(wedge), true, low, high);
  ASSERT_EQ(seen.size(), 3u) << "the apex, and two corners of the box";
}

}  // namespace
}  // namespace fathom::picture
