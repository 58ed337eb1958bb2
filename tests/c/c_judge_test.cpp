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

  BodyHandle a = body_of(cube_at(0)), b = body_of(cube_at(0.4));
  fathom_claim claim;
  fathom_judgement judgement;
};

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
