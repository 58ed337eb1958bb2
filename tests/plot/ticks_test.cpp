// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "view/plot/plot.hpp"

namespace fathom::plot {
namespace {

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
