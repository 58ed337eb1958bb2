// SPDX-License-Identifier: GPL-3.0-or-later
// What is lit are the arcs of the canonical pair, which cross each other in its strip; ids differ; what is left out is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fathom/numbers.hpp"
#include "tests/support/matches.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"
#include "view/atlas/limits.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::atlas {
namespace {

using stages::Index;
using stages::Stages;

struct Dot {
  double x, y;
};
using Line = std::vector<Dot>;

Line line_of(const std::string& d) {
  Line line;
  const std::vector<std::string> numbers = all(d, "(-?[0-9.]+)");
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) line.push_back({std::stod(numbers[i]), std::stod(numbers[i + 1])});
  return line;
}

std::vector<Line> lit(const std::string& svg, const std::string& body) {
  std::vector<Line> lines;
  for (const std::string& d : all(svg, "<path class=\"arc " + body + " lit\" d=\"(M[^\"H]*)\"")) lines.push_back(line_of(d));
  return lines;
}

double turn(const Dot& p, const Dot& q, const Dot& r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

/// Whether two lines of pixels cross, or come as near as rounding to a tenth of a pixel may take them.
bool cross(const Line& s, const Line& t) {
  for (std::size_t i = 1; i < s.size(); ++i)
    for (std::size_t j = 1; j < t.size(); ++j) {
      const double a = turn(s[i - 1], s[i], t[j - 1]), b = turn(s[i - 1], s[i], t[j]), c = turn(t[j - 1], t[j], s[i - 1]),
                   d = turn(t[j - 1], t[j], s[i]);
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

TEST(Atlas, LightsTheArcsOfThePair) {
  for (const char* family : {"crossed_fans", "random_sphere", "boxes_posed", "platonic_posed"}) {
    const Stages stages = staged(family, 12);
    ASSERT_FALSE(stages.pairs.empty()) << family;
    for (Index i = 0; i < stages.pairs.size(); ++i) {
      const std::string svg = chart_picture(stages, "p", {.pair = i});
      const std::vector<Line> a = lit(svg, "of-a"), b = lit(svg, "of-b");
      EXPECT_EQ(a.size(), stages.pairs[i].a.size()) << family << ' ' << i;
      EXPECT_EQ(b.size(), stages.pairs[i].b.size()) << family << ' ' << i;
      for (const Line& s : a)
        for (const Line& t : b) EXPECT_TRUE(cross(s, t)) << family << ' ' << i << ", law: each of A_i crosses each of B_i";
      const std::string sphere = sphere_picture(stages, "p", {.pair = i});
      EXPECT_EQ(all(sphere, "<path class=\"arc of-. (lit)[^\"]*\" d=\"M[^\"H]*\"").size(),
                stages.pairs[i].a.size() + stages.pairs[i].b.size());
    }
  }
}

TEST(Atlas, TheStripHoldsTheCrossings) {
  const Stages stages = staged("crossed_fans", 18);
  ASSERT_TRUE(stages.winner && stages.winner->pair);
  const std::string svg = chart_picture(stages, "p");
  const std::vector<std::string> strip = all(svg, "<rect class=\"strip\" (x=\"[0-9.]+\" y=\"[0-9.]+\" width=\"[0-9.]+\")");
  ASSERT_FALSE(strip.empty());
  const std::vector<std::string> numbers = all(strip.front(), "\"([0-9.]+)\""),
                                 optimum = all(svg, "<circle class=\"optimum\" cx=\"([0-9.]+)\"");
  ASSERT_FALSE(optimum.empty());
  EXPECT_GE(std::stod(optimum.front()), std::stod(numbers[0]) - 0.2) << "law: the optimum is one of the crossings";
  EXPECT_LE(std::stod(optimum.front()), std::stod(numbers[0]) + std::stod(numbers[2]) + 0.2);
}

TEST(Atlas, EveryCaseHasItsPictures) {
  for (const families::CatalogueEntry& entry : families::catalogue()) {
    const Stages stages = stages::stages_of(entry.pair.a, entry.pair.b);
    if (stages.charts.empty()) continue;
    for (const std::string& svg : {charts_file(stages), chart_picture(stages, "c"), sphere_picture(stages, "s")}) {
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
}

TEST(Atlas, IdsHaveThePrefixAndDiffer) {
  const Stages stages = staged("crossed_fans", 8);
  std::set<std::string> seen;
  for (const std::string& svg : {chart_picture(stages, "one"), chart_picture(stages, "two"), sphere_picture(stages, "three")})
    for (const std::string& id : all(svg, " id=\"([^\"]*)\"")) EXPECT_TRUE(seen.insert(id).second) << id;
  EXPECT_EQ(seen, (std::set<std::string>{"one-t", "one-d", "two-t", "two-d", "three-t", "three-d"}));
}

TEST(Atlas, SaysWhatIsLeftOut) {
  const std::string small = charts_file(staged("random_sphere", 30)), large = charts_file(staged("random_sphere", 1500));
  EXPECT_EQ(small.find("not drawn"), std::string::npos);
  EXPECT_NE(large.find("walls: they are not drawn"), std::string::npos);
  EXPECT_EQ(all(large, "class=\"(wall)\"").size(), 1u) << "only the legend's";
}

TEST(Atlas, PHasItsBallAndItsNearestFacets) {
  const Stages stages = staged("exact_ties", 12);
  const auto ties = std::ranges::count(stages.sum.facets, true, &stages::StagedFacet::optimal);
  ASSERT_GT(ties, 1);
  const SumPicture picture = sum_picture(stages, "s");
  const std::size_t panels = all(picture.svg, "(<svg)").size();
  EXPECT_EQ(all(picture.svg, "class=\"(ball)\"").size(), panels);
  EXPECT_EQ(all(picture.svg, "class=\"(near)\"").size(), panels * static_cast<std::size_t>(ties)) << "law: each nearest facet is marked";
  EXPECT_NE(picture.note.find("touches " + std::to_string(ties) + " facets"), std::string::npos);
  EXPECT_EQ(picture.note.find("drawn"), std::string::npos);
}

TEST(Atlas, OfLargePThereIsTheOutline) {
  const Stages stages = staged("random_sphere", 200);
  ASSERT_GT(stages.sum.facets.size(), 600u);
  EXPECT_NE(sum_picture(stages, "s").note.find("edges those of the outline alone are drawn"), std::string::npos);
}

TEST(Atlas, ABallThatIsASpeckIsSaidToBe) {
  GivenPoints tiny, huge;
  for (int i = 0; i < 8; ++i) {
    const auto at = [&](int bit) { return i & bit ? 1 : -1; };
    tiny.push_back(Point{at(1) * exact_value(1e-300), at(2) * exact_value(1e-300), at(4) * exact_value(1e-300)});
    huge.push_back(Point{(i & 1 ? 1 : 0) * exact_value(1e300), at(2) * exact_value(1e300), at(4) * exact_value(1e300)});
  }
  const SumPicture picture = sum_picture(stages::stages_of({tiny}, {huge}), "s");
  EXPECT_EQ(all(picture.svg, "(<svg)").size(), 1u);
  EXPECT_NE(picture.note.find("too small to be seen"), std::string::npos);
}

TEST(Atlas, WhatDoesNotOverlapHasNoP) {
  EXPECT_EQ(sum_picture(staged("random_disjoint", 20), "s").svg, "");
  const Case pair = families::find_family("random_sphere")->make(1, 10);
  const SumPicture mesh = sum_picture(stages::stages_of({{}, cylinder(1, 1)}, pair.b), "s");
  EXPECT_NE(mesh.note.find("A mesh near P"), std::string::npos);
}

TEST(Atlas, ShapesHaveNoCharts) {
  const Case pair = families::find_family("random_sphere")->make(1, 10);
  const Stages stages = stages::stages_of({{}, cylinder(1, 1)}, pair.b);
  EXPECT_EQ(chart_picture(stages, "p"), "");
  EXPECT_EQ(sphere_picture(stages, "p"), "");
  EXPECT_THROW(charts_file(stages), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::atlas
