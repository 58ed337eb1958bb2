// SPDX-License-Identifier: GPL-3.0-or-later
// Windows: everything fits, true to scale, whatever the numbers are; and what lies far outside is
// cut exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

const PixelSize size{400, 300};

mpq_class ten_to(int exponent) {
  const mpz_class power("1" + std::string(static_cast<std::size_t>(std::abs(exponent)), '0'));
  return exponent < 0 ? mpq_class(mpz_class(1), power) : mpq_class(power);
}

Bounds2 box(const mpq_class& width, const mpq_class& height) { return {{0, 0}, {width, height}}; }
const View& front() {
  static const View view(Point{1, 0, 0}, Point{0, 1, 0});  // x to the right, y up
  return view;
}

TEST(Window, FitsWithAMargin) {
  const Window window = Window::around(front(), box(4, 1), size);
  EXPECT_FALSE(window.apart());
  const Dot low = window.dot({0, 0, 7}), high = window.dot({4, 1, -7});
  EXPECT_NEAR(low.x, 22, 1e-9);
  EXPECT_NEAR(high.x, 378, 1e-9);
  EXPECT_NEAR(low.y - high.y, 356 / 4.0, 1e-9) << "one scale, and y points down in pixels";
  EXPECT_NEAR((low.y + high.y) / 2, 141, 1e-9) << "above the scale bar";
}

TEST(Window, ScalesTheAxesApartBeyondAHundred) {
  EXPECT_FALSE(Window::around(front(), box(100, 1), size).apart());
  const Window wide = Window::around(front(), box(101, 1), size),
               high = Window::around(front(), box(ten_to(-300), ten_to(300)), size);
  for (const Window* window : {&wide, &high}) EXPECT_TRUE(window->apart());
  EXPECT_NEAR(wide.dot({101, 1, 0}).y, 22, 1e-9);
  EXPECT_NEAR(high.dot({ten_to(-300), ten_to(300), 0}).x, 378, 1e-9);
  EXPECT_NEAR(high.dot({ten_to(-300), ten_to(300), 0}).y, 22, 1e-9);
}

TEST(Window, FlatBoxes) {
  for (const Bounds2& flat : {box(0, 0), box(0, ten_to(-300)), box(ten_to(300), 0)}) {
    const Window window = Window::around(front(), flat, size);
    EXPECT_FALSE(window.apart());
    const Dot middle = window.dot({mpq_class(flat.high.x / 2), mpq_class(flat.high.y / 2), 0});
    EXPECT_NEAR(middle.x, 200, 1e-9);
    EXPECT_NEAR(middle.y, 141, 1e-9);
  }
}

// The edge of a body of 1e300, which rises by a third, through a window of 1e-300: doubles have no
// such places at all.
TEST(Window, CutsExactly) {
  const mpq_class far = ten_to(300);
  const Window window = Window::close(front(), {0, 0}, ten_to(300), size);
  const std::vector<Dot> edge = window.segment({mpq_class(-3 * far), mpq_class(-far), 0}, {mpq_class(3 * far), far, 0});
  ASSERT_EQ(edge.size(), 2u);
  EXPECT_NEAR(edge[0].x, -400, 1e-9) << "a window's width beyond the window";
  EXPECT_NEAR(edge[0].y, 141 + 200, 1e-9);
  EXPECT_NEAR((edge[1].y - edge[0].y) / (edge[1].x - edge[0].x), -1 / 3.0, 1e-12);
  const std::vector<Dot> wedge = window.hull({{0, 0, 0}, {far, far, 0}, {far, mpq_class(-far), 0}});
  ASSERT_GE(wedge.size(), 3u);
  bool apex = false;
  for (const Dot& d : wedge) apex = apex || (std::abs(d.x - 200) < 1e-9 && std::abs(d.y - 141) < 1e-9);
  EXPECT_TRUE(apex);
  EXPECT_TRUE(window.segment({1, 0, 0}, {2, 0, 0}).empty()) << "far outside";
}

TEST(Path, IsShort) {
  EXPECT_EQ(path_data({{1, 2}, {3.04, -0.01}, {10.25, 4.5}}, true), "M1 2L3 0L10.2 4.5Z");
  EXPECT_EQ(path_data({{1, 2}, {1.01, 2.01}, {3, 4}}, false), "M1 2L3 4") << "what is one dot at tenths of pixels";
  EXPECT_EQ(path_data({}, true), "");
}

}  // namespace
}  // namespace fathom::picture
