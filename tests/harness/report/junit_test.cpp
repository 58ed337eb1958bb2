// SPDX-License-Identifier: GPL-3.0-or-later
// JUnit XML: well-formed whatever others say, built as the JUnit schema has it, and every verdict
// in its place.
#include "verify/harness/report/junit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "tests/harness/report/outcomes.hpp"
#include "tests/harness/report/well_formed.hpp"
#include "tests/support/property.hpp"

namespace fathom::harness {
namespace {

using testing::Element;
using testing::judged;
using testing::outcome;
using testing::subject;
using Outcomes = std::vector<Outcome>;

std::size_t number(const Element& element, const std::string& attribute) { return std::stoul(element[attribute]); }

void expect_counts(const Element& element) {
  EXPECT_EQ(number(element, "tests"), element.all("testcase").size());
  EXPECT_EQ(number(element, "failures"), element.all("failure").size());
  EXPECT_EQ(number(element, "errors"), element.all("error").size());
  EXPECT_EQ(number(element, "skipped"), element.all("skipped").size());
}

/// The structure of the JUnit schema that CI systems read: elements, order, attributes, and counts
/// that are right.
Element read_junit(const std::string& text) {
  const Element root = testing::read_xml(text);
  EXPECT_EQ(root.name, "testsuites");
  expect_counts(root);
  for (const Element& suite : root.children) {
    EXPECT_EQ(suite.name, "testsuite");
    EXPECT_TRUE(suite.attributes.contains("name") && suite.attributes.contains("time"));
    expect_counts(suite);
    EXPECT_EQ(suite.children.front().name, "properties");
    for (const Element& property : suite.children.front().children)
      EXPECT_EQ(std::tuple(property.name, property.attributes.contains("name"), property.attributes.contains("value")),
                std::tuple("property", true, true));
    for (std::size_t i = 1; i < suite.children.size(); ++i) {
      const Element& test = suite.children[i];
      EXPECT_EQ(test.name, "testcase");
      EXPECT_TRUE(test.attributes.contains("name") && test.attributes.contains("classname") &&
                  test.attributes.contains("time"));
      EXPECT_LE(test.children.size(), 1u);
      for (const Element& child : test.children)
        EXPECT_TRUE((std::set<std::string>{"failure", "error", "skipped"}).contains(child.name));
    }
  }
  return root;
}

/// The child of the test case of that name: its element's name; "" if there is none.
std::string child(const Element& root, const std::string& name) {
  for (const Element* test : root.all("testcase"))
    if ((*test)["name"] == name) return test->children.empty() ? "" : test->children.front().name;
  return "no such test case";
}

TEST(Junit, EachVerdictInItsPlace) {
  Outcomes outcomes;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(Verdict::pass); ++i) {
    const auto verdict = static_cast<Verdict>(i);
    outcomes.push_back(outcome(std::string(name(verdict)), verdict));
  }
  const Element root = read_junit(junit_xml(subject(), outcomes));
  for (const std::string verdict : {"crash", "time-out", "silent", "garbage", "failed"})
    EXPECT_EQ(child(root, verdict), "error") << verdict;
  for (const std::string verdict : {"pass", "touching-by-convention"}) EXPECT_EQ(child(root, verdict), "") << verdict;
  EXPECT_EQ(child(root, "unsupported"), "skipped");
  EXPECT_EQ(root.all("failure").size(), 13u);
  for (const Element* failure : root.all("failure"))
    EXPECT_EQ((*failure)["type"], (*failure)["message"]) << "no sentence: the verdict";
}

TEST(Junit, SuitesAreFamilies) {
  Outcome crash = outcome("b::1", Verdict::crash);
  crash.detail = "killed by signal 11";
  crash.seconds = 1.25;
  const Element root = read_junit(junit_xml(
      subject(), Outcomes{judged("b::2", Verdict::too_deep, 1, 1), judged("a-n8-s1", Verdict::pass, 0, 0), crash,
                          outcome("alone", Verdict::pass), outcome("b::2", Verdict::not_invariant, "swap")}));
  ASSERT_EQ(root.children.size(), 3u);
  EXPECT_EQ(root["name"], "fathom certify demo 2.1 (libccd, binary64)");
  EXPECT_EQ(root.children[0]["name"], "demo");
  EXPECT_EQ(root.children[1]["name"], "demo.a");
  const Element& b = root.children[2];
  EXPECT_EQ(std::tuple(b["name"], b["tests"], b["failures"], b["errors"], b["time"]),
            std::tuple("demo.b", "3", "2", "1", "1.250000"));
  const Element *deep = b.all("testcase")[0], *dead = b.all("testcase")[1], *swapped = b.all("testcase")[2];
  EXPECT_EQ(std::tuple((*deep)["name"], (*deep)["classname"], deep->children[0]["message"], deep->children[0]["type"]),
            std::tuple("b::2", "demo.b", "a sentence about b::2", "too-deep"));
  EXPECT_EQ(std::tuple((*dead)["time"], dead->children[0]["message"], dead->children[0].text),
            std::tuple("1.250000", "killed by signal 11", "killed by signal 11"));
  EXPECT_EQ((*swapped)["name"], "b::2 ~swap");
}

TEST(Junit, KnownFailures) {
  const Outcomes outcomes{outcome("known", Verdict::nan), outcome("new", Verdict::nan), outcome("fixed", Verdict::pass),
                          outcome("changed", Verdict::crash)};
  const auto known = ExpectedFailures::parse("nan known\nnan fixed\nnan changed\nnan gone\n", "list").check(outcomes);
  const Element root = read_junit(junit_xml(subject(), outcomes, known));
  EXPECT_EQ(child(root, "known"), "skipped");
  EXPECT_EQ((*root.all("skipped")[0])["message"], "known failure: nan: nan");
  EXPECT_EQ(child(root, "new"), "failure");
  EXPECT_EQ(child(root, "fixed"), "failure");
  EXPECT_EQ(child(root, "changed"), "error");
  EXPECT_EQ(root.children.back()["name"], "known failures");
  EXPECT_EQ(child(root, "nan gone"), "failure");
  std::multiset<std::string> types;
  for (const Element* failure : root.all("failure")) types.insert((*failure)["type"]);
  EXPECT_EQ(types, (std::multiset<std::string>{"nan", "not-met", "unexpected-pass"}));
}

TEST(Junit, WhatIsNoCasesFaultIsAnErrorOfItsOwn) {
  RunInfo run;
  run.unattributed = {{"ended by signal 11 after an answer", 2}, {testing::hostile(), 1}};
  const Element root = read_junit(junit_xml(subject(), Outcomes{outcome("fine", Verdict::pass)}, {}, run));
  EXPECT_EQ(root.children.back()["name"], "unattributed");
  EXPECT_EQ(root["errors"], "2");
  EXPECT_EQ(child(root, "2 x ended by signal 11 after an answer"), "error");
}

TEST(Junit, OfNothing) { EXPECT_EQ(read_junit(junit_xml(subject(), {})).children.size(), 0u); }

TEST(Junit, WellFormedWhateverOthersSay) {
  SubjectInfo info = subject();
  info.name = info.version = info.settings[testing::hostile()] = testing::hostile();
  Outcome bad = judged(testing::hostile(), Verdict::too_deep, 1, 1);
  bad.detail = bad.variant = testing::hostile();
  const auto known = ExpectedFailures::parse("nan gone%00%ff%3c", "list").check(Outcomes{bad});
  EXPECT_EQ(read_junit(junit_xml(info, Outcomes{bad, outcome(testing::hostile() + "::", Verdict::crash)}, known))
                .children.size(),
            3u);
  EXPECT_TRUE(holds({.seed = 73, .runs = 1000}, [](const std::string& id, const std::string& detail) {
    Outcome any = outcome(id, Verdict::garbage);
    any.detail = detail;
    const Element root = testing::read_xml(junit_xml(subject(), Outcomes{any}));
    RC_ASSERT(root.all("error").size() == 1U);
  }));
}

}  // namespace
}  // namespace fathom::harness
