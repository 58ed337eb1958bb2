// SPDX-License-Identifier: GPL-3.0-or-later
// What is lit are the arcs of the canonical pair, which cross each other in its strip; what is left
// out is said.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fathom/numbers.hpp"
#include "tests/support/matches.hpp"
#include "verify/families/families.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {
namespace {

struct Dot {
  double x, y;
};
using Line = std::vector<Dot>;

Line line_of(const std::string& d) {
  Line line;
  const std::vector<std::string> numbers = all(d, "(-?[0-9.]+)");
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    line.push_back({std::stod(numbers[i]), std::stod(numbers[i + 1])});
  return line;
}

std::vector<Line> lit(const std::string& svg, const std::string& body) {
  std::vector<Line> lines;
  for (const std::string& d : all(svg, "<path class=\"arc " + body + " lit\" d=\"(M[^\"H]*)\""))
    lines.push_back(line_of(d));
  return lines;
}

double turn(const Dot& p, const Dot& q, const Dot& r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

/// Whether two lines of pixels cross, or come as near as rounding to a tenth of a pixel may take
/// them.
bool cross(const Line& s, const Line& t) {
  for (std::size_t i = 1; i < s.size(); ++i)
    for (std::size_t j = 1; j < t.size(); ++j) {
      const double a = turn(s[i - 1], s[i], t[j - 1]), b = turn(s[i - 1], s[i], t[j]),
                   c = turn(t[j - 1], t[j], s[i - 1]), d = turn(t[j - 1], t[j], s[i]);
      if (a * b <= 0 && c * d <= 0) return true;
    }
  double nearest = 1e9;
  for (const Dot& p : s)
    for (const Dot& q : t) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
  return nearest < 3;
}

Stages staged(std::string_view family, unsigned size, std::uint64_t seed = 1) {
  const Case pair = families::find_family(family)->make(seed, size);
  return stages::stages_of(pair.a, pair.b);
}

TEST(ChartsPicture, LightsTheArcsOfThePair) {
  for (const char* family : {"crossed_fans", "random_sphere", "boxes_posed", "platonic_posed"}) {
    const Stages stages = staged(family, 12);
    ASSERT_FALSE(stages.pairs.empty()) << family;
    for (Index i = 0; i < stages.pairs.size(); ++i) {
      const std::string svg = chart_panel(stages, stages.pairs[i].chart, i).content;
      const std::vector<Line> a = lit(svg, "of-a"), b = lit(svg, "of-b");
      EXPECT_EQ(a.size(), stages.pairs[i].a.size()) << family << ' ' << i;
      EXPECT_EQ(b.size(), stages.pairs[i].b.size()) << family << ' ' << i;
      for (const Line& s : a)
        for (const Line& t : b)
          EXPECT_TRUE(cross(s, t)) << family << ' ' << i << ", law: each of A_i crosses each of B_i";
    }
  }
}

TEST(ChartsPicture, TheStripHoldsTheCrossings) {
  const Stages stages = staged("crossed_fans", 18);
  ASSERT_TRUE(stages.winner && stages.winner->pair);
  const Index chart = stages.pairs[*stages.winner->pair].chart;
  const std::string svg = chart_panel(stages, chart, pair_to_light(stages, chart)).content;
  const std::vector<std::string> strip =
      all(svg, "<rect class=\"strip\" (x=\"[0-9.]+\" y=\"[0-9.]+\" width=\"[0-9.]+\")");
  ASSERT_FALSE(strip.empty());
  const std::vector<std::string> numbers = all(strip.front(), "\"([0-9.]+)\""),
                                 optimum = all(svg, "<circle class=\"optimum\" cx=\"([0-9.]+)\"");
  ASSERT_FALSE(optimum.empty());
  EXPECT_GE(std::stod(optimum.front()), std::stod(numbers[0]) - 0.2) << "law: the optimum is one of the crossings";
  EXPECT_LE(std::stod(optimum.front()), std::stod(numbers[0]) + std::stod(numbers[2]) + 0.2);
}

TEST(ChartsPicture, EveryCaseHasItsPicture) {
  for (const families::CatalogueEntry& entry : families::catalogue()) {
    const Stages stages = stages::stages_of(entry.pair.a, entry.pair.b);
    if (stages.charts.empty()) continue;
    const std::string svg = charts_file(stages);
    EXPECT_EQ(svg.find("nan"), std::string::npos) << entry.name;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << entry.name;
    for (const std::string& d : all(svg, " d=\"(M[^\"]*)\""))
      for (const Dot& dot : d.find('H') == d.npos && d.find('V') == d.npos ? line_of(d) : Line{}) {
        EXPECT_GE(dot.x, 0) << entry.name;
        EXPECT_LE(dot.x, 492) << entry.name;
        EXPECT_GE(dot.y, 0) << entry.name;
        EXPECT_LE(dot.y, 500) << entry.name;
      }
  }
}

TEST(ChartsPicture, SaysWhatIsLeftOut) {
  const std::string small = charts_file(staged("random_sphere", 30)),
                    large = charts_file(staged("random_sphere", 1500));
  EXPECT_EQ(small.find("not drawn"), std::string::npos);
  EXPECT_NE(large.find("walls: they are not drawn"), std::string::npos);
  EXPECT_EQ(all(large, "class=\"(wall)\"").size(), 1u) << "only the legend's";
}

TEST(ChartsPicture, ShapesHaveNoCharts) {
  const Case pair = families::find_family("random_sphere")->make(1, 10);
  const Stages stages = stages::stages_of({{}, cylinder(1, 1)}, pair.b);
  EXPECT_THROW(charts_file(stages), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::stages
