// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/pose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace fathom::files {
namespace {

[[maybe_unused]] const int configured = setenv("RC_PARAMS", "seed=5 max_success=1000", 0);

mpq_class random_rational() {
  mpq_class value(*rc::gen::inRange(-1000, 1000), *rc::gen::inRange(1, 50));
  value.canonicalize();
  return value;
}
Point random_point() { return {random_rational(), random_rational(), random_rational()}; }
Pose random_pose() {
  Pose pose;
  for (auto& row : pose)
    for (mpq_class& entry : row) entry = random_rational();
  return pose;
}
std::array<mpq_class, 3> coordinates(const Point& p) { return {p.x, p.y, p.z}; }

TEST(Pose, IsMatrixTimesPointPlusTranslation) {
  EXPECT_TRUE(rc::check([] {
    const Pose pose = random_pose();
    const Point p = random_point();
    const auto in = coordinates(p), out = coordinates(placed(p, pose));
    for (std::size_t i = 0; i < 3; ++i) {
      mpq_class sum = pose[i][3];
      for (std::size_t j = 0; j < 3; ++j) sum += pose[i][j] * in[j];
      EXPECT_EQ(out[i], sum);
      EXPECT_EQ(gcd(out[i].get_num(), out[i].get_den()), 1);
    }
  }));
}

TEST(Pose, NeedNotBeARotation) {
  const Pose flattening{{{0, 0, 0, mpq_class("1/3")}, {1, 1, 1, 0}, {0, 0, -2, 0}}};
  EXPECT_EQ(placed({1, 2, 3}, flattening), (Point{mpq_class("1/3"), 6, -6}));
}

TEST(RoundToBinary64, TiesGoToEven) {
  const mpz_class two53 = mpz_class(1) << 53;
  Point p{mpq_class(two53 + 1), mpq_class(two53 + 3), mpq_class(-two53 - 1)};
  ASSERT_TRUE(round_to_binary64(p));
  EXPECT_EQ(p, (Point{mpq_class(two53), mpq_class(two53 + 4), mpq_class(-two53)}));
  Point q{mpq_class("1/10"), mpq_class("-1/3"), mpq_class(1) >> 1076};
  ASSERT_TRUE(round_to_binary64(q));
  EXPECT_EQ(q, (Point{mpq_class(0.1), mpq_class(-1.0 / 3), 0}));
}

TEST(RoundToBinary64, KeepsBinary64) {
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  Point p{mpq_class(most), mpq_class(-least), mpq_class(0.1)};
  const Point before = p;
  ASSERT_TRUE(round_to_binary64(p));
  EXPECT_EQ(p, before);
}

TEST(RoundToBinary64, OverflowIsToldInEachCoordinate) {
  const mpq_class half_ulp = mpq_class(mpz_class(1) << 970), most(std::numeric_limits<double>::max());
  for (int i = 0; i < 3; ++i) {
    Point p{0, 0, 0};
    mpq_class& x = i == 0 ? p.x : i == 1 ? p.y : p.z;
    x = -(most + half_ulp);
    EXPECT_FALSE(round_to_binary64(p));
    p = {0, 0, 0};
    x = most + half_ulp - 1;
    ASSERT_TRUE(round_to_binary64(p));
    EXPECT_EQ(x, most);
  }
}

}  // namespace
}  // namespace fathom::files
