// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about shapes: what bounds prove and what they leave open. Pairs whose answers have a
// closed form are rows of tests/data/judged.jsonl too.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "verify/judge/measures.hpp"

namespace fathom::judging {
namespace {

using testing::Findings;
using testing::findings;
using testing::left;
using testing::none;
using testing::overlap;
using testing::right;
using testing::with_witness;

const Triple diagonal{-std::sqrt(0.5), -std::sqrt(0.5), 0};

Shape at(const Shape& shape, const mpq_class& x, const mpq_class& y = 0, const mpq_class& z = 0) {
  return moved(shape, rigid_pose({1, 0, 0, 0}, {x, y, z}));
}

/// Unit balls, the depth is 1/2.
ShapeTruth balls() { return truth_about(sphere(1), at(sphere(1), mpq_class(3, 2))); }
/// Parallel cylinders with axes 5/4 sqrt(2) apart: the depth is 2 - 5/4 sqrt(2).
ShapeTruth cylinders() {
  const Shape one = cylinder(1, 1);
  return truth_about(one, at(one, mpq_class(5, 4), mpq_class(5, 4)));
}
/// Parallel capsules with axes sqrt(1/2) apart: the depth is 1 - sqrt(1/2).
ShapeTruth capsules() {
  const Shape one = capsule(mpq_class(1, 2), 2);
  return truth_about(one, at(one, mpq_class(1, 2), mpq_class(1, 2)));
}

double capsule_depth() { return kernels::nearest_binary64({1, mpq_class(-1, 2)}); }
double cylinder_depth() { return kernels::nearest_binary64({2, mpq_class(-25, 8)}); }

TEST(JudgeShapes, RightAnswersAreCorrectlyRounded) {
  const Judgement ball = judge(balls(), with_witness(overlap(0.5, left), Triple{1, 0, 0}, Triple{0.5, 0, 0}), {},
                               Precision::binary64, none);
  EXPECT_EQ(ball.sentence, "right: 0.5 is claimed, the depth is 0.5 (correctly rounded)");
  EXPECT_EQ(ball.status, Status::penetrating);
  EXPECT_EQ(ball.signed_depth, (Between{0.5, 0.5}));
  EXPECT_EQ(ball.separating_distance, (Between{0.5, 0.5}));
  EXPECT_EQ(ball.witness_a_distance, (Between{0, 0}));
  EXPECT_EQ(ball.error, 0);
  for (const auto& [truth, depth] :
       {std::pair(capsules(), capsule_depth()), std::pair(cylinders(), cylinder_depth())}) {
    const Judgement result = judge(truth, overlap(depth, diagonal), {}, Precision::binary64, none);
    EXPECT_EQ(result.verdict, Verdict::pass) << result.sentence;
    EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded) << result.sentence;
    EXPECT_LE(result.signed_depth->low, depth);
    EXPECT_GE(result.signed_depth->high, depth);
    EXPECT_EQ(judge(truth, overlap(depth * (1 + 1e-8))).accuracy, Accuracy::millionth);
  }
}

// A radius of the subject's own widens nothing: what is wrong by a thousandth of the depth without
// it is wrong, and classes are of that.
TEST(JudgeShapes, RadiiThatTheSubjectAddedAreNoExcuse) {
  constexpr double radius = 1000;
  const Shape grown = with_margin(sphere(1), radius);
  for (const auto& [along, depth] : {std::pair(mpq_class(3, 2), 0.5), {mpq_class(5, 2), -0.5}}) {  // of the asked balls
    ShapeTruth truth = truth_about(grown, at(grown, along));
    const double right = 2 * radius + depth;
    EXPECT_EQ(findings(truth, overlap(right + 0.001)), Findings{}) << "of bodies that are meant to be so large";
    truth.added_a = truth.added_b = radius;
    EXPECT_EQ(findings(truth, overlap(right + 0.001)), Findings{Verdict::too_deep});
    EXPECT_EQ(findings(truth, overlap(right - 0.001)), Findings{Verdict::too_shallow});
    EXPECT_EQ(judge(truth, overlap(right)).accuracy, Accuracy::correctly_rounded);
    EXPECT_EQ(judge(truth, overlap(right + 0x1p-22)).accuracy, Accuracy::millionth);
    EXPECT_EQ(judge(truth, overlap(right + 0.00025)).accuracy, Accuracy::tolerance);
    EXPECT_EQ(*judge(truth, overlap(right + 0.0009765625)).error_relative, 0.0009765625 / 0.5);
    EXPECT_EQ(judge(truth, overlap(std::nextafter(2000.0 + depth / 3, 0)), {}, Precision::binary64, none).accuracy,
              std::nullopt);
  }
}

TEST(JudgeShapes, WitnessPoints) {
  const double b = 1.25 - std::sqrt(0.5);
  const Judgement off =
      judge(cylinders(), with_witness(overlap(cylinder_depth(), diagonal), Triple{2, 0, 0}, Triple{b, b, 0}));
  EXPECT_LE(off.witness_a_distance->low, 1);
  EXPECT_GE(off.witness_a_distance->high, 1);
  EXPECT_LT(off.witness_a_distance->high - off.witness_a_distance->low, 1e-11);
  EXPECT_NE(off.sentence.find("the witness point of A is 1 away from it"), std::string::npos) << off.sentence;
}

// 40 bits do not tell neighbouring doubles apart, and more are asked for.
TEST(JudgeShapes, ClaimsInsideTheBoundsAreNeitherTooDeepNorTooShallow) {
  const ShapeTruth truth = cylinders();
  const double depth = cylinder_depth();
  for (const double claim : {std::nextafter(depth, 1), std::nextafter(depth, 0)}) {
    const std::unique_ptr<Measures> usual = measures_of(truth, Precision::binary64, none, usual_bits);
    EXPECT_FALSE(usual->too_long(exact_value(claim)) || usual->too_short(exact_value(claim)));
    EXPECT_TRUE(usual->open()) << "it does not know";
    const std::unique_ptr<Measures> closer = measures_of(truth, Precision::binary64, none, 2 * usual_bits);
    EXPECT_EQ(closer->too_long(exact_value(claim)), claim > depth);
    EXPECT_EQ(closer->too_short(exact_value(claim)), claim < depth);
    EXPECT_FALSE(closer->open());
    EXPECT_EQ(findings(truth, overlap(claim), {}, none),
              Findings{claim > depth ? Verdict::too_deep : Verdict::too_shallow});
  }
  // A truth that knows next to nothing: every answer but the absurd is within it, until more bits
  // are asked for.
  SignedDepthOptions hasty;
  hasty.bits = 1;
  hasty.support_calls = 1;
  const ShapeTruth vague = truth_about(truth.a, truth.b, hasty);
  ASSERT_TRUE(vague.depth.bounds());
  const std::unique_ptr<Measures> knows_little = measures_of(vague, Precision::binary64, {}, usual_bits);
  const mpq_class within = (std::max(vague.depth.bounds()->low, mpq_class(0)) + vague.depth.bounds()->high) / 2;
  EXPECT_FALSE(knows_little->too_short(within) || knows_little->too_long(within));
  EXPECT_TRUE(knows_little->open());
  EXPECT_EQ(findings(vague, overlap(depth)), Findings{});
  EXPECT_EQ(findings(vague, overlap(1.002 * depth)), Findings{Verdict::too_deep});
}

ShapeTruth of_family(const char* family, std::uint64_t seed) {
  const families::NamedPair pair = families::find_family(family)->make_shapes(seed, 8).pair;
  return truth_about(files::shape_of(pair.a), files::shape_of(pair.b));
}

// Ellipsoids with less than 2^-200 between them: neither answer is wrong, and a depth beyond the
// bounds is.
TEST(JudgeShapes, WhatIsUndecidedIsNobodysFault) {
  const mpz_class scale = mpz_class(1) << 220, root = sqrt(mpz_class(2 * scale * scale));
  mpq_class root_of_two(root, scale);
  root_of_two.canonicalize();
  const Shape one = ellipsoid({1, 1, 2});
  const ShapeTruth truth = truth_about(one, at(one, root_of_two, root_of_two));
  ASSERT_FALSE(truth.depth.status());
  Conventions strict;
  for (const auto touching : {Conventions::Touching::overlap, Conventions::Touching::separate}) {
    strict.touching = touching;
    for (const Reply& reply : {Reply{}, overlap({}), overlap(0)}) {
      const Judgement result = judge(truth, reply, strict, Precision::binary64, none);
      EXPECT_EQ(result.verdict, Verdict::pass) << result.sentence;
      EXPECT_EQ(result.accuracy, Accuracy::tolerance);
      EXPECT_FALSE(result.status);
      EXPECT_LE(result.signed_depth->low, 0);
      EXPECT_GE(result.signed_depth->high, 0);
      EXPECT_EQ(
          result.sentence,
          std::string(
              "undecided: the bounds of the truth leave open whether the bodies overlap, and it says that they ") +
              (reply.overlap ? "do" : "do not"));
    }
  }
  EXPECT_EQ(findings(truth, overlap(1e-9), {}, none), Findings{Verdict::too_deep});
}

// A depth of 3e-14, of which 40 bits tell little.
TEST(JudgeShapes, MoreBitsTellHowDeepTheyOverlap) {
  const ShapeTruth truth = of_family("inverse_tapered_sides", 1);
  EXPECT_EQ(findings(truth, Reply{}, {}, none), Findings{Verdict::false_separation});
  EXPECT_EQ(findings(truth, overlap({}), {}, none), Findings{});
  EXPECT_EQ(findings(truth, overlap(0), {}, none), Findings{Verdict::too_shallow});
  EXPECT_EQ(findings(truth, Reply{}), Findings{}) << "within the usual tolerance";
}

// No answer fails for being rounded: what the numbers of a foot point far away cost is allowed.
TEST(JudgeShapes, AHalfSpaceFarFromO) {
  const ShapeTruth truth = truth_about(sphere(1), halfspace({1, 1, 1}, 1000));
  const double depth = kernels::nearest_binary64(*truth.depth.exact()), h = std::sqrt(1.0 / 3), foot = 1000.0 / 3;
  EXPECT_EQ(findings(truth, with_witness(overlap(depth, Triple{h, h, h}), Triple{-h, -h, -h}, Triple{foot, foot, foot}),
                     {}, none),
            Findings{});
  const Judgement shallow = judge(truth, overlap(depth - 1, Triple{h, h, h}));
  EXPECT_EQ(shallow.findings, (Findings{Verdict::too_shallow, Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_NEAR(*shallow.overlap_left, 1, 1e-9);
}

// Means of lengths beyond binary64.
TEST(JudgeShapes, HugeBodies) {
  const mpq_class huge = exact_value(1.7e308);
  const ShapeTruth truth = truth_about(sphere(huge), at(cylinder(huge, huge), 1));
  const Judgement result = judge(truth, overlap(1e308, left));
  EXPECT_EQ(result.findings, (Findings{Verdict::too_shallow, Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_GE(*result.overlap_left, 1e308);
}

TEST(JudgeShapes, TwoHalfSpacesHaveNoDepth) {
  EXPECT_THROW(truth_about(halfspace({0, 0, 2}, 0), halfspace({0, 0, 2}, 0)), std::invalid_argument);
}

TEST(JudgeShapes, TolerancesAreInLowestTerms) {
  mpq_class half;
  half.get_num() = 2;
  half.get_den() = 4;
  EXPECT_THROW(judge(balls(), overlap(0.5), {}, Precision::binary64, {half, 0, 0}), std::invalid_argument);
  EXPECT_THROW(judge(balls(), overlap(0.5), {}, Precision::binary64, {0, half, 0}), std::invalid_argument);
}

TEST(JudgeShapes, JudgedInBinary32) {
  const mpq_class r = exact_value(0.1F);
  const ShapeTruth truth = truth_about(sphere(r), at(sphere(r), exact_value(0.15F)));
  const float depth = round_binary32(2 * r - exact_value(0.15F));
  const Judgement result = judge(truth, overlap(depth, left), {}, Precision::binary32, none);
  EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded) << result.sentence;
  EXPECT_EQ(judge(truth, overlap(0.05, left), {}, Precision::binary32, none).verdict, Verdict::too_deep)
      << "of the numbers before rounding";
}

/// What a right subject answers: the middle of the bounds, and the direction.
Reply right_reply(const ShapeTruth& truth) {
  const auto status = truth.depth.status();
  if (status == Status::disjoint) return {};
  const Bounds bounds = truth.depth.bounds() ? *truth.depth.bounds() : Bounds{};
  const double depth = truth.depth.exact() ? kernels::nearest_binary64(*truth.depth.exact())
                                           : round_binary64((bounds.low + bounds.high) / 2);
  return overlap(std::max(depth, 0.0), testing::unit(truth.depth.direction()));
}

TEST(JudgeShapes, OfAllFamiliesRightAnswersPassAndScaledOnesFail) {
  std::size_t penetrating = 0, enclosed = 0;
  for (const families::Family& family : families::families(families::Kind::shapes))
    for (const std::uint64_t seed : {1, 2}) {
      const families::NamedPair pair = family.make_shapes(seed, family.usual_size).pair;
      const ShapeTruth truth = truth_about(files::shape_of(pair.a), files::shape_of(pair.b));
      const Reply reply = right_reply(truth);
      const Judgement right =
          judge(truth, reply, {}, Precision::binary64, {mpq_class(1, 1'000'000), mpq_class(1, 1'000'000'000), 8});
      EXPECT_TRUE(passes(right.verdict)) << family.name << ' ' << seed << ": " << right.sentence;
      if (truth.depth.status() != Status::penetrating || truth.depth.low_binary64() < 1e-3) continue;
      ++penetrating;
      enclosed += truth.depth.bounds() != nullptr;
      Reply deep = reply, shallow = reply;
      *deep.depth *= 1.01;
      *shallow.depth *= 0.99;
      const Tolerance tolerance{mpq_class(1, 1000), 0, 0};
      EXPECT_EQ(judge(truth, deep, {}, Precision::binary64, tolerance).verdict, Verdict::too_deep)
          << family.name << ' ' << seed;
      EXPECT_EQ(judge(truth, shallow, {}, Precision::binary64, tolerance).findings,
                (Findings{Verdict::too_shallow, Verdict::not_separating, Verdict::inconsistent}))
          << family.name << ' ' << seed;
    }
  EXPECT_GT(penetrating, 15U);
  EXPECT_GT(enclosed, 5U);
}

}  // namespace
}  // namespace fathom::judging
