// SPDX-License-Identifier: GPL-3.0-or-later
// The judge for C gives what the C++ interface gives, of points, of shapes and of unions, and
// refuses everything else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "tests/c/handles.hpp"
#include "tests/c/unions.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

std::vector<Triple> triples(const std::vector<double>& points) {
  std::vector<Triple> result;
  for (std::size_t i = 0; i < points.size(); i += 3) result.push_back({points[i], points[i + 1], points[i + 2]});
  return result;
}

std::vector<Point> box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (const Point& x : {low, high})
    for (const Point& y : {low, high})
      for (const Point& z : {low, high}) corners.push_back({x.x, y.y, z.z});
  return corners;
}

class CJudge : public ::testing::Test {
 protected:
  CJudge() {
    fathom_claim_init(&claim);
    fathom_judgement_init(&judgement);
  }
  int run() {
    char* text = nullptr;
    const int code = fathom_judge(a.get(), b.get(), &claim, &judgement, &text);
    EXPECT_EQ(text != nullptr, code == FATHOM_OK);
    sentence = taken(text);
    return code;
  }
  void claims(double depth, double x, double y, double z) {
    claim.overlap = claim.has_depth = claim.has_direction = 1;
    claim.depth = depth;
    claim.direction[0] = x;
    claim.direction[1] = y;
    claim.direction[2] = z;
  }
  void expect_refused() {
    EXPECT_EQ(run(), FATHOM_BAD_INPUT);
    EXPECT_EQ(judgement.verdict, -1);
    EXPECT_TRUE(std::isnan(judgement.error));
    EXPECT_GT(std::strlen(fathom_last_error()), 5U);
  }

  BodyHandle a = body_of(cube_at(0)), b = body_of(cube_at(0.4));
  fathom_claim claim;
  fathom_judgement judgement;
  std::string sentence;
};

TEST_F(CJudge, EqualsTheCppInterface) {
  claims(1.0392, -1, 0, 0);
  claim.has_witness_a = claim.has_witness_b = 1;
  const double witness_a[] = {1.25, 0.5, 0.5}, witness_b[] = {0.4, 0.5, 0.5};
  std::copy_n(witness_a, 3, claim.witness_a);
  std::copy_n(witness_b, 3, claim.witness_b);
  ASSERT_EQ(run(), FATHOM_OK);
  Reply reply;
  reply.overlap = true;
  reply.depth = 1.0392;
  reply.direction = Triple{-1, 0, 0};
  reply.witness_a = Triple{1.25, 0.5, 0.5};
  reply.witness_b = Triple{0.4, 0.5, 0.5};
  const Judgement expected = judge(triples(cube_at(0)), triples(cube_at(0.4)), reply);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_DEEP);
  EXPECT_EQ(judgement.findings,
            1U << FATHOM_VERDICT_TOO_DEEP | 1U << FATHOM_VERDICT_INCONSISTENT | 1U << FATHOM_VERDICT_WITNESS_OFF);
  EXPECT_EQ(judgement.accuracy, FATHOM_NO_CLASS);
  EXPECT_EQ(judgement.status, FATHOM_PENETRATING);
  EXPECT_EQ(judgement.signed_depth, 0.6);
  EXPECT_LE(judgement.signed_depth_low, 0.6);
  EXPECT_GE(judgement.signed_depth_high, 0.6);
  EXPECT_EQ(judgement.error, expected.error);
  EXPECT_EQ(judgement.error_ulps, expected.error_ulps);
  EXPECT_EQ(judgement.error_relative, expected.error_relative);
  EXPECT_EQ(judgement.error_u_r, expected.error_u_r);
  EXPECT_EQ(judgement.separating_distance_low, judgement.signed_depth_low);
  EXPECT_EQ(judgement.separating_distance_high, judgement.signed_depth_high);
  EXPECT_EQ(judgement.exit_distance, 0.6);
  EXPECT_EQ(judgement.inconsistency, expected.inconsistency);
  EXPECT_TRUE(std::isnan(judgement.overlap_left));
  EXPECT_EQ(judgement.witness_a_low, 0.25);
  EXPECT_EQ(judgement.witness_a_high, 0.25);
  EXPECT_EQ(judgement.witness_b_high, 0);
  EXPECT_EQ(judgement.witness_gap, expected.witness_gap);
  EXPECT_EQ(sentence, expected.sentence);
}

TEST_F(CJudge, Conventions) {
  claims(-0.6, 1, 0, 0);
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_WRONG_SIGN);
  claim.depth_negative = claim.moves_b = 1;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.accuracy, FATHOM_CORRECTLY_ROUNDED);
  claim.direction[0] = 7;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_NOT_A_DIRECTION);
  claim.not_unit = 1;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  claim.tol_relative = claim.tol_absolute = 0;
  claim.precision = FATHOM_BINARY32;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);  // within half an ulp
  claim.depth -= 0x1p-24;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_DEEP);
  claim.tol_ulps = 2;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.signed_depth, 1 - static_cast<double>(0.4F));
}

TEST_F(CJudge, Touching) {
  b = body_of(cube_at(1));
  claim.touching = FATHOM_TOUCHING_IS_OVERLAP;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_FALSE_SEPARATION);
  EXPECT_EQ(judgement.status, FATHOM_TOUCHING);
  claim.touching = FATHOM_TOUCHING_IS_APART;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOUCHING_BY_CONVENTION);
  EXPECT_TRUE(fathom_verdict_passes(judgement.verdict));
}

TEST_F(CJudge, Shapes) {
  a = shape_of("sphere:r=1");
  b = shape_of("capsule:r=1,h=1,at=1:1:0");
  claims(0.5858, -1, -1, 0);
  claim.not_unit = 1;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.status, FATHOM_PENETRATING);
  EXPECT_EQ(judgement.signed_depth, round_binary64(Surd{2, -2}));
  EXPECT_TRUE(std::isnan(judgement.exit_distance));
  EXPECT_LE(judgement.separating_distance_low, judgement.signed_depth);
  EXPECT_GE(judgement.separating_distance_high, judgement.signed_depth);
  claim.depth = 0.7;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_DEEP);
  EXPECT_NE(sentence.find("too deep"), std::string::npos) << sentence;
  EXPECT_EQ(fathom_judge(a.get(), b.get(), &claim, &judgement, nullptr), FATHOM_OK);
}

// The bar stands in the slot of the block, as wide as it: 1 deep in one wall, and out by a
// translation that fits exactly.
TEST_F(CJudge, Unions) {
  a = bar();
  b = block();
  claims(1, 1, 0, 0);
  ASSERT_EQ(run(), FATHOM_OK) << fathom_last_error();
  const Pieces plate{box({1, 1, 2}, {3, 3, 6})};
  const Pieces walls{box({0, 0, 0}, {2, 4, 4}), box({4, 0, 0}, {6, 4, 4}), box({2, 0, 0}, {4, 4, 1})};
  Reply reply;
  reply.overlap = true;
  reply.depth = 1;
  reply.direction = Triple{1, 0, 0};
  const Judgement expected = judge(truth_about(plate, walls), reply);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(sentence, expected.sentence);
  EXPECT_EQ(judgement.status, FATHOM_PENETRATING);
  EXPECT_EQ(judgement.signed_depth, 1);
  EXPECT_EQ(judgement.accuracy, FATHOM_CORRECTLY_ROUNDED);
  EXPECT_EQ(judgement.inconsistency, expected.inconsistency);
  EXPECT_TRUE(std::isnan(judgement.separating_distance_low) && std::isnan(judgement.exit_distance) &&
              std::isnan(judgement.relative_excess));
  ASSERT_TRUE(expected.bounds);
  EXPECT_EQ(judgement.deepest_pair, root_binary64(expected.bounds->deepest_pair));
  EXPECT_EQ(judgement.deepest_pieces[0], expected.bounds->a);
  EXPECT_EQ(judgement.deepest_pieces[1], expected.bounds->b);
  EXPECT_EQ(judgement.hulls, root_binary64(expected.bounds->hulls));
  EXPECT_EQ(judgement.deeper_than_pair, 1);
  EXPECT_EQ(judgement.deeper, 1);
  claim.depth = 0.5;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_SHALLOW);
  EXPECT_EQ(judgement.deeper, 2);
  EXPECT_EQ(judgement.overlap_left, 0.5);
  b = body_of(cube_at(0.4));
  a = body_of(cube_at(0));
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_TRUE(std::isnan(judgement.deepest_pair) && std::isnan(judgement.hulls) && std::isnan(judgement.deeper))
      << "of polytopes";
}

// The cubes meet in x from 0.4 to 1, and are 1 high.
TEST_F(CJudge, ClaimsOfSeparation) {
  claims(1, 0, 0, 1);
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_DEEP);
  EXPECT_FALSE(judgement.excess_allowed);
  claim.separating = 1;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_TRUE(judgement.excess_allowed);
  EXPECT_NEAR(judgement.relative_excess, 2.0 / 3, 1e-15);
  for (const auto& [policy, most, verdict] : {std::tuple{FATHOM_POLICY_MINIMUM, 9.0, FATHOM_VERDICT_TOO_DEEP},
                                              std::tuple{FATHOM_POLICY_SEPARATING, 0.0, FATHOM_VERDICT_PASS},
                                              std::tuple{FATHOM_POLICY_WITHIN, 0.5, FATHOM_VERDICT_TOO_DEEP},
                                              std::tuple{FATHOM_POLICY_WITHIN, 0.75, FATHOM_VERDICT_PASS}}) {
    claim.policy = policy;
    claim.policy_most = most;
    ASSERT_EQ(run(), FATHOM_OK);
    EXPECT_EQ(judgement.verdict, verdict) << policy << ' ' << most;
  }
}

// The answer of a subject that sees binary32 points and calculates in binary64 is right to an ulp
// of that.
TEST_F(CJudge, AnswersOfAnotherPrecision) {
  claims(0.6, -1, 0, 0);
  claim.tol_relative = claim.tol_absolute = 0;
  claim.precision = FATHOM_BINARY32;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  claim.answers = FATHOM_BINARY64;  // 1 - 0.4F is not 0.6
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_DEEP);
  claim.depth = 1 - static_cast<double>(0.4F);
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.accuracy, FATHOM_CORRECTLY_ROUNDED);
}

TEST_F(CJudge, Contacts) {
  claims(0.6, -1, 0, 0);
  const double positions[] = {0.5, 0.5, 0.5, 1.25, 0.5, 0.5}, depths[] = {0.125, 0.6};
  claim.contact_positions = positions;
  claim.contact_depths = depths;
  claim.contact_count = 1;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_INCONSISTENT | 1U << FATHOM_VERDICT_CONTACT_TOO_SHALLOW);
  EXPECT_EQ(judgement.deepest, 0.125 - 0.6);
  EXPECT_EQ(judgement.contact_a_high, 0);
  claim.contact_count = 2;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_WITNESS_OFF | 1U << FATHOM_VERDICT_CONTACT_TOO_SHALLOW);
  EXPECT_EQ(judgement.contact_a_low, 0.25);
  EXPECT_EQ(judgement.contact_a_high, 0.25);
  claim.contact_depths = nullptr;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_WITNESS_OFF);
  EXPECT_TRUE(std::isnan(judgement.deepest));
  claim.contact_count = 1;
  claim.has_manifold = claim.most_contacts = 1;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS) << "one contact promises no extent";
  claim.most_contacts = 0;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_MISSES_EXTENT);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_MISSES_EXTENT);
  const double at_an_edge[] = {0.7, 1, 0.5};
  claim.contact_positions = at_an_edge;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_MISSES_EXTENT | 1U << FATHOM_VERDICT_TIPS);
}

TEST_F(CJudge, Distances) {
  b = body_of(cube_at(1.5));
  claim.has_distance = 1;
  claim.distance = 0.5;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.accuracy, FATHOM_CORRECTLY_ROUNDED);
  claim.distance = 0.75;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_TOO_FAR);
  EXPECT_EQ(judgement.error, 0.25);
  EXPECT_EQ(sentence, "too far by 0.25: 0.75 is claimed, the distance is 0.5");
  claim.distance = 0.25;
  ASSERT_EQ(run(), FATHOM_OK);
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_TOO_NEAR);
}

TEST_F(CJudge, RefusesWhatIsNoClaim) {
  const fathom_claim good = claim;
  const auto with = [&](auto change) {
    claim = good;
    change();
    expect_refused();
  };
  with([&] { claim.size = 8; });
  with([&] { claim.precision = 2; });
  with([&] { claim.touching = 3; });
  with([&] { claim.touching = -1; });
  with([&] { claim.tol_relative = -1; });
  with([&] { claim.tol_absolute = std::nan(""); });
  with([&] { claim.tol_ulps = 0.5; });
  with([&] { claim.tol_ulps = std::numeric_limits<double>::infinity(); });
  with([&] {
    b = body_of({1e300, 0, 0});
    claim.precision = FATHOM_BINARY32;
  });
  with([&] { claim.answers = 2; });
  with([&] { claim.answers = -2; });
  with([&] { claim.policy = 4; });
  with([&] { claim.policy = -1; });
  with([&] { claim.policy_most = -0.5; });
  with([&] { claim.contact_count = 1; });
  with([&] {
    claim.has_manifold = 1;
    claim.contact_margin = -0.5;
  });
  with([&] { b = nullptr; });
  EXPECT_EQ(fathom_judge(a.get(), a.get(), nullptr, &judgement, nullptr), FATHOM_BAD_INPUT);
  EXPECT_EQ(fathom_judge(a.get(), a.get(), &good, nullptr, nullptr), FATHOM_BAD_INPUT);
  judgement.size = 0;
  EXPECT_EQ(fathom_judge(a.get(), a.get(), &good, &judgement, nullptr), FATHOM_BAD_INPUT);
  fathom_claim_init(nullptr);
  fathom_judgement_init(nullptr);
}

TEST(CJudgeNames, AreThoseOfCpp) {
  std::set<std::string> names;
  for (int i = 0; i <= FATHOM_VERDICT_WRONG_DERIVATIVE; ++i) {
    const std::optional<Verdict> verdict = verdict_named(fathom_verdict_name(i));
    ASSERT_TRUE(verdict) << i;
    EXPECT_EQ(fathom_verdict_passes(i) != 0, passes(*verdict));
    EXPECT_TRUE(names.insert(fathom_verdict_name(i)).second) << i;
  }
  EXPECT_STREQ(fathom_verdict_name(FATHOM_VERDICT_NOT_SEPARATING), "not-separating");
  EXPECT_EQ(fathom_verdict_name(-1), nullptr);
  EXPECT_STREQ(fathom_verdict_name(FATHOM_VERDICT_PASS), "pass");
  EXPECT_STREQ(fathom_verdict_name(FATHOM_VERDICT_TOO_NEAR), "too-near");
  EXPECT_STREQ(fathom_verdict_name(FATHOM_VERDICT_WRONG_DERIVATIVE), "wrong-derivative");
  EXPECT_EQ(fathom_verdict_name(FATHOM_VERDICT_WRONG_DERIVATIVE + 1), nullptr);
  EXPECT_FALSE(fathom_verdict_passes(-1));
}

}  // namespace
}  // namespace fathom
