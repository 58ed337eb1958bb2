// SPDX-License-Identifier: GPL-3.0-or-later
// The strict list of known failures: every way in which run and list can disagree is found, and a
// written list agrees with its run.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "fathom/files.hpp"
#include "tests/harness/report/outcomes.hpp"
#include "tests/support/property.hpp"
#include "verify/harness/report/junit.hpp"

namespace fathom::harness {
namespace {

using testing::outcome;
using Check = ExpectedFailures::Check;
using Outcomes = std::vector<Outcome>;

Check check(const std::string& list, const Outcomes& outcomes) {
  return ExpectedFailures::parse(list, "known").check(outcomes);
}

std::string refusal(const std::string& list) {
  try {
    (void)ExpectedFailures::parse(list, "known");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

using Sentences = std::vector<std::string>;

TEST(ExpectedFailures, AgreesWithWhatItLists) {
  const Check result =
      check("# why\n\n  too-deep a::1 # known upstream\r\nnot-invariant\ta::1~swap\ncrash b",
            {outcome("a::1", Verdict::too_deep), outcome("a::1", Verdict::not_invariant, "swap"),
             outcome("a::2", Verdict::pass), outcome("b", Verdict::crash), outcome("c", Verdict::unsupported)});
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.allowed, (std::set<std::string>{"crash b", "not-invariant a::1~swap", "too-deep a::1"}));
}

TEST(ExpectedFailures, ANewlyPassingEntryFails) {
  const Check result = check("\ntoo-deep a\n", {outcome("a", Verdict::pass)});
  EXPECT_EQ(result.surprises, Sentences{"known:2: a is listed as too-deep, but passes now: strike it off the list"});
  EXPECT_EQ(std::tuple(result.fixed, result.changed, result.unlisted, result.unmet), std::tuple(1, 0, 0, 0));
  EXPECT_TRUE(result.allowed.empty());
  EXPECT_TRUE(result.fixed_keys.contains("a"));
  EXPECT_FALSE(check("too-deep a\n", {outcome("a", Verdict::touching_by_convention)}).ok());
}

TEST(ExpectedFailures, AnotherVerdictFails) {
  EXPECT_EQ(check("too-deep a", {outcome("a", Verdict::too_shallow)}).surprises,
            Sentences{"known:1: a is listed as too-deep, but is too-shallow now"});
  EXPECT_EQ(check("too-deep a", {outcome("a", Verdict::unsupported)}).changed, 1u);
}

TEST(ExpectedFailures, AnUnlistedFailureFails) {
  EXPECT_EQ(check("", {outcome("a", Verdict::nan)}).surprises, Sentences{"a is nan, and is not listed"});
  EXPECT_EQ(check("nan a", {outcome("a", Verdict::nan), outcome("a", Verdict::nan, "swap")}).surprises,
            Sentences{"a~swap is nan, and is not listed"});
  EXPECT_TRUE(check("", {outcome("a", Verdict::pass), outcome("b", Verdict::unsupported)}).ok());
}

TEST(ExpectedFailures, AnEntryThatNoCaseMetFails) {
  const Check result = check("too-deep a\n", {outcome("b", Verdict::pass)});
  EXPECT_EQ(result.surprises, Sentences{"known:1: a is listed as too-deep, but no such case was run"});
  EXPECT_EQ(result.unmet_lines, Sentences{"too-deep a"});
  EXPECT_EQ(check("too-deep a\n", {}).unmet, 1u);
}

TEST(ExpectedFailures, RepeatedIdsAreCounted) {
  const Outcomes both{outcome("a", Verdict::too_deep), outcome("a", Verdict::nan)};
  EXPECT_TRUE(check("nan a\ntoo-deep a\n", both).ok());
  EXPECT_EQ(check("nan a\n", both).unlisted, 1u);
  EXPECT_EQ(check("nan a\nnan a\n", both).changed, 1u);
  EXPECT_EQ(check("nan a\ntoo-deep a\nnan a\n", both).unmet, 1u);
  EXPECT_EQ(check("nan a\n", {outcome("a", Verdict::pass), outcome("a", Verdict::crash)}).surprises,
            Sentences{"known:1: a is listed as nan, but is crash now"})
      << "held against the other failure, not against the pass";
  const Check one = check("nan a\nnan a\n", {outcome("a", Verdict::nan), outcome("a", Verdict::pass)});
  EXPECT_EQ(std::pair(one.fixed, one.surprises.size()), (std::pair<std::size_t, std::size_t>(1, 1)));
}

TEST(ExpectedFailures, LinesThatAreNone) {
  EXPECT_EQ(refusal("# fine\nwrong a"), "known:2: expected a verdict, as in 'too-deep case-7', found 'wrong'");
  EXPECT_EQ(refusal("pass a"), "known:1: 'pass' is no failure");
  EXPECT_EQ(refusal("unsupported a"), "known:1: 'unsupported' is no failure");
  EXPECT_EQ(refusal("nan  # an id is missing"), "known:1: expected the id of a case after 'nan'");
  EXPECT_EQ(refusal("nan an id"),
            "known:1: expected nothing but a comment after the id, found 'id'; a blank in an id is %20");
  for (const std::string id : {"a%", "a%2", "a%2g", "%%", "a~b~c", "a\x01", "~%"})
    EXPECT_EQ(refusal("nan " + id).empty(), id == "~%") << id;
  EXPECT_EQ(refusal(""), "");
}

TEST(ExpectedFailures, EscapesAreOneIdHoweverWritten) {
  EXPECT_TRUE(check("nan a%20b%7Ec", {outcome("a b~c", Verdict::nan)}).ok());
  EXPECT_TRUE(check("nan %61", {outcome("a", Verdict::nan)}).ok());
  EXPECT_TRUE(check("nan %", {outcome("", Verdict::nan)}).ok());
  EXPECT_TRUE(check("nan %23a#b", {outcome("#a#b", Verdict::nan)}).ok());
  EXPECT_EQ(failure_line(outcome("a b", Verdict::nan, "swap")), "nan a%20b~swap");
  EXPECT_EQ(failure_key(outcome("x~y", Verdict::nan)), "x%7ey") << "no variant";
}

TEST(ExpectedFailures, WhatIsWrittenAgrees) {
  const Outcomes outcomes{outcome("b", Verdict::nan),
                          outcome("a", Verdict::too_deep),
                          outcome("a", Verdict::not_invariant, "swap"),
                          outcome("c", Verdict::pass),
                          outcome(testing::hostile(), Verdict::crash),
                          outcome("", Verdict::silent)};
  const std::string text = expected_failures_text(testing::subject(), outcomes);
  EXPECT_TRUE(text.starts_with("# Known failures of demo 2.1 (libccd, binary64), for fathom certify --expect-fail."));
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 5);
  EXPECT_LT(text.find("not-invariant a~swap\n"), text.find("too-deep a\n")) << "sorted";
  const Check result = check(text, outcomes);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.surprises.front());
  EXPECT_EQ(result.allowed.size(), 5u);
}

TEST(ExpectedFailures, AnyRunAgreesWithItsList) {
  EXPECT_TRUE(holds({.seed = 72, .runs = 1000}, [] {
    Outcomes outcomes;
    for (const auto& [id, rank] : *rc::gen::container<std::vector<std::pair<std::string, int>>>(
             rc::gen::pair(rc::gen::arbitrary<std::string>(), rc::gen::inRange(0, 19))))
      outcomes.push_back(outcome(id, static_cast<Verdict>(rank), rank % 3 == 0 ? id : ""));
    RC_ASSERT(check(expected_failures_text({}, outcomes), outcomes).ok());
    if (outcomes.empty()) return;
    Outcomes other = outcomes;
    other.back().verdict = fails(other.back().verdict) ? Verdict::pass : Verdict::crash;
    RC_ASSERT(!check(expected_failures_text({}, outcomes), other).ok());
  }));
}

TEST(ExpectedFailures, Files) {
  const std::string path = ::testing::TempDir() + "fathom_expect_fail_test.txt";
  std::ofstream(path) << "nan a\n";
  EXPECT_EQ(ExpectedFailures::read(path).size(), 1u);
  std::remove(path.c_str());
  EXPECT_THROW((void)ExpectedFailures::read(path), InputError);
  EXPECT_THROW((void)ExpectedFailures::read(::testing::TempDir()), InputError);
}

}  // namespace
}  // namespace fathom::harness
