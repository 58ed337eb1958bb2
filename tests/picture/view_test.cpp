// SPDX-License-Identifier: GPL-3.0-or-later
// The projection of pictures: lengths in its plane, close-ups of tiny things far away, and a look
// at which something can be seen.

#include "view/picture/view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fathom/numbers.hpp"
#include "tests/harness/report/outcomes.hpp"
#include "tests/harness/report/well_formed.hpp"
#include "tests/picture/picture_size.hpp"
#include "tests/support/property.hpp"
#include "view/picture/markup.hpp"

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

// Windows: everything fits, true to scale, whatever the numbers are; and what lies far outside is
// cut exactly.

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

// Round lengths: the greatest that fits, and a number that says exactly that length.

mpq_class read(const std::string& text) { return parse_number(text, Decimals::exact).value.value(); }

TEST(RoundLength, OfEachDigit) {
  const auto text = [](const char* most) { return round_length(read(most)).text; };
  EXPECT_EQ(text("1"), "1");
  EXPECT_EQ(text("1.999999999"), "1");
  EXPECT_EQ(text("2"), "2");
  EXPECT_EQ(text("4.99"), "2");
  EXPECT_EQ(text("5"), "5");
  EXPECT_EQ(text("9.99"), "5");
  EXPECT_EQ(text("10"), "10");
  EXPECT_EQ(text("99999"), "50000");
  EXPECT_EQ(text("100000"), "1e5");
  EXPECT_EQ(text("0.000123"), "0.0001");
  EXPECT_EQ(text("0.07"), "0.05");
  EXPECT_EQ(text("0.00009"), "5e-5");
  EXPECT_EQ(text("3e300"), "2e300");
  EXPECT_EQ(text("7e-300"), "5e-300");
}

TEST(RoundLength, IsTheGreatestAndSaysSo) {
  EXPECT_TRUE(holds({.seed = 76, .runs = 1000}, [] {
    mpq_class most(*rc::gen::inRange(1, 1'000'000), *rc::gen::inRange(1, 1'000'000));
    most.canonicalize();
    const mpq_class power = read("1e" + std::to_string(*rc::gen::inRange(-310, 310)));
    most *= power;
    const RoundLength length = round_length(most);
    RC_ASSERT(length.value <= most && most < length.value * mpq_class(5, 2));
    RC_ASSERT(read(length.text) == length.value);
    RC_ASSERT(length.text.size() <= 6U);
  }));
}

// Foreign text in documents: any bytes become something well-formed, good text stays as it is, and
// different ids stay different.

using harness::testing::read_xml;

std::string there_and_back(const std::string& text) {
  const harness::testing::Element element = read_xml("<e a=\"" + markup(text) + "\">" + markup(text) + "</e>");
  EXPECT_EQ(element.text, element["a"]);
  return element.text;
}

TEST(Markup, GoodTextComesBack) {
  for (const std::string text : {"", "plain", "<a href=\"x\">&amp;'</a>", "]]>", "a\tb\nc\r",
                                 "\xc3\xa9 \xe2\x88\x9a \xf0\x9f\x98\x80", "\xed\x9f\xbf\xee\x80\x80"})
    EXPECT_EQ(there_and_back(text), text);
}

TEST(Markup, WhatNoDocumentMayHoldIsShown) {
  EXPECT_EQ(there_and_back(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(there_and_back("\x1b[31m\x7f"), "\\x1b[31m\\x7f");
  EXPECT_EQ(there_and_back("\xff\x80"), "\\xff\\x80");
  EXPECT_EQ(there_and_back("\xc0\xaf"), "\\xc0\\xaf") << "overlong";
  EXPECT_EQ(there_and_back("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(there_and_back("\xef\xbf\xbe"), "\\xef\\xbf\\xbe") << "U+FFFE";
  EXPECT_EQ(there_and_back("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond U+10FFFF";
  EXPECT_EQ(there_and_back("\xe2\x88"), "\\xe2\\x88") << "cut short";
}

TEST(Markup, AnyBytes) {
  EXPECT_FALSE(there_and_back(harness::testing::hostile()).empty());
  EXPECT_TRUE(holds({.seed = 71, .runs = 1000},
                    [](const std::string& text) { RC_ASSERT(there_and_back(text).size() >= text.size()); }));
  EXPECT_TRUE(holds({.seed = 71, .runs = 1000}, [] {
    const auto bytes = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0x7e, 0x100));
    std::string text;
    for (const int byte : bytes) text += static_cast<char>(byte);
    RC_ASSERT(there_and_back(text).size() >= text.size());
  }));
}

TEST(WithoutFolders, CutsAbsolutePathsAndNothingElse) {
  EXPECT_EQ(without_folders("/home/me/a.off /srv/b.off"), "a.off b.off");
  EXPECT_EQ(without_folders("fathom certify --subject './run --in=/home/me/x.json' \"/tmp/c.jsonl\""),
            "fathom certify --subject './run --in=x.json' \"c.jsonl\"");
  EXPECT_EQ(without_folders("/home/me/cases.jsonl:3: expected a case"), "cases.jsonl:3: expected a case");
  EXPECT_EQ(without_folders("into /home/me/folder/, then"), "into folder, then");
  for (const char* text : {"", "/", "a / b", "1/2", "tests/data/cube.off", "and/or", "</script>", "box:half=1,1/2,1"})
    EXPECT_EQ(without_folders(text), text);
}

TEST(Ascii, IsCutAndPrintable) {
  EXPECT_EQ(ascii("plain", 5), "plain");
  EXPECT_EQ(ascii("plainer", 5), "pl...");
  EXPECT_EQ(ascii("a\nb\xff"), "a\\x0ab\\xff");
  EXPECT_TRUE(holds({.seed = 71, .runs = 1000}, [](const std::string& text) {
    const std::string shown = ascii(text, 10);
    RC_ASSERT(shown.size() <= 10U);
    for (const char c : shown) RC_ASSERT(c >= 0x20 && c < 0x7f);
  }));
}

}  // namespace
}  // namespace fathom::picture
