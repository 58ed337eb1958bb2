// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a run: counts, errors, what has a column, and how wide it gets.
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

#include "tests/harness/report/outcomes.hpp"
#include "verify/harness/report/text.hpp"

namespace fathom::harness {
namespace {

using testing::judged;
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
  summary.add(judged("cubes::1", Verdict::pass, 0, 0));
  summary.add(judged("cubes::2", Verdict::too_deep, 0.25, 1e12));
  summary.add(judged("cubes::3", Verdict::too_shallow, -0.5, -2e12));
  summary.add(judged("balls-n8-s1", Verdict::pass, 1e-16, 0.5));
  summary.add(outcome("balls-n8-s2", Verdict::unsupported));
  summary.add(outcome("alone", Verdict::crash));
  summary.add(outcome("cubes::1", Verdict::not_invariant, "swap"));
  EXPECT_EQ(summary.total(), 7u);
  EXPECT_EQ(summary.passes(), 2u);
  EXPECT_EQ(summary.failures(), 4u);

  const std::string table = summary.table(testing::subject());
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
    Outcome passed = judged("a::1", Verdict::pass, 0, 0);
    passed.judgement->accuracy = accuracy;
    summary.add(passed);
  }
  EXPECT_NE(summary.table({}).find("\npasses       correctly rounded: 2; 1e-6: 1\njudged       overlap in 0 of 3 "
                                   "cases\nwords        relative: "),
            std::string::npos);
}

Outcome answered(bool overlap, bool depth, bool direction, bool witness_b) {
  Outcome result = judged("a::1", Verdict::pass, 0, 0);
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
  Outcome manifold = answered(true, true, true, false);
  manifold.reply->contacts = {{{1, 2, 3}, {}}, {{1, 2, 4}, {}}};
  summary.add(manifold);
  EXPECT_NE(summary.table({}).find("contacts in 1\n"), std::string::npos);
}

// Rows of parts stand below that of all, unless a part is empty or is all.
TEST(Summary, SolidAndMetreSizedCasesApart) {
  Summary summary;
  const auto add = [&](bool solid, bool metre_sized, double dearer) {
    Outcome each = judged("a::1", Verdict::pass, 0, 0);
    each.solid = solid;
    each.metre_sized = metre_sized;
    each.judgement->dearer = dearer;
    each.judgement->longer = dearer > 0.2;
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
  EXPECT_NE(table.find("price        median 0.125 above the depth, worst 0.25, of 3 directions; 1 longer translation "
                       "passes by the policy\n"),
            std::string::npos)
      << table;
}

TEST(Summary, WorstFailuresByName) {
  const std::vector<Outcome> outcomes{judged("a", Verdict::too_deep, 0.1, 1),  judged("b", Verdict::pass, 9, 1),
                                      judged("c", Verdict::too_deep, -0.5, 1), judged("d", Verdict::too_deep, 0.5, 1),
                                      outcome("e", Verdict::crash, "swap"),    outcome("f", Verdict::unsupported)};
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
  summary.add(judged("a::1", Verdict::pass, 0, 0));
  for (const char* detail : {"wrote 'x'", "killed", "wrote 'x'"}) summary.add(Unattributed{"a::1", detail});
  EXPECT_EQ(summary.unattributed(), 3u);
  EXPECT_NE(summary.table({}).find("\nunattributed 1 x killed; 2 x wrote 'x'\nwords "), std::string::npos)
      << summary.table({});
}

TEST(Summary, OfNothing) {
  const std::string table = Summary().table(testing::subject());
  EXPECT_EQ(row(table, "all"), (Words{"all", "0"}));
  EXPECT_EQ(lines_of(table).back(), "0 cases: 0 pass, 0 fail");
}

// All verdicts, long names, hostile bytes, many families: 140 columns of ASCII, every count once,
// the errors in one block.
TEST(Summary, NeverWiderThanItMay) {
  Summary summary;
  SubjectInfo subject = testing::subject();
  subject.name = testing::hostile();
  for (int i = 0; i < 40; ++i)
    subject.settings["setting" + std::to_string(i)] = std::string(static_cast<std::size_t>(i * 7), 'x');
  for (std::size_t i = 0; i < verdict_count; ++i)
    summary.add(judged(testing::hostile() + std::to_string(i) + std::string(i * 4, 'f') + "::1",
                       static_cast<Verdict>(i), -1.25e-300, 1e300));
  for (int i = 0; i < 300; ++i)
    summary.add(
        judged("family" + std::to_string(i) + "::1", Verdict::pass, std::numeric_limits<double>::infinity(), 0));
  const std::string table = summary.table(subject), all = summary.table(subject, {}, {}, 140, true);
  EXPECT_EQ(table.find("\nfamily299"), std::string::npos);
  EXPECT_NE(all.find("\nfamily299"), std::string::npos);
  int errors = 0, blocks = 0;
  for (const std::string& line : lines_of(table)) {
    EXPECT_LE(line.size(), 140u) << line;
    for (const char c : line) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << line;
    if (line.starts_with("family ") && line.ends_with(" in uR"))
      errors += words(line) == Words{"family", "relative", "relative", "in", "uR", "in", "uR"};
    if (line.starts_with("301 families pass") || line.starts_with("302 families pass")) ++blocks;
  }
  EXPECT_EQ(errors, 1) << table;
  EXPECT_GE(blocks, 2);
  EXPECT_EQ(lines_of(table).back(), "321 cases: 302 pass, 18 fail, 1 unsupported");
}

}  // namespace
}  // namespace fathom::harness
