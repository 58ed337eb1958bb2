// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a run: counts, errors, what has a column, and how wide it gets.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "tests/harness/report/outcomes.hpp"
#include "tests/support/property.hpp"
#include "verify/harness/report/reports.hpp"

namespace fathom::harness {
namespace {

using testing::judged_outcome;
using testing::outcome;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> row(const std::string& table, const std::string& label) {
  for (const std::string& line : lines_of(table))
    if (line.starts_with(label + " ")) return words(line);
  return {};
}

using Words = std::vector<std::string>;

TEST(Errors, WorstKeepsItsSignAndMedianIsOfMagnitudes) {
  Errors errors;
  errors.add(0.5);
  EXPECT_EQ(errors.worst(), 0.5);
  EXPECT_EQ(errors.median(), 0.5);
  errors.add(-2);
  errors.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(errors.worst(), -2);
  EXPECT_EQ(errors.median(), 0.5) << "the lower of two";
  errors.add(2);
  errors.add(-1);
  EXPECT_EQ(errors.worst(), 2) << "of equal magnitudes the positive one";
  EXPECT_EQ(errors.median(), 1);
  errors.add(-std::numeric_limits<double>::infinity());
  EXPECT_EQ(errors.worst(), -std::numeric_limits<double>::infinity());
}

TEST(Summary, Table) {
  Summary summary;
  summary.add(judged_outcome("cubes::1", Verdict::pass, 0, 0));
  summary.add(judged_outcome("cubes::2", Verdict::too_deep, 0.25, 1e12));
  summary.add(judged_outcome("cubes::3", Verdict::too_shallow, -0.5, -2e12));
  summary.add(judged_outcome("balls-n8-s1", Verdict::pass, 1e-16, 0.5));
  summary.add(outcome("balls-n8-s2", Verdict::unsupported));
  summary.add(outcome("alone", Verdict::crash));
  summary.add(outcome("cubes::1", Verdict::not_invariant, "swap"));
  EXPECT_EQ(summary.total(), 7u);
  EXPECT_EQ(summary.passes(), 2u);
  EXPECT_EQ(summary.failures(), 4u);

  const std::string table = summary.table(testing::judged_subject());
  const auto lines = lines_of(table);
  EXPECT_EQ(lines[0], "demo 2.1 (libccd, binary64)");
  EXPECT_EQ(lines[1],
            "conventions  bodies that touch are either; the depth is positive; A moves; directions have length 1");
  EXPECT_EQ(lines[2], "settings     epa_tolerance = 1e-4; max_iterations = 1000");
  // cases, pass, crash, too-deep, too-shallow, not-invariant, unsupported; worst and median,
  // relative and in uR
  EXPECT_EQ(row(table, "cubes"),
            (Words{"cubes", "3", "1", ".", "1", "1", ".", ".", "-0.5", "0.25", "-2e+12", "1e+12"}));
  EXPECT_EQ(row(table, "balls"), (Words{"balls", "2", "1", ".", ".", ".", ".", "1", "1e-16", "1e-16", "0.5", "0.5"}));
  EXPECT_EQ(row(table, "(no"), (Words{"(no", "family)", "1", ".", "1", ".", ".", ".", ".", ".", ".", ".", "."}));
  EXPECT_EQ(row(table, "~swap"), (Words{"~swap", "1", ".", ".", ".", ".", "1", ".", ".", ".", ".", "."}));
  EXPECT_EQ(row(table, "all"), (Words{"all", "7", "2", "1", "1", "1", "1", "1", "-0.5", "1e-16", "-2e+12", "0.5"}));
  EXPECT_EQ(lines.back(), "7 cases: 2 pass, 4 fail, 1 unsupported");
  EXPECT_EQ(table.find("overlap\n"), std::string::npos) << "only verdicts that occur have a column";
  EXPECT_EQ(table.find("time-"), std::string::npos);
}

TEST(Summary, ClassesOfPasses) {
  Summary summary;
  for (const Accuracy accuracy : {Accuracy::millionth, Accuracy::correctly_rounded, Accuracy::correctly_rounded}) {
    Outcome passed = judged_outcome("a::1", Verdict::pass, 0, 0);
    passed.judgement->accuracy = accuracy;
    summary.add(passed);
  }
  EXPECT_NE(summary.table({}).find("\npasses       correctly rounded: 2; 1e-6: 1\njudged       overlap in 0 of 3 "
                                   "cases\nwords        relative: "),
            std::string::npos);
}

Outcome answered(bool overlap, bool depth, bool direction, bool witness_b) {
  Outcome result = judged_outcome("a::1", Verdict::pass, 0, 0);
  result.reply = Reply();
  result.reply->overlap = overlap;
  result.reply->witness_a = Triple{};
  if (depth) (overlap ? result.reply->depth : result.reply->distance) = 1;
  if (direction) result.reply->direction = Triple{1, 0, 0};
  if (witness_b) result.reply->witness_b = Triple{};
  return result;
}

// What no depth stands beside is not judged, and neither is half a pair of points. Of bodies that
// are said to be apart a distance counts.
TEST(Summary, WhatWasJudged) {
  Summary summary;
  EXPECT_EQ(coverage_warning(summary.tally().all().judged), "");
  for (const Outcome& each :
       {answered(true, false, true, true), answered(true, false, false, false), answered(false, false, true, true)})
    summary.add(each);
  EXPECT_TRUE(coverage_warning(summary.tally().all().judged).starts_with("depth judged 0 of 2: "))
      << "of those that overlap";
  EXPECT_NE(
      summary.table({}).find(
          "\njudged       overlap in 3 of 3 cases; depth in 0 of 2 said to overlap; direction in 0; witness in 0\n"),
      std::string::npos);
  for (const Outcome& each : {answered(true, true, true, false), answered(true, true, false, true)}) summary.add(each);
  summary.add(outcome("a::2", Verdict::crash));
  EXPECT_NE(
      summary.table({}).find(
          "\njudged       overlap in 5 of 6 cases; depth in 2 of 4 said to overlap; direction in 1; witness in 1\n"),
      std::string::npos);
  summary.add(answered(false, true, true, true));
  EXPECT_NE(summary.table({}).find(
                "\njudged       overlap in 6 of 7 cases; distance in 1 of 2 said to be apart; depth in 2 of 4 said to "
                "overlap; direction in 1; witness in 1\n"),
            std::string::npos);
  EXPECT_EQ(coverage_warning(summary.tally().all().judged), "");
  Outcome moving = answered(true, true, false, false);
  moving.judgement->derivative.emplace().claimed = std::numeric_limits<double>::quiet_NaN();
  Tally of_none, of_one;
  of_none.add(moving);
  EXPECT_EQ(of_none.all().judged.derivative, 0u) << "no number has no truth beside it";
  moving.judgement->derivative->squared = 4;
  of_one.add(moving);
  EXPECT_EQ(of_one.all().judged.derivative, 1u);
  Outcome manifold = answered(true, true, true, false);
  manifold.reply->contacts = {{{1, 2, 3}, {}}, {{1, 2, 4}, {}}};
  summary.add(manifold);
  EXPECT_NE(summary.table({}).find("contacts in 1\n"), std::string::npos);
  EXPECT_EQ(summary.table({}).find("wrong in"), std::string::npos);
  using enum Verdict;
  for (const std::vector<Verdict>& findings : {std::vector{witness_off, contact_too_deep, tips}, {tips}}) {
    manifold.judgement->findings = findings;
    summary.add(manifold);
  }
  EXPECT_NE(summary.table({}).find("\ncontacts     wrong in 2 answers; contact-too-deep in 1; tips in 2\n"),
            std::string::npos);
}

// Rows of parts stand below that of all, unless a part is empty or is all.
TEST(Summary, SolidAndMetreSizedCasesApart) {
  Summary summary;
  const auto add = [&](bool solid, bool metre_sized, double relative_excess) {
    Outcome each = judged_outcome("a::1", Verdict::pass, 0, 0);
    each.solid = solid;
    each.metre_sized = metre_sized;
    each.judgement->relative_excess = relative_excess;
    each.judgement->excess_allowed = relative_excess > 0.2;
    summary.add(each);
  };
  add(true, true, 0.125);
  EXPECT_EQ(summary.table({}).find("solid"), std::string::npos);
  add(false, true, 0.25);
  add(false, true, 0);
  const std::string table = summary.table({});
  EXPECT_NE(table.find("\nall         3"), std::string::npos) << table;
  EXPECT_NE(table.find("\nsolid       1"), std::string::npos) << table;
  EXPECT_EQ(table.find("\nmetre-sized"), std::string::npos) << "as many as all";
  EXPECT_NE(table.find("\nboth        1"), std::string::npos) << table;
  EXPECT_NE(table.find("excess       median 0.125 above the depth, worst 0.25, of 3 directions; 1 longer translation "
                       "passes by the policy\n"),
            std::string::npos)
      << table;
}

TEST(Summary, WorstFailuresByName) {
  const std::vector<Outcome> outcomes{judged_outcome("a", Verdict::too_deep, 0.1, 1),
                                      judged_outcome("b", Verdict::pass, 9, 1),
                                      judged_outcome("c", Verdict::too_deep, -0.5, 1),
                                      judged_outcome("d", Verdict::too_deep, 0.5, 1),
                                      outcome("e", Verdict::crash, "swap"),
                                      outcome("f", Verdict::unsupported)};
  Summary summary;
  for (const Outcome& each : outcomes) summary.add(each);
  const std::string table = summary.table({}, outcomes, {"here", "there"});
  EXPECT_NE(table.find("\n  crash             e ~swap\n  too-deep          c; d; a\nsee          here; there\n"),
            std::string::npos)
      << table;
  EXPECT_EQ(Summary().table({}, {}, {"here"}).find("here"), std::string::npos) << "nothing failed";
}

TEST(Summary, WhatIsNoCasesFault) {
  Summary summary;
  summary.add(judged_outcome("a::1", Verdict::pass, 0, 0));
  for (const char* detail : {"wrote 'x'", "killed", "wrote 'x'"}) summary.add(Unattributed{"a::1", detail});
  EXPECT_EQ(summary.unattributed(), 3u);
  EXPECT_NE(summary.table({}).find("\nunattributed 1 x killed; 2 x wrote 'x'\nwords "), std::string::npos)
      << summary.table({});
}

TEST(Summary, OfNothing) {
  const std::string table = Summary().table(testing::judged_subject());
  EXPECT_EQ(row(table, "all"), (Words{"all", "0"}));
  EXPECT_EQ(lines_of(table).back(), "0 cases: 0 pass, 0 fail");
}

// All verdicts, long names, hostile bytes, many families: 140 columns of ASCII, every count once,
// the errors in one block.
TEST(Summary, NeverWiderThanItMay) {
  Summary summary;
  SubjectInfo subject = testing::judged_subject();
  subject.name = testing::hostile();
  for (int i = 0; i < 40; ++i)
    subject.settings["setting" + std::to_string(i)] = std::string(static_cast<std::size_t>(i * 7), 'x');
  for (std::size_t i = 0; i < verdict_count; ++i)
    summary.add(judged_outcome(testing::hostile() + std::to_string(i) + std::string(i * 4, 'f') + "::1",
                               static_cast<Verdict>(i), -1.25e-300, 1e300));
  for (int i = 0; i < 300; ++i)
    summary.add(judged_outcome("family" + std::to_string(i) + "::1", Verdict::pass,
                               std::numeric_limits<double>::infinity(), 0));
  const std::string table = summary.table(subject), all = summary.table(subject, {}, {}, 140, true);
  EXPECT_EQ(table.find("\nfamily299"), std::string::npos);
  EXPECT_NE(all.find("\nfamily299"), std::string::npos);
  int errors = 0, blocks = 0;
  for (const std::string& line : lines_of(table)) {
    EXPECT_LE(line.size(), 140u) << line;
    for (const char c : line) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << line;
    if (line.starts_with("family ") && line.ends_with(" in uR")) errors += line.find(" relative") != std::string::npos;
    if (line.starts_with("301 families pass") || line.starts_with("302 families pass")) ++blocks;
  }
  EXPECT_EQ(errors, 1) << table;
  EXPECT_GE(blocks, 2);
  EXPECT_EQ(lines_of(table).back(), "327 cases: 302 pass, 24 fail, 1 unsupported");
}

// Which failures the page shows in full.

using Outcomes = std::vector<Outcome>;

TEST(FailuresToShow, WorstFirstAndOneOfEachVerdictAndFamily) {
  Outcomes outcomes;
  for (int i = 1; i <= 50; ++i) outcomes.push_back(judged_outcome("a::" + std::to_string(i), Verdict::too_deep, i, 1));
  outcomes.push_back(judged_outcome("a::shallow", Verdict::too_shallow, -1e-3, 1));
  outcomes.push_back(judged_outcome("b::deep", Verdict::too_deep, 1e-3, 1));
  outcomes.push_back(judged_outcome("c::fine", Verdict::pass, 1e9, 1));
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
    outcomes.push_back(judged_outcome(id, Verdict::too_deep, 1, 1));
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

// The strict list of known failures: every way in which run and list can disagree is found, and a
// written list agrees with its run.

using Check = ExpectedFailures::Check;

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
  const std::string text = expected_failures_text(testing::judged_subject(), outcomes);
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
