// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals, borders and precisions. Each verdict and each convention, on pairs whose answers one
// can see, is a row of tests/data/judged.jsonl, which tests/doors/judged_test.cpp reads.
#include "fathom/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"

namespace fathom::judging {
namespace {

using testing::cube;
using testing::cubes;
using testing::Findings;
using testing::findings;
using testing::left;
using testing::nan;
using testing::overlap;

TEST(Judge, ARightAnswerPassesWithItsClass) {
  const Judgement result = judge(cubes(), overlap(0.6, left));
  EXPECT_EQ(result.verdict, Verdict::pass);
  EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(result.depth_squared, mpq_class(9, 25));
  EXPECT_EQ(result.separating_distance_squared, mpq_class(9, 25));
  EXPECT_EQ(result.exit_distance_squared, mpq_class(9, 25));
  const mpq_class off = exact_value(0.6) - mpq_class(3, 5);
  EXPECT_EQ(result.error, round_binary64(off, Rounding::rn));
  EXPECT_EQ(result.error_relative, round_binary64(mpq_class(off / mpq_class(3, 5)), Rounding::rn));
  EXPECT_EQ(result.error_ulps, round_binary64(mpq_class(off << 53), Rounding::rn));
  EXPECT_EQ(result.error_u_r, round_binary64(mpq_class((off << 53) / mpq_class(7, 5)), Rounding::rn));
  EXPECT_EQ(result.sentence, "right: 0.6 is claimed, the depth is 0.6 (correctly rounded)");
}

TEST(Judge, OnTheBorderOfEachToleranceAnAnswerPasses) {
  const Truth half = truth_about(cube(0), cube(mpq_class(1, 2)));
  const Tolerance eighth[] = {
      {mpq_class(1, 8), 0, 0}, {0, mpq_class(1, 16), 0}, {0, 0, 1UL << 49}};  // of the depth, the extent, in ulps
  for (const Tolerance& tolerance : eighth) {
    for (const double d : {0.4375, 0.5625}) {
      EXPECT_EQ(findings(half, overlap(d, left), {}, tolerance), Findings{}) << d;
      const Verdict beyond = d < 0.5 ? Verdict::too_shallow : Verdict::too_deep;
      EXPECT_EQ(findings(half, overlap(std::nextafter(d, 2 * d - 0.5)), {}, tolerance), Findings{beyond}) << d;
    }
  }
  EXPECT_EQ(findings(half, overlap({}), {}, {-1, -1, 0}), Findings{}) << "tolerances below 0 count as 0";
  EXPECT_EQ(findings(half, overlap(std::nextafter(0.5, 1)), {}, {-1, -1, 0}), Findings{Verdict::too_deep});
  // Half an ulp at 1/2 is the distance of the number below it, as VERDICTS.md says; the class tells
  // it from a right one.
  const double below = std::nextafter(0.5, 0);
  EXPECT_EQ(judge(half, overlap(below), {}, {}, {0, 0, 0}).accuracy, Accuracy::ulps_4);
  EXPECT_EQ(findings(half, overlap(std::nextafter(below, 0)), {}, {0, 0, 0}), Findings{Verdict::too_shallow});
}

// A slanted direction: A leaves through the same side of P, later than along the normal, and the
// plane across the direction is later still.
TEST(Judge, ASlantedDirectionIsMeasuredByItsOwnPlane) {
  Conventions any;
  any.unit = false;
  const Judgement result = judge(cubes(), overlap(0.75, Triple{-4, 3, 0}), any);
  EXPECT_EQ(result.exit_distance_squared, mpq_class(9, 16));
  EXPECT_EQ(result.separating_distance_squared, mpq_class(27 * 27, 25 * 25));
  EXPECT_EQ(result.findings, (Findings{Verdict::too_deep, Verdict::inconsistent})) << "but it separates";
}

TEST(Judge, ABinary32SubjectIsJudgedOnWhatItSees) {
  const std::vector<Point> a = cube(0), b = cube(mpq_class(2, 5));
  const Truth truth = truth_about(*seen(a, Precision::binary32), *seen(b, Precision::binary32));
  EXPECT_EQ(truth.b.front().x, exact_value(0.4F));
  const mpq_class depth = 1 - exact_value(0.4F);
  ASSERT_EQ(truth.depth.squared(), depth * depth);
  const double claimed = round_binary32(depth, Rounding::rn);
  const Judgement result = judge(truth, overlap(claimed, left), {}, Precision::binary32);
  EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(result.sentence.substr(0, 18), "right: 0.6 is clai") << "as a float";
  EXPECT_EQ(judge(truth, overlap(claimed + 0x1p-24, left), {}, Precision::binary32).error_ulps, 1.5)
      << "the depth is a tie of two floats";
  EXPECT_FALSE(seen({{exact_value(1e300), 0, 0}}, Precision::binary32));
  EXPECT_EQ(judge({{0, 0, 0}}, {{0.1, 0, 0}}, overlap({}), {}, Precision::binary32).distance_squared,
            exact_value(0.1F) * exact_value(0.1F));
}

TEST(Judge, OneCallForPointsInBinary64) {
  std::vector<Triple> a, b;
  for (const Point& p : cube(0)) a.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
  for (const Triple& p : a) b.push_back({p[0] + 0.4, p[1], p[2]});
  EXPECT_EQ(judge(a, b, overlap(1.0392)).verdict, Verdict::too_deep);
  EXPECT_THROW(judge({}, b, Reply{}), std::invalid_argument);
  EXPECT_THROW(judge({{nan, 0, 0}}, b, Reply{}), std::invalid_argument);
  EXPECT_THROW(judge({{1e300, 0, 0}}, b, Reply{}, {}, Precision::binary32), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::judging
