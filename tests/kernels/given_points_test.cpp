// SPDX-License-Identifier: GPL-3.0-or-later
// Laws: points in binary64 and the same exact points cannot be told apart, except by asking for the
// form; both forms may be asked for at once; a change is a change of the exact points.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include "fathom/body.hpp"

namespace fathom {
namespace {

using Doubles = std::vector<std::array<double, 3>>;

const Doubles doubles{{0, 0.5, -3}, {0x1p-1074, -0x1p1000, 0.1}};
const std::vector<Point> points{{0, mpq_class(1, 2), -3}, {mpq_class(0x1p-1074), mpq_class(-0x1p1000), mpq_class(0.1)}};

TEST(GivenPoints, AreTheSameInBothForms) {
  const GivenPoints given(doubles), exact(points);
  EXPECT_TRUE(given.in_binary64());
  EXPECT_FALSE(exact.in_binary64());
  EXPECT_TRUE(exact.binary64().empty());
  EXPECT_TRUE(given == exact);
  EXPECT_EQ(given.size(), 2U);
  EXPECT_EQ(given.exact(), points);
  EXPECT_EQ(std::vector<Point>(given.begin(), given.end()), points);
  EXPECT_EQ(given[1], points[1]);
  EXPECT_EQ(given.front(), points.front());
  EXPECT_EQ(given.back(), points.back());
  EXPECT_TRUE(given == GivenPoints(doubles));
  EXPECT_FALSE(given == GivenPoints(Doubles{{0, 0.5, -3}, {0x1p-1073, -0x1p1000, 0.1}}));
  EXPECT_FALSE(given == GivenPoints(Doubles{{0, 0.5, -3}}));
}

TEST(GivenPoints, KnowNoMinusZero) {
  const GivenPoints given(Doubles{{-0.0, 1, -0.0}});
  EXPECT_FALSE(std::signbit(given.binary64()[0][0]));
  EXPECT_TRUE(given == GivenPoints(Doubles{{0, 1, 0}}));
}

TEST(GivenPoints, AreFinite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Doubles with_bad = doubles;
      with_bad[1][axis] = bad;
      EXPECT_THROW(GivenPoints{with_bad}, std::invalid_argument) << bad;
    }
}

TEST(GivenPoints, OfNoneAreExact) {
  EXPECT_FALSE(GivenPoints(Doubles()).in_binary64());
  EXPECT_TRUE(GivenPoints(Doubles()).empty());
}

TEST(GivenPoints, AreChangedAsExactPoints) {
  GivenPoints changed(doubles);
  const GivenPoints copy = changed;
  changed.edit()[0].x = mpq_class(1, 3);
  changed.push_back({1, 2, 3});
  EXPECT_FALSE(changed.in_binary64());
  EXPECT_EQ(changed.size(), 3U);
  EXPECT_EQ(changed[0].x, mpq_class(1, 3));
  EXPECT_TRUE(copy.in_binary64());
  EXPECT_EQ(copy.exact(), points) << "a copy is not changed";
}

TEST(GivenPoints, BecomeExactOnceForAll) {
  const GivenPoints given(doubles), copy = given;
  std::vector<const Point*> found(8);
  std::vector<std::thread> threads;
  for (const Point*& place : found) threads.emplace_back([&] { place = given.data(); });
  for (std::thread& thread : threads) thread.join();
  for (const Point* place : found) EXPECT_EQ(place, copy.data());
}

}  // namespace
}  // namespace fathom
