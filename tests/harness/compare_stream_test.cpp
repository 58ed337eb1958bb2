// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fathom/numbers.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {
namespace {

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
