// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/plot/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "tests/support/matches.hpp"

namespace fathom::plot {
namespace {

Figure figure_of(std::vector<Series> series, Scale scale = Scale::linear) {
  return {"Title", "What is seen.", "p", {{"", {"x", scale}, {"y", scale}, std::move(series)}}};
}

/// The d of the line of a series of the first look.
std::string line_of(const std::string& svg) { return all(svg, "<path class=\"look-0\" d=\"(M[^\"]*)\"").front(); }

TEST(Plot, SeriesDifferByMoreThanColour) {
  std::vector<Series> series;
  for (unsigned i = 0; i < distinct_looks; ++i) series.push_back({"s", {{0, double(i)}, {1, double(i)}}});
  const std::string svg = figure_file(figure_of(series));
  std::set<std::string> dashes, marks;
  for (const std::string& style : all(svg, "<path class=\"(look-[^\"]*)\"")) dashes.insert(style);
  for (const std::string& style : all(svg, "<path class=\"mark (\\w+)[^\"]*\" d=\"M[0-9. -]*[^\"]*"))
    marks.insert(style);
  EXPECT_EQ(dashes.size(), distinct_looks);
  std::set<std::string> shapes;
  for (const std::string& shape : all(svg, "<path class=\"mark (\\w+ look-[0-9]\" d=\"M)")) shapes.insert(shape);
  EXPECT_EQ(shapes.size(), distinct_looks);
  for (unsigned i = 1; i < distinct_looks; ++i) {
    const std::string rule = ".dash-" + std::to_string(i) + "{stroke-dasharray";
    EXPECT_NE(svg.find(rule), std::string::npos) << "law: a dash for each: " << rule;
  }
}

TEST(Plot, LinesBreakWhereAValueHasNoPlace) {
  const double nan = std::nan("");
  std::string svg = figure_file(figure_of({{"s", {{0, 1}, {1, 2}, {2, nan}, {3, 3}, {4, 4}}, true, false}}));
  EXPECT_EQ(all(line_of(svg), "(M)").size(), 2u);
  EXPECT_NE(svg.find("Not drawn: 1 value, "), std::string::npos);
  svg = figure_file(figure_of({{"s", {{1, 1}, {2, 0}, {3, 3}, {4, 0}, {5, 5}}, true, false}}, Scale::logarithmic));
  EXPECT_EQ(all(line_of(svg), "(M)").size(), 3u);
  EXPECT_NE(svg.find("Not drawn: 2 values, 0 or below"), std::string::npos);
}

TEST(Plot, HigherIsUp) {
  const std::string d = line_of(figure_file(figure_of({{"s", {{0, 0}, {1, 10}}, true, false}})));
  const std::vector<std::string> numbers = all(d, "(-?[0-9.]+)");
  ASSERT_EQ(numbers.size(), 4u);
  EXPECT_LT(std::stod(numbers[0]), std::stod(numbers[2])) << "law: greater x is to the right";
  EXPECT_GT(std::stod(numbers[1]), std::stod(numbers[3])) << "law: greater y is above";
}

TEST(Plot, TextsOfOthersAreEscaped) {
  Figure figure = figure_of({{"<b>&", {{0, 0, "\"<i>"}, {1, 1}}}});
  figure.title = figure.description = figure.panels[0].title = figure.panels[0].x.name = figure.panels[0].above =
      "<script>\x1b";
  const std::string svg = figure_file(figure);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_EQ(svg.find("<i>"), std::string::npos);
  EXPECT_EQ(svg.find('\x1b'), std::string::npos);
  EXPECT_NE(svg.find("&lt;b&gt;&amp;"), std::string::npos);
}

TEST(Plot, LongTextsAreCutAndEmptySeriesPassedOver) {
  Figure figure = figure_of({{"empty", {}}, {"s", {{0, 0}, {1, 1}}}});
  figure.title = std::string(80, 'x') + "⁵⁵⁵⁵⁵⁵⁵";
  const std::string svg = figure_file(figure);
  EXPECT_EQ(svg.find("empty"), std::string::npos);
  EXPECT_NE(svg.find("class=\"look-1 dash-1\""), std::string::npos) << "law: the look is that of the place in the list";
  EXPECT_NE(svg.find(std::string(80, 'x') + "⁵⁵⁵⁵...</text>"), std::string::npos);
  EXPECT_NE(svg.find(std::string(80, 'x') + "⁵⁵⁵⁵⁵⁵⁵</title>"), std::string::npos);
}

TEST(Plot, IdsHaveThePrefixAndDiffer) {
  Figure figure = figure_of({{"s", {{0, 0}, {1, 1}}}});
  figure.panels.push_back(figure.panels[0]);
  std::set<std::string> seen;
  for (const std::string& id : all(figure_file(figure), " id=\"([^\"]*)\"")) {
    EXPECT_TRUE(id.starts_with("p-")) << id;
    EXPECT_TRUE(seen.insert(id).second) << id;
  }
  EXPECT_EQ(seen.size(), 4u);  // title, description, two clipping paths
}

TEST(Plot, ManyPlacesHaveFewMarks) {
  Series series{"s", {}};
  for (int i = 0; i < 1000; ++i) series.places.push_back({double(i), double(i)});
  const std::string svg = figure_file(figure_of({series}));
  EXPECT_LE(all(svg, "(class=\"mark)").size(), 70u);
  EXPECT_EQ(all(line_of(svg), "(L)").size(), 999u);
}

TEST(Plot, GrowthIsTheSlopeOfLogarithms) {
  std::vector<Datum> places;
  for (double x = 10; x < 1e5; x *= 3) places.push_back({x, 7 * std::pow(x, 1.5)});
  EXPECT_NEAR(*growth_exponent(places), 1.5, 1e-9);
  places.push_back({20, 0});
  EXPECT_NEAR(*growth_exponent(places), 1.5, 1e-9) << "law: what is 0 has no logarithm";
  for (const std::vector<Datum>& few : {std::vector<Datum>{}, {{10, 3}}, {{10, 3}, {10, 4}}, {{10, 0}, {100, 4}}})
    EXPECT_FALSE(growth_exponent(few));
  EXPECT_NEAR(*growth_exponent(std::vector<Datum>{{10, 3}, {100, 3}}), 0, 1e-12);
}

constexpr double infinite = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
constexpr unsigned most = 8;

const std::vector<std::vector<double>> ranges{{0, 1},
                                              {-0.3, 0.47},
                                              {0, 0},
                                              {5, 5},
                                              {-7, -7},
                                              {1e-12, 1},
                                              {3, 7},
                                              {48, 21000},
                                              {1e6, 1e6 + 1},
                                              {-1e-300, 1},
                                              {12345678, 12345679},
                                              {3e-7, 9e-7},
                                              {15, 700},
                                              {1e-300, 1e300},
                                              {-largest, largest},
                                              {5e-324, 5e-324},
                                              {-1, std::nan("")},
                                              {0.1, 0.3, 0.2}};

/// The figure m of value = m 10^k with 1 <= m < 10, to six digits.
double figure(double value) {
  const double exponent = std::floor(std::log10(std::abs(value)) + 1e-9);
  return std::round(std::abs(value) / std::pow(10, exponent) * 1e5) / 1e5;
}

std::vector<Tick> labelled(const Ticks& ticks) {
  std::vector<Tick> result;
  for (const Tick& tick : ticks.ticks)
    if (!tick.label.empty()) result.push_back(tick);
  return result;
}

void check(const Ticks& ticks, const std::vector<double>& values) {
  EXPECT_LT(ticks.low, ticks.high);
  EXPECT_DOUBLE_EQ(ticks.share(ticks.low), 0);
  EXPECT_DOUBLE_EQ(ticks.share(ticks.high), 1);
  for (const double value : values) {
    if (!ticks.holds(value)) continue;
    EXPECT_GE(ticks.share(value), -1e-9) << value;
    EXPECT_LE(ticks.share(value), 1 + 1e-9) << value;
  }
  std::set<std::string> labels;
  double before = -infinite;
  for (const Tick& tick : ticks.ticks) {
    EXPECT_GT(tick.value, before) << "law: ascending";
    before = tick.value;
    EXPECT_GE(ticks.share(tick.value), -1e-9) << "law: between the ends: " << tick.value;
    EXPECT_LE(ticks.share(tick.value), 1 + 1e-9) << "law: between the ends: " << tick.value;
    EXPECT_TRUE(tick.label.empty() || labels.insert(tick.label).second) << "law: labels differ: " << tick.label;
  }
}

TEST(Ticks, LinearAxesHaveEqualRoundSteps) {
  for (const std::vector<double>& values : ranges)
    for (const bool tight : {false, true}) {
      const Ticks ticks = ticks_for(Scale::linear, values, most, tight);
      check(ticks, values);
      const std::vector<Tick> found = labelled(ticks);
      ASSERT_GE(found.size(), 3u) << values.front() << ' ' << values.back();
      EXPECT_LE(found.size(), most + 3u);
      const double step = found[1].value / 2 - found[0].value / 2;
      EXPECT_TRUE(std::set<double>({1, 2, 5}).contains(figure(step * 2))) << "law: 1, 2 or 5: " << step * 2;
      for (std::size_t i = 2; i < found.size(); ++i)
        EXPECT_NEAR((found[i].value / 2 - found[i - 1].value / 2) / step, 1, 1e-6) << "law: equal steps";
    }
}

TEST(Ticks, LinearEndsAreRoundUnlessTight) {
  const Ticks loose = ticks_for(Scale::linear, std::vector{-0.3, 0.47}, most),
              tight = ticks_for(Scale::linear, std::vector{-0.3, 0.47}, most, true);
  EXPECT_EQ(loose.ticks.front().label, "-0.3");
  EXPECT_EQ(loose.ticks.back().label, "0.5");
  EXPECT_EQ(tight.low, -0.3);
  EXPECT_EQ(tight.high, 0.47);
}

TEST(Ticks, LogarithmicAxesLabelPowersOfTen) {
  for (const std::vector<double>& values : ranges) {
    const Ticks ticks = ticks_for(Scale::logarithmic, values, most);
    check(ticks, values);
    EXPECT_GT(ticks.low, 0);
    const std::vector<Tick> found = labelled(ticks);
    ASSERT_GE(found.size(), 2u) << values.front() << ' ' << values.back();
    EXPECT_LE(found.size(), most + 2u);
    for (const Tick& tick : found) EXPECT_TRUE(std::set<double>({1, 2, 5}).contains(figure(tick.value))) << tick.value;
  }
}

TEST(Ticks, ALogarithmicAxisHasNoPlaceForZero) {
  const Ticks ticks = ticks_for(Scale::logarithmic, std::vector{0.0, -3.0, 10.0, 1000.0}, most);
  EXPECT_EQ(ticks.low, 10);
  EXPECT_EQ(ticks.high, 1000);
  EXPECT_FALSE(ticks.holds(0));
  EXPECT_FALSE(ticks.holds(-3));
  EXPECT_FALSE(ticks.holds(infinite));
  EXPECT_DOUBLE_EQ(ticks.share(100), 0.5);
}

TEST(Ticks, NumbersAreShort) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(0.25), "0.25");
  EXPECT_EQ(number_text(-1234.5), "-1,234.5");
  EXPECT_EQ(number_text(20000), "20,000");
  EXPECT_EQ(number_text(2.5e7), "2.5·10⁷");
  EXPECT_EQ(number_text(1e-12), "10⁻¹²");
}

}  // namespace
}  // namespace fathom::plot
