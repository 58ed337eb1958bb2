// SPDX-License-Identifier: GPL-3.0-or-later
// Which failures the page shows in full.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/harness/report/outcomes.hpp"
#include "verify/harness/report/html.hpp"

namespace fathom::harness {
namespace {

using testing::judged;
using testing::outcome;
using Outcomes = std::vector<Outcome>;

TEST(FailuresToShow, WorstFirstAndOneOfEachVerdictAndFamily) {
  Outcomes outcomes;
  for (int i = 1; i <= 50; ++i) outcomes.push_back(judged("a::" + std::to_string(i), Verdict::too_deep, i, 1));
  outcomes.push_back(judged("a::shallow", Verdict::too_shallow, -1e-3, 1));
  outcomes.push_back(judged("b::deep", Verdict::too_deep, 1e-3, 1));
  outcomes.push_back(judged("c::fine", Verdict::pass, 1e9, 1));
  outcomes.push_back(outcome("a::dead", Verdict::crash));
  const auto shown = failures_to_show(outcomes, 6);
  EXPECT_EQ(shown, (std::vector<std::size_t>{53, 49, 48, 47, 50, 51}));
  EXPECT_EQ(failures_to_show(outcomes).size(), 53u);
  EXPECT_EQ(failures_to_show(outcomes, 0).size(), 0u);
}

TEST(FailuresToShow, DoNotDependOnTheOrderInWhichAnswersCame) {
  Outcomes outcomes;
  for (const char* id : {"a::1", "a::2", "b::1", "b::2"}) {
    outcomes.push_back(outcome(id, Verdict::crash));
    outcomes.push_back(judged(id, Verdict::too_deep, 1, 1));
  }
  const auto shown = [&] {
    std::vector<std::pair<std::string, Verdict>> result;
    for (const std::size_t i : failures_to_show(outcomes, 5)) result.emplace_back(outcomes[i].id, outcomes[i].verdict);
    return result;
  };
  const auto before = shown();
  EXPECT_EQ(before.front(), std::pair(std::string("a::1"), Verdict::crash));
  std::ranges::reverse(outcomes);
  EXPECT_EQ(shown(), before);
}

}  // namespace
}  // namespace fathom::harness
