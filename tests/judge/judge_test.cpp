// SPDX-License-Identifier: GPL-3.0-or-later
// Each verdict, each convention and each residual, on pairs whose answers one can see.
#include "fathom/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"

namespace fathom::judging {
namespace {

using testing::box;
using testing::cube;
using testing::cubes;
using testing::disjoint_cubes;
using testing::Findings;
using testing::findings;
using testing::left;
using testing::nan;
using testing::overlap;
using testing::right;
using testing::touching_cubes;
using testing::up;
using testing::with_witness;

constexpr double infinity = std::numeric_limits<double>::infinity();

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

TEST(Judge, ClassesOfAccuracy) {
  const auto accuracy = [](double d) { return *judge(cubes(), overlap(d)).accuracy; };
  EXPECT_EQ(accuracy(0.6), Accuracy::correctly_rounded);
  EXPECT_EQ(accuracy(std::nextafter(0.6, 1)), Accuracy::ulps_4);
  EXPECT_EQ(accuracy(0.6 + 0x1p-50), Accuracy::u_r_16);
  EXPECT_EQ(accuracy(0.6 + 1e-10), Accuracy::millionth);
  EXPECT_EQ(accuracy(0.6 - 5.9e-7), Accuracy::millionth);
  EXPECT_EQ(accuracy(0.6 - 6.1e-7), Accuracy::tolerance);
  EXPECT_EQ(name(Accuracy::u_r_16), "16 uR");
}

TEST(Judge, Depths) {
  EXPECT_EQ(findings(cubes(), overlap(1.0392)), Findings{Verdict::too_deep});
  EXPECT_EQ(findings(cubes(), overlap(0.5)), Findings{Verdict::too_shallow});
  EXPECT_EQ(findings(cubes(), overlap(0.6005)), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.6007)), Findings{Verdict::too_deep});
  EXPECT_EQ(findings(cubes(), overlap(0.5995)), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.5993)), Findings{Verdict::too_shallow});
  EXPECT_EQ(findings(cubes(), overlap(0)), Findings{Verdict::too_shallow});
  EXPECT_EQ(findings(cubes(), overlap(nan)), Findings{Verdict::nan});
  EXPECT_EQ(findings(cubes(), overlap(infinity)), Findings{Verdict::nan});
  EXPECT_EQ(findings(cubes(), overlap({})), Findings{});
  EXPECT_EQ(judge(cubes(), overlap(1.0392, left)).sentence,
            "too deep by 0.4392: 1.0392 is claimed, the depth is 0.6; inconsistent: the plane across its direction is "
            "at 0.6, not at 1.0392");
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

TEST(Judge, SignsOfTheDepth) {
  Conventions negative;
  negative.depth = Conventions::Sign::negative;
  EXPECT_EQ(findings(cubes(), overlap(-0.6, left), negative), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.6, left), negative), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(cubes(), overlap(-0.6, left)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(cubes(), overlap(-0.6, right)), Findings{Verdict::wrong_sign}) << "both signs";
  EXPECT_EQ(findings(cubes(), overlap(-0.7)), Findings{Verdict::too_shallow}) << "not right with the other sign either";
  EXPECT_EQ(judge(cubes(), overlap(-0.6)).error, -1.2) << "residuals are of the claim as it stands";
  EXPECT_EQ(judge(cubes(), overlap(0.6), negative).sentence,
            "the depth has the wrong sign: 0.6 is claimed, by its conventions -0.6 is right");
}

TEST(Judge, Directions) {
  EXPECT_EQ(findings(cubes(), overlap(0.6, right)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(cubes(), overlap(0.6, up)), (Findings{Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_EQ(findings(cubes(), overlap(1, up)), Findings{Verdict::too_deep})
      << "consistent with its own direction, and too deep";
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{0, 0, 0})), Findings{Verdict::not_a_direction});
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{-2, 0, 0})), Findings{Verdict::not_a_direction});
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{-0.9995, 0, 0})), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{-0.9985, 0, 0})), Findings{Verdict::not_a_direction});
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{2, 0, 0})),
            (Findings{Verdict::not_a_direction, Verdict::wrong_sign}));
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{nan, 0, 0})), Findings{Verdict::nan});
  EXPECT_EQ(findings(cubes(), overlap({}, Triple{nan, 0, 0})), Findings{}) << "without a depth it is not needed";
  EXPECT_EQ(judge(cubes(), overlap(0.6, up)).sentence,
            "not separating: 0.4 of overlap is left along its direction; inconsistent: the plane across its direction "
            "is at 1, not at 0.6");
  EXPECT_EQ(judge(cubes(), overlap(0.6, up)).overlap_left, kernels::nearest_binary64({1 - exact_value(0.6), 0}));
  EXPECT_FALSE(judge(cubes(), overlap(1, up)).overlap_left);
}

TEST(Judge, DirectionsOfAnyLength) {
  Conventions any;
  any.unit = false;
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{-1e300, 0, 0}), any), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{-5e-324, 0, 0}), any), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.6, Triple{0, 0, 0}), any), Findings{Verdict::not_a_direction});
}

TEST(Judge, TheBodyThatMoves) {
  Conventions b;
  b.moves = Conventions::Body::b;
  EXPECT_EQ(findings(cubes(), overlap(0.6, right), b), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(0.6, left), b), Findings{Verdict::wrong_sign});
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

TEST(Judge, Classification) {
  EXPECT_EQ(findings(cubes(), Reply{}), Findings{Verdict::false_separation});
  EXPECT_EQ(findings(disjoint_cubes(), Reply{}), Findings{});
  EXPECT_EQ(findings(disjoint_cubes(), overlap({})), Findings{Verdict::false_overlap});
  EXPECT_EQ(findings(disjoint_cubes(), overlap(0.1)), (Findings{Verdict::false_overlap, Verdict::too_deep}));
  EXPECT_EQ(judge(disjoint_cubes(), overlap({})).sentence, "said to overlap: the bodies are apart by 0.5");
  EXPECT_EQ(judge(cubes(), Reply{}).sentence, "said to be apart: the bodies overlap, the depth is 0.6");
  Reply unread;
  unread.depth = nan;
  EXPECT_EQ(findings(disjoint_cubes(), unread), Findings{}) << "numbers of an answer 'apart' are not read";
}

TEST(Judge, ClassificationNearContact) {
  const mpq_class hair(1, 10'000'000);
  const Truth barely = truth_about(cube(0), cube(1 - hair)), hardly = truth_about(cube(0), cube(1 + hair));
  EXPECT_EQ(findings(barely, Reply{}), Findings{});
  EXPECT_EQ(judge(barely, Reply{}).accuracy, Accuracy::tolerance);
  EXPECT_EQ(judge(barely, Reply{}).sentence, "within the tolerance: said to be apart, the depth is 1e-07");
  EXPECT_EQ(findings(hardly, overlap({})), Findings{});
  EXPECT_EQ(findings(hardly, overlap(1e-7)), Findings{});
  EXPECT_EQ(findings(hardly, overlap(1e-7, right)), Findings{Verdict::wrong_sign})
      << "the pair is 2 long across -x, and 1e-7 apart";
  EXPECT_EQ(findings(hardly, overlap(1e-5)), (Findings{Verdict::false_overlap, Verdict::too_deep}));
  const Tolerance exact{0, 0, 0};
  EXPECT_EQ(findings(barely, Reply{}, {}, exact), Findings{Verdict::false_separation});
  EXPECT_EQ(findings(hardly, overlap({}), {}, exact), Findings{Verdict::false_overlap});
}

TEST(Judge, TouchingIsAsDeclared) {
  using Touching = Conventions::Touching;
  Conventions conventions;
  for (const bool said : {false, true}) {
    const Reply reply = said ? overlap({}) : Reply{};
    conventions.touching = Touching::either;
    EXPECT_EQ(findings(touching_cubes(), reply, conventions), Findings{});
    conventions.touching = Touching::overlap;
    EXPECT_EQ(findings(touching_cubes(), reply, conventions), said ? Findings{} : Findings{Verdict::false_separation});
    conventions.touching = Touching::separate;
    EXPECT_EQ(findings(touching_cubes(), reply, conventions), said ? Findings{Verdict::false_overlap} : Findings{});
  }
  EXPECT_EQ(judge(touching_cubes(), Reply{}).verdict, Verdict::touching_by_convention);
  EXPECT_EQ(findings(touching_cubes(), overlap(0.1)), Findings{Verdict::too_deep});
  EXPECT_EQ(findings(touching_cubes(), overlap(0, left)), Findings{});
  EXPECT_EQ(findings(touching_cubes(), overlap(-0.1, left)), (Findings{Verdict::too_shallow, Verdict::inconsistent}));
  EXPECT_EQ(findings(touching_cubes(), overlap(0, right)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(touching_cubes(), overlap(0, up)), Findings{Verdict::inconsistent});
  EXPECT_EQ(findings(touching_cubes(), overlap(0, Triple{0, 0, 0})), Findings{Verdict::not_a_direction});
}

TEST(Judge, WitnessPoints) {
  const Reply reply = overlap(0.6, left);
  EXPECT_EQ(findings(cubes(), with_witness(reply, Triple{1, 0.5, 0.5}, Triple{0.4, 0.5, 0.5})), Findings{});
  EXPECT_EQ(findings(cubes(), with_witness(reply, Triple{0.9, 0.5, 0.5}, {})), Findings{}) << "inside";
  EXPECT_EQ(findings(cubes(), with_witness(reply, Triple{1.25, 0.5, 0.5}, {})), Findings{Verdict::witness_off});
  EXPECT_EQ(findings(cubes(), with_witness(reply, {}, Triple{0.4, -3, 0.5})), Findings{Verdict::witness_off});
  EXPECT_EQ(findings(cubes(), with_witness(reply, Triple{1, 0.5, 0.5}, Triple{0.4, 0.5, 0.6})),
            Findings{Verdict::witness_off});
  EXPECT_EQ(findings(cubes(), with_witness(reply, Triple{1, nan, 0.5}, {})), Findings{Verdict::nan});
  Reply undirected = reply;
  undirected.direction.reset();
  EXPECT_EQ(findings(cubes(), with_witness(undirected, Triple{1, 0.5, 0.5}, Triple{0.4, 0.5, 0.5})), Findings{});
  EXPECT_EQ(findings(cubes(), with_witness(undirected, Triple{1, 0.5, 0.5}, Triple{0.5, 0.5, 0.5})),
            Findings{Verdict::witness_off});
  EXPECT_NEAR(*judge(cubes(), with_witness(undirected, Triple{1, 0.5, 0.5}, Triple{0.5, 0.5, 0.5})).witness_gap, 0.1,
              1e-15);
  const Judgement off = judge(cubes(), with_witness(reply, Triple{1.25, 0.5, 0.5}, Triple{0.4, -3, 0.5}));
  EXPECT_EQ(off.witness_a_squared, mpq_class(1, 16));
  EXPECT_EQ(off.witness_b_squared, 9);
  EXPECT_EQ(off.sentence,
            "the witness point of A is 0.25 away from it; the witness point of B is 3 away from it; "
            "the witness points miss the translation by 3.509");
}

TEST(Judge, EveryTieIsRight) {
  const Truth same = truth_about(cube(0), cube(0));
  ASSERT_EQ(same.depth.optima().size(), 6U);
  for (const Triple& u : {left, right, up, Triple{0, 0, -1}, Triple{0, 1, 0}, Triple{0, -1, 0}}) {
    EXPECT_EQ(findings(same, overlap(1, u)), Findings{});
  }
}

TEST(Judge, FlatBodiesAndPoints) {
  const std::vector<Point> point{{mpq_class(1, 4), mpq_class(1, 2), mpq_class(1, 2)}}, elsewhere{{5, 0, 0}};
  const Truth inside = truth_about(point, cube(0)), apart = truth_about(point, elsewhere),
              equal = truth_about(point, point);
  EXPECT_EQ(findings(inside, overlap(0.25, left)), Findings{});
  EXPECT_EQ(findings(apart, Reply{}), Findings{});
  EXPECT_EQ(findings(apart, overlap({})), Findings{Verdict::false_overlap}) << "no extent, no tolerance";
  EXPECT_EQ(judge(equal, overlap(0)).verdict, Verdict::touching_by_convention);
  EXPECT_EQ(findings(equal, overlap(5e-324)), Findings{Verdict::too_deep});
  EXPECT_EQ(findings(equal, overlap(5e-324), {}, {0, 0, 1}), Findings{});
}

TEST(Judge, ExtremeScales) {
  const mpq_class huge = exact_value(1e300), tiny = exact_value(5e-324);
  const Truth large = truth_about(box({0, 0, 0}, {huge, huge, huge}), box({huge / 2, 0, 0}, {2 * huge, huge, huge}));
  EXPECT_EQ(findings(large, overlap(5e299, left)), Findings{});
  EXPECT_EQ(findings(large, overlap(1.7e308, left)), (Findings{Verdict::too_deep, Verdict::inconsistent}));
  const Truth small =
      truth_about(box({0, 0, 0}, {3 * tiny, 3 * tiny, 3 * tiny}), box({tiny, 0, 0}, {4 * tiny, 3 * tiny, 3 * tiny}));
  EXPECT_EQ(judge(small, overlap(1e-323, left)).accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(judge(small, overlap(5e-324, left)).error_ulps, -1);
  EXPECT_EQ(judge(small, overlap(1.7e308, left)).error_relative, infinity);
  const Truth far = truth_about({{huge, 0, 0}}, {{-huge, tiny, 0}});
  EXPECT_EQ(findings(far, overlap(1e-323, left)),
            (Findings{Verdict::false_overlap, Verdict::too_deep, Verdict::inconsistent}));
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
