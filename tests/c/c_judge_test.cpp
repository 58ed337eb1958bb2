// SPDX-License-Identifier: GPL-3.0-or-later
// The judge for C refuses what is no claim, and has the names of C++. What it gives of claims is
// compared with what C++ gives in tests/doors/judged_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include "fathom/judge.hpp"
#include "tests/c/handles.hpp"

namespace fathom {
namespace {

using namespace testing;  // handles

class CJudge : public ::testing::Test {
 protected:
  CJudge() {
    fathom_claim_init(&claim);
    fathom_judgement_init(&judgement);
  }
  void expect_refused() {
    char* text = nullptr;
    EXPECT_EQ(fathom_judge(a.get(), b.get(), &claim, &judgement, &text), FATHOM_BAD_INPUT);
    EXPECT_EQ(text, nullptr);
    EXPECT_EQ(judgement.verdict, -1);
    EXPECT_TRUE(std::isnan(judgement.error));
    EXPECT_GT(std::strlen(fathom_last_error()), 5U);
  }

  // Judges that the cubes are 0.6 deep, to the left; the sentence.
  std::string judged() {
    claim.overlap = claim.has_depth = claim.has_direction = 1;
    claim.depth = 0.6;
    claim.direction[0] = -1;
    char* text = nullptr;
    EXPECT_EQ(fathom_judge(a.get(), b.get(), &claim, &judgement, &text), FATHOM_OK) << fathom_last_error();
    std::string sentence = text ? text : "";
    fathom_text_free(text);
    return sentence;
  }

  BodyHandle a = body_of(cube_at(0)), b = body_of(cube_at(0.4));
  fathom_claim claim;
  fathom_judgement judgement;
};

TEST_F(CJudge, ContactsBesideThePatchWithSlack) {
  const double positions[] = {0.7, 0, 0, 0.7, 0, 1, 0.7, 0.5, 0, 0.7, 0.5, 1};
  claim.contact_positions = positions;
  claim.contact_count = 4;
  judged();
  EXPECT_TRUE(std::isnan(judgement.extent_missed) && std::isnan(judgement.extent_covered)) << "nobody asked";
  claim.has_patch_slack = 1;
  judged();
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS) << "a measure blames nobody";
  EXPECT_EQ(judgement.extent_missed, 0.5);
  EXPECT_EQ(judgement.extent_covered, 0.5);
}

TEST_F(CJudge, Derivatives) {
  claim.has_derivative = 1;
  claim.derivative = 2;
  claim.twist_a[0] = 3;
  claim.twist_b[0] = 1;
  judged();
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_EQ(judgement.derivative, 2);
  EXPECT_EQ(judgement.derivative_error, 0);
  claim.derivative = -1;
  const std::string sentence = judged();
  EXPECT_EQ(judgement.findings, 1U << FATHOM_VERDICT_WRONG_DERIVATIVE);
  EXPECT_EQ(judgement.derivative_error, -3);
  EXPECT_NE(sentence.find("the derivative is wrong by 3"), std::string::npos) << sentence;
  claim.has_derivative = 0;
  judged();
  EXPECT_EQ(judgement.verdict, FATHOM_VERDICT_PASS);
  EXPECT_TRUE(std::isnan(judgement.derivative));
}

TEST_F(CJudge, RefusesWhatIsNoClaim) {
  const fathom_claim good = claim;
  EXPECT_EQ(fathom_judge(a.get(), b.get(), &good, &judgement, nullptr), FATHOM_OK) << "the sentence need not be wanted";
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
  with([&] {
    claim.has_patch_slack = 1;
    claim.patch_slack = -0.5;
  });
  with([&] {
    claim.has_derivative = 1;
    claim.twist_b[5] = std::nan("");
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
