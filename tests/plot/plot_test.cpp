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

}  // namespace
}  // namespace fathom::plot
