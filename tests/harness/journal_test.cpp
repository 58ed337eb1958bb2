// SPDX-License-Identifier: GPL-3.0-or-later
// A journal that was cut anywhere goes on, and loses nothing that was whole.

#include "verify/harness/journal.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {
namespace {

Outcome rich(const std::string& id) {
  Outcome outcome;
  outcome.id = id;
  outcome.variant = "swap";
  outcome.solid = outcome.metre_sized = true;
  outcome.digest = "0123456789abcdef";
  outcome.verdict = Verdict::not_invariant;
  outcome.detail = "a line\nwith \"quotes\" and \x01";
  outcome.seconds = 0.1 + 0.2;
  Reply reply;
  reply.overlap = true;
  reply.depth = std::numeric_limits<double>::quiet_NaN();
  reply.direction = {-std::numeric_limits<double>::infinity(), 5e-324, -0.0};
  reply.distance = 0.3;
  reply.contacts = {{{0, 0.1, -1}, 0.7}, {{std::numeric_limits<double>::infinity(), 1, 2}, {}}};
  reply.witness_b = {1, 2, 1.7976931348623157e308};
  outcome.reply = reply;
  Judgement j;
  j.verdict = Verdict::too_deep;
  j.findings = {Verdict::too_deep, Verdict::witness_off};
  j.accuracy = Accuracy::u_r_16;
  j.status = Status::penetrating;
  j.depth_squared = mpq_class(1, 3);
  j.distance_squared = mpq_class(2, 3);
  j.error = 0.1;
  j.error_ulps = std::numeric_limits<double>::infinity();
  j.error_relative = -1e-300;
  j.error_u_r = 3;
  j.separating_distance_squared = mpq_class(-7, 9);
  j.exit_distance_squared = mpq_class("123456789012345678901234567890");
  j.inconsistency = -0.5;
  j.overlap_left = 0.25;
  j.witness_a_squared = 0;
  j.witness_b_squared = mpq_class(1, 7);
  j.witness_gap = 2;
  j.contact_a_squared = mpq_class(4, 9);
  j.contact_b_distance = Between{0.1, 0.2};
  j.deepest = -0.125;
  j.relative_excess = 0.5;
  j.excess_allowed = true;
  j.sentence = "too deep by 0.1";
  outcome.judgement = j;
  outcome.microseconds = 2.5;
  outcome.fit = -3;
  outcome.hulls = {j, mpq_class(1, 4), mpq_class(2, 9)};
  return outcome;
}

TEST(Lines, RoundTrip) {
  Outcome bare;
  bare.id = "a::b";
  bare.digest = "0";
  bare.verdict = Verdict::crash;
  for (const Outcome& outcome : {rich("x"), bare}) {
    const std::string line = outcome_line(outcome);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const std::optional<Outcome> read = read_outcome(line);
    ASSERT_TRUE(read) << line;
    EXPECT_EQ(outcome_line(*read), line);
  }
  const Outcome read = *read_outcome(outcome_line(rich("x")));
  EXPECT_TRUE(std::isnan(*read.reply->depth));
  EXPECT_EQ((*read.reply->direction)[1], 5e-324);
  EXPECT_FALSE(read.reply->witness_a);
  EXPECT_EQ(read.judgement->separating_distance_squared, mpq_class(-7, 9));
  EXPECT_EQ(read.judgement->verdict, Verdict::too_deep);
  EXPECT_EQ(read.verdict, Verdict::not_invariant);
  EXPECT_EQ(read.fit, -3);
  EXPECT_EQ((*read.reply->witness_b)[0], 1) << "in the subject's unit";
  EXPECT_EQ(read.microseconds, 2.5);
  EXPECT_EQ(read.hulls->grown_squared, mpq_class(2, 9));
  EXPECT_EQ(read.hulls->query.separating_distance_squared, mpq_class(-7, 9));
}

TEST(Lines, EveryPrefixIsNoOutcome) {
  const std::string line = outcome_line(rich("x"));
  for (std::size_t size = 0; size < line.size(); ++size) EXPECT_FALSE(read_outcome(line.substr(0, size)));
  EXPECT_FALSE(read_outcome("{}"));
  EXPECT_FALSE(read_outcome(R"({"schema":"fathom/verdict/1","type":"case","id":"x"})"));
}

class Journals : public ::testing::Test {
 protected:
  Journals() : path_(::testing::TempDir() + "journal_test_" + std::to_string(::getpid()) + ".jsonl") {
    std::remove(path_.c_str());
  }
  ~Journals() override { std::remove(path_.c_str()); }

  [[nodiscard]] std::string text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }
  void write(const std::string& text) const { std::ofstream(path_) << text; }
  std::vector<std::string> resumed(const std::string& header, const std::string& more = "") {
    std::vector<std::string> ids;
    Journal journal = Journal::resume(
        path_, header, [&](const Outcome& outcome) { ids.push_back(outcome.id); },
        [&](const Unattributed& thing) { ids.push_back(thing.after.value_or("nothing") + ": " + thing.detail); });
    if (!more.empty()) journal.add(more);
    return ids;
  }
  static std::string header(const char* name = "s", Tolerance tolerance = {}) {
    SubjectInfo info;
    info.name = name;
    return header_line(info, tolerance);
  }
  std::string path_;
};

TEST_F(Journals, CutAnywhere) {
  const std::string lines = outcome_line(rich("one")) + '\n' + outcome_line(rich("two")) + '\n';
  const std::string whole = header() + '\n' + lines + summary_line({2, 0, 2, 0}) + '\n';
  const std::size_t first = header().size() + 1, second = first + outcome_line(rich("one")).size() + 1,
                    third = first + lines.size();
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    const auto is_near = [size](std::size_t end) { return size + 2 >= end && size <= end + 2; };
    if (size % 41 != 0 && !is_near(first) && !is_near(second) && !is_near(third) && !is_near(whole.size())) continue;
    write(whole.substr(0, size));
    std::vector<std::string> expected;
    if (size >= second) expected.emplace_back("one");
    if (size >= third) expected.emplace_back("two");
    ASSERT_EQ(resumed(header(), "more"), expected) << size;
    const std::size_t kept = size >= third ? third : size >= second ? second : first;
    ASSERT_EQ(text(), whole.substr(0, kept) + "more\n") << size;
  }
}

TEST_F(Journals, WhatIsNoCasesFault) {
  for (const Unattributed& thing :
       {Unattributed{"x\n", "killed"}, Unattributed{"", "wrote '\xff'"}, Unattributed{std::nullopt, "ended"}}) {
    const std::string line = unattributed_line(thing);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    ASSERT_TRUE(read_unattributed(line)) << line;
    EXPECT_EQ(read_unattributed(line)->after, thing.after);
    EXPECT_EQ(unattributed_line(*read_unattributed(line)), line);
    EXPECT_FALSE(read_outcome(line));
    for (std::size_t size = 0; size < line.size(); ++size) EXPECT_FALSE(read_unattributed(line.substr(0, size)));
  }
  write(header() + '\n' + unattributed_line({"one", "killed"}) + '\n' + outcome_line(rich("two")) + '\n');
  EXPECT_EQ(resumed(header()), (std::vector<std::string>{"one: killed", "two"}));
}

TEST_F(Journals, OfAnotherRun) {
  write(header() + '\n');
  EXPECT_THROW(resumed(header("other")), InputError);
  Tolerance tolerance;
  tolerance.relative = mpq_class(1, 7);
  EXPECT_THROW(resumed(header("s", tolerance)), InputError);
  EXPECT_EQ(text(), header() + '\n') << "untouched";
}

TEST_F(Journals, OfTheSameRunByAnotherCommand) {
  const auto from = [](const char* version, const char* command) {
    return header_line({}, {}, {version, command, ""});
  };
  write(from("1", "fathom certify --subject ./x a") + '\n');
  EXPECT_EQ(resumed(from("1", "fathom certify --resume --subject ./x a")).size(), 0U);
  EXPECT_EQ(text(), from("1", "fathom certify --subject ./x a") + '\n') << "the one that began it";
  EXPECT_THROW(resumed(from("2", "fathom certify --subject ./x a")), InputError)
      << "another fathom may judge otherwise";
  for (const char* none : {"", "[]", "null", "nonsense"}) EXPECT_FALSE(same_run(none, none)) << none;
}

TEST_F(Journals, WithAForeignLine) {
  write(header() + "\nnonsense\n" + outcome_line(rich("one")) + '\n');
  EXPECT_THROW(resumed(header()), InputError);
}

TEST_F(Journals, NothingIsOverwritten) {
  write("x");
  EXPECT_THROW(Journal::create(path_, header()), InputError);
  EXPECT_EQ(text(), "x");
  write("");
  { Journal::create(path_, header()).add("line"); }
  EXPECT_EQ(text(), header() + "\nline\n");
}

TEST_F(Journals, OneRunAtATime) {
  Journal journal = Journal::create(path_, header());
  EXPECT_THROW(resumed(header()), InputError);
}

TEST_F(Journals, FullDisk) {
  EXPECT_THROW(Journal::create("/dev/full", header()), std::runtime_error);
  EXPECT_THROW(Journal::create("/nowhere/journal", header()), InputError);
}

TEST(Families, OfIds) {
  EXPECT_EQ(family_of("real::fcl-545"), "real");
  EXPECT_EQ(family_of("near_ties-n20-s7"), "near_ties");
  EXPECT_EQ(family_of("a-n1-n20-s7"), "a-n1");
  for (const char* id : {"", "x", "17", "-n20-s7", "a-n20", "a-s7", "a-n-s7", "a-n20-s", "a-s7-n20", "::x"})
    EXPECT_EQ(family_of(id), "") << id;
}

/// Two points a unit apart; the number is the id.
Case numbered(std::uint64_t number) { return {std::to_string(number), {{{0, 0, 0}}}, {{{1, 0, 0}}}}; }

/// The exact method, wrong on these numbers.
Solver wrong_on(std::set<std::string> ids) {
  const Solver right = solver_by(Method::exact);
  return {"wrong", [=](const Case& pair, Monitor* monitor) {
            Depth depth = right.depth(pair, monitor);
            if (ids.count(pair.id) > 0) depth.flat_a = !depth.flat_a;
            return depth;
          }};
}

StreamPlan plan_of(std::uint64_t from, std::uint64_t count, unsigned jobs) {
  StreamPlan plan;
  plan.make = numbered;
  plan.from = from;
  plan.count = count;
  plan.jobs = jobs;
  return plan;
}

TEST(CompareStream, EndsAfterItsCount) {
  for (const unsigned jobs : {1u, 4u}) {
    StreamPlan plan = plan_of(5, 20, jobs);
    std::uint64_t done = 0;
    plan.report = [&](std::uint64_t count) { EXPECT_EQ(count, ++done); };
    const StreamResult result = compare_stream(plan, solver_by(Method::automatic), solver_by(Method::exact));
    EXPECT_EQ(result.end, 25u);
    EXPECT_FALSE(result.first);
    EXPECT_EQ(done, 20u);
  }
}

TEST(CompareStream, FindsTheFirstDifferenceOnAnyNumberOfThreads) {
  for (const unsigned jobs : {1u, 2u, 7u}) {
    const StreamResult result =
        compare_stream(plan_of(0, 100, jobs), solver_by(Method::automatic), wrong_on({"31", "32", "33", "90"}));
    ASSERT_TRUE(result.first);
    EXPECT_EQ(result.end, 31u);
    EXPECT_EQ(result.first->number, 31u);
    EXPECT_EQ(result.first->pair.id, "31");
    EXPECT_EQ(result.first->sentence, "automatic and wrong differ: flat_a: yes and no");
  }
}

TEST(CompareStream, StopsWhenAskedAndPassesOnWhatIsNoAnswer) {
  StreamPlan plan = plan_of(0, 100, 3);
  int asked = 0;
  plan.stop = [&] { return ++asked > 10; };
  EXPECT_EQ(compare_stream(plan, solver_by(Method::automatic), solver_by(Method::exact)).end, 10u);
  const Solver greedy{"greedy", [](const Case&, Monitor*) -> Depth { throw std::bad_alloc(); }};
  EXPECT_THROW(compare_stream(plan_of(0, 100, 3), solver_by(Method::exact), greedy), std::bad_alloc);
}

bool same(const Body& x, const Body& y) { return x.pieces ? *x.pieces == *y.pieces : x.points == y.points; }

/// Of a stream of cases of these families.
template <class Families>
void expect_a_function(Case (*make)(std::uint64_t seed, std::uint64_t number), const Families& families) {
  std::set<std::string> ids, forms;
  for (std::uint64_t number = 0; number < 2 * families.size(); ++number) {
    const Case one = make(9, number), again = make(9, number);
    EXPECT_EQ(one.id, again.id);
    EXPECT_TRUE(same(one.a, again.a) && same(one.b, again.b)) << one.id;
    ids.insert(one.id);
    const std::string end = one.id.ends_with(".b64") ? ".b64" : one.id.ends_with(".b32") ? ".b32" : "";
    forms.insert(end);
    EXPECT_TRUE(one.id.starts_with(families[number % families.size()].name)) << one.id;
    if (end.empty()) continue;
    const Precision precision = end == ".b64" ? Precision::binary64 : Precision::binary32;
    for_each_coordinate(one, [&](const mpq_class& value) { EXPECT_TRUE(representable(value, precision)) << one.id; });
  }
  EXPECT_EQ(ids.size(), 2 * families.size());
  EXPECT_EQ(forms.size(), 3u);
  EXPECT_NE(make(9, 0).id, make(10, 0).id);
}

TEST(RandomCase, IsAFunctionOfSeedAndNumber) { expect_a_function(random_case, families::families()); }
TEST(RandomUnions, IsAFunctionOfSeedAndNumber) {
  expect_a_function(random_unions, families::families(families::Kind::unions));
}

}  // namespace
}  // namespace fathom::harness
