// SPDX-License-Identifier: GPL-3.0-or-later
// The C interface gives what the C++ interface gives, and refuses everything else without throwing. That the header is C is shown by
// the installed package's consumer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "fathom/judge.h"
#include "tests/judge/pairs.hpp"

namespace fathom::judging {
namespace {

std::vector<double> cube_at(double x) {
  std::vector<double> points;
  for (unsigned i = 0; i < 8; ++i) points.insert(points.end(), {(i & 1) + x, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  return points;
}

std::vector<Triple> triples(const std::vector<double>& points) {
  std::vector<Triple> result;
  for (std::size_t i = 0; i < points.size(); i += 3) result.push_back({points[i], points[i + 1], points[i + 2]});
  return result;
}

class JudgeC : public ::testing::Test {
 protected:
  JudgeC() {
    fathom_claim_init(&claim);
    fathom_judgement_init(&judgement);
    claim.a = a.data();
    claim.a_count = 8;
    claim.b = b.data();
    claim.b_count = 8;
  }
  int run() { return fathom_judge(&claim, &judgement, sentence, sizeof sentence); }
  void claims(double depth, double x, double y, double z) {
    claim.overlap = claim.has_depth = claim.has_direction = 1;
    claim.depth = depth;
    claim.direction[0] = x;
    claim.direction[1] = y;
    claim.direction[2] = z;
  }
  void expect_refused() {
    sentence[0] = '\0';
    EXPECT_EQ(run(), FATHOM_BAD_ARGUMENT);
    EXPECT_EQ(judgement.verdict, -1);
    EXPECT_TRUE(std::isnan(judgement.error));
    EXPECT_GT(std::strlen(sentence), 5U);
  }

  std::vector<double> a = cube_at(0), b = cube_at(0.4);
  fathom_claim claim;
  fathom_judgement judgement;
  char sentence[1000] = "";
};

TEST_F(JudgeC, EqualsTheCppInterface) {
  claims(1.0392, -1, 0, 0);
  claim.has_witness_a = claim.has_witness_b = 1;
  const double witness_a[] = {1.25, 0.5, 0.5}, witness_b[] = {0.4, 0.5, 0.5};
  std::copy_n(witness_a, 3, claim.witness_a);
  std::copy_n(witness_b, 3, claim.witness_b);
  ASSERT_EQ(run(), FATHOM_JUDGED);
  Reply reply = testing::overlap(1.0392, Triple{-1, 0, 0});
  reply.witness_a = Triple{1.25, 0.5, 0.5};
  reply.witness_b = Triple{0.4, 0.5, 0.5};
  const Judgement expected = judge(triples(a), triples(b), reply);
  EXPECT_EQ(judgement.verdict, FATHOM_TOO_DEEP);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_TOO_DEEP | 1U << FATHOM_INCONSISTENT | 1U << FATHOM_WITNESS_OFF);
  EXPECT_EQ(judgement.accuracy, FATHOM_NO_CLASS);
  EXPECT_EQ(judgement.status, FATHOM_PENETRATING);
  EXPECT_EQ(judgement.true_depth, 0.6);
  EXPECT_EQ(judgement.true_distance, 0);
  EXPECT_EQ(judgement.error, expected.error);
  EXPECT_EQ(judgement.error_ulps, expected.error_ulps);
  EXPECT_EQ(judgement.error_relative, expected.error_relative);
  EXPECT_EQ(judgement.error_u_r, expected.error_u_r);
  EXPECT_EQ(judgement.price, 0.6);
  EXPECT_EQ(judgement.travel, 0.6);
  EXPECT_EQ(judgement.inconsistency, expected.inconsistency);
  EXPECT_TRUE(std::isnan(judgement.overlap_left));
  EXPECT_EQ(judgement.witness_a_distance, 0.25);
  EXPECT_EQ(judgement.witness_b_distance, 0);
  EXPECT_EQ(judgement.witness_gap, expected.witness_gap);
  EXPECT_EQ(sentence, expected.sentence);
}

TEST_F(JudgeC, Conventions) {
  claims(-0.6, 1, 0, 0);
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_WRONG_SIGN);
  claim.depth_negative = claim.moves_b = 1;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_PASS);
  EXPECT_EQ(judgement.accuracy, FATHOM_CORRECTLY_ROUNDED);
  claim.direction[0] = 7;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_NOT_A_DIRECTION);
  claim.not_unit = 1;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_PASS);
  claim.tol_relative = claim.tol_absolute = 0;
  claim.precision = FATHOM_BINARY32;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_PASS);  // within half an ulp
  claim.depth -= 0x1p-24;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_TOO_DEEP);
  claim.tol_ulps = 2;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_PASS);
  EXPECT_EQ(judgement.true_depth, 1 - static_cast<double>(0.4F));
}

TEST_F(JudgeC, Touching) {
  b = cube_at(1);
  claim.b = b.data();
  claim.touching = FATHOM_TOUCHING_IS_OVERLAP;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_FALSE_SEPARATION);
  EXPECT_EQ(judgement.status, FATHOM_TOUCHING);
  claim.touching = FATHOM_TOUCHING_IS_APART;
  ASSERT_EQ(run(), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_TOUCHING_BY_CONVENTION);
  EXPECT_TRUE(fathom_verdict_passes(judgement.verdict));
}

TEST_F(JudgeC, SentencesAreCutToTheBuffer) {
  char small[8] = "xxxxxxx";
  ASSERT_EQ(fathom_judge(&claim, &judgement, small, sizeof small), FATHOM_JUDGED);
  EXPECT_STREQ(small, "said to");
  EXPECT_EQ(fathom_judge(&claim, &judgement, nullptr, 0), FATHOM_JUDGED);
  EXPECT_EQ(judgement.verdict, FATHOM_FALSE_SEPARATION);
}

TEST_F(JudgeC, RefusesWhatIsNoClaim) {
  const fathom_claim good = claim;
  const auto with = [&](auto change) {
    claim = good;
    change();
    expect_refused();
  };
  with([&] { claim.a = nullptr; });
  with([&] { claim.b_count = 0; });
  with([&] { claim.size = 8; });
  with([&] { claim.precision = 2; });
  with([&] { claim.touching = 3; });
  with([&] { claim.touching = -1; });
  with([&] { claim.tol_relative = -1; });
  with([&] { claim.tol_absolute = std::nan(""); });
  with([&] { claim.tol_ulps = 0.5; });
  with([&] { claim.tol_ulps = std::numeric_limits<double>::infinity(); });
  with([&] { a[4] = std::nan(""); });
  with([&] { a[4] = 1e300, claim.precision = FATHOM_BINARY32; });
  EXPECT_EQ(fathom_judge(nullptr, &judgement, sentence, sizeof sentence), FATHOM_BAD_ARGUMENT);
  EXPECT_EQ(fathom_judge(&good, nullptr, sentence, sizeof sentence), FATHOM_BAD_ARGUMENT);
  judgement.size = 0;
  EXPECT_EQ(fathom_judge(&good, &judgement, nullptr, 0), FATHOM_BAD_ARGUMENT);
}

TEST(JudgeCNames, AreThoseOfCpp) {
  for (int i = 0; i <= FATHOM_PASS; ++i) {
    EXPECT_EQ(fathom_verdict_name(i), name(static_cast<Verdict>(i)));
    EXPECT_EQ(fathom_verdict_passes(i) != 0, passes(static_cast<Verdict>(i)));
  }
  EXPECT_STREQ(fathom_verdict_name(FATHOM_NOT_SEPARATING), "not-separating");
  EXPECT_EQ(fathom_verdict_name(-1), nullptr);
  EXPECT_EQ(fathom_verdict_name(FATHOM_PASS + 1), nullptr);
  EXPECT_FALSE(fathom_verdict_passes(-1));
}

}  // namespace
}  // namespace fathom::judging
