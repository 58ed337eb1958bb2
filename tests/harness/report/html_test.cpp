// SPDX-License-Identifier: GPL-3.0-or-later
// The page: well-formed whatever others say, self-contained, nothing lost, and which failures it shows.
#include "verify/harness/report/html.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/harness/report/outcomes.hpp"
#include "tests/harness/report/well_formed.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"
#include "verify/harness/report/picture.hpp"

namespace fathom::harness {
namespace {

using testing::Element;
using testing::judged;
using testing::outcome;
using testing::subject;
using Outcomes = std::vector<Outcome>;
using Failures = std::vector<HtmlFailure>;

Case cubes(const std::string& id, const mpq_class& x) { return {id, families::translated(families::cube(), {x, 0, 0}), families::cube()}; }

/// As the harness would: one answer, judged.
HtmlFailure failure(const Case& seen, const Reply& reply) {
  HtmlFailure result{outcome(seen.id, Verdict::pass), seen, "a.cert"};
  result.outcome.reply = reply;
  result.outcome.judgement = judge(truth_about(seen.a.points, seen.b.points), reply);
  result.outcome.verdict = result.outcome.judgement->verdict;
  return result;
}

std::string all_text(const Element& element) {
  std::string result = element.text + "\n";
  for (const Element& child : element.children) result += all_text(child);
  return result;
}

/// Reads the page and checks what every page must be: self-contained, with unique ids, no dangling link, and an accessible structure.
Element read_page(const std::string& text) {
  Element page = testing::read_xml(text);
  std::set<std::string> ids;
  const auto visit = [&](const auto& self, const Element& element) -> void {
    EXPECT_FALSE((std::set<std::string>{"script", "link", "img", "iframe", "object", "use", "image"}).contains(element.name));
    for (const auto& [name, value] : element.attributes) {
      EXPECT_TRUE(name != "src" && name != "style" && !name.starts_with("on"));
      EXPECT_TRUE(name != "id" || ids.insert(value).second) << value;
      EXPECT_TRUE(name != "href" || value.starts_with("#")) << value;
    }
    for (const Element& child : element.children) self(self, child);
  };
  visit(visit, page);
  for (const Element* link : page.all("a")) EXPECT_TRUE(ids.contains((*link)["href"].substr(1))) << (*link)["href"];
  for (const Element* head : page.all("th")) EXPECT_TRUE(head->attributes.contains("scope"));
  for (const Element* picture : page.all("svg")) {
    EXPECT_EQ(std::pair(picture->children.at(0).name, picture->children.at(1).name), std::pair(std::string("title"), std::string("desc")));
    EXPECT_TRUE((*picture)["aria-labelledby"].starts_with(picture->children[0]["id"]));
  }
  EXPECT_EQ(page.all("h1").size(), 1u);
  EXPECT_EQ(page["lang"], "en");
  const std::string style = page.all("style")[0]->text;
  EXPECT_EQ(style.find("url("), std::string::npos);
  EXPECT_EQ(style.find("@import"), std::string::npos);
  EXPECT_NE(style.find("prefers-color-scheme: dark"), std::string::npos);
  return page;
}

bool says(const Element& page, const std::string& what) { return all_text(page).find(what) != std::string::npos; }

TEST(Html, AFailureInFull) {
  Reply reply;
  reply.overlap = true;
  reply.depth = 0.75;
  reply.direction = Triple{0.6, 0.8, 0};
  const HtmlFailure deep = failure(cubes("cubes::deep", mpq_class(3, 2)), reply);
  ASSERT_EQ(deep.outcome.verdict, Verdict::too_deep);
  const Element page = read_page(html_page(subject(), Outcomes{deep.outcome, judged("cubes::2", Verdict::pass, 0, 0)}, Failures{deep}, {}));
  ASSERT_EQ(page.all("article").size(), 1u);
  const Element& article = *page.all("article")[0];
  for (const std::string what : {"cubes::deep", "too-deep", "0.75", "(0.6, 0.8, 0)", "0.5 (squared: 1/4)", "depth^2 = 1/4", "a.cert",
                                 "A: 8 points", "translation of A = (1/2, 0, 0)", "(0.5, 0, 0)"})
    EXPECT_TRUE(says(article, what)) << what;
  EXPECT_TRUE(says(article, deep.outcome.judgement->sentence));
  ASSERT_GE(article.all("svg").size(), 1u);
  EXPECT_TRUE(says(page, "2 cases: 1 pass, 1 fail"));
  EXPECT_TRUE(says(page, "The only one is shown in full."));
  EXPECT_TRUE(says(page, "too-deep: 1 of 1"));
  EXPECT_FALSE(says(page, "The other failures"));
  EXPECT_TRUE(says(page, "relative 1/1000, absolute 1/1000000 of the extent"));
}

// Of every family, with claims that are right, absurd and useless: a picture that stays in bounds, for flat, tiny and huge bodies too.
TEST(Html, PicturesOfAllFamilies) {
  Failures failures;
  Outcomes outcomes;
  for (const families::Family& family : families::families()) {
    Reply reply;
    reply.overlap = true;
    switch (failures.size() % 4) {
      case 0: reply.depth = 1e300, reply.direction = Triple{1e300, -1, 1e-300}; break;
      case 1: reply.depth = std::nan(""), reply.direction = Triple{0, 0, 0}; break;
      case 2: reply.depth = -1e-200, reply.direction = Triple{0, 1, 0}; break;
      default: break;
    }
    HtmlFailure made{outcome(std::string(family.name) + "::1", Verdict::too_deep), family.make(1, 8), ""};
    made.outcome.reply = reply;
    failures.push_back(made);
    outcomes.push_back(made.outcome);
  }
  const Element page = read_page(html_page(subject(), outcomes, failures, {}));
  EXPECT_EQ(page.all("article").size(), failures.size());
  for (const Element* article : page.all("article")) EXPECT_GE(article->all("svg").size(), 1u) << (*article)["id"];
  for (const Element* path : page.all("path")) {
    const std::string& d = (*path)["d"];
    EXPECT_TRUE(d.starts_with("M"));
    for (const std::string bad : {"nan", "inf", "e+"}) EXPECT_EQ(d.find(bad), std::string::npos) << d;
    EXPECT_LT(d.size(), 50'000u);
  }
}

TEST(Html, NoPairAndNoAnswer) {
  const HtmlFailure lost{outcome("lost", Verdict::crash), {}, ""};
  const Element page = read_page(html_page({}, Outcomes{lost.outcome}, Failures{lost}, {}));
  EXPECT_EQ(page.all("article").size(), 1u);
  EXPECT_EQ(page.all("svg").size(), 0u);
  EXPECT_TRUE(says(read_page(html_page({}, {}, {}, {})), "There are none."));
}

TEST(Html, WhatIsNoCasesFault) {
  RunInfo run;
  run.unattributed = {{"ended by signal 11 after an answer", 2}, {testing::hostile(), 1}};
  const Element page = read_page(html_page(subject(), Outcomes{outcome("fine", Verdict::pass)}, {}, {}, run));
  EXPECT_TRUE(says(page, "1 case: 1 pass, 0 fail; 3 unattributed"));
  EXPECT_TRUE(says(page, "2 x ended by signal 11 after an answer"));
  EXPECT_FALSE(says(read_page(html_page({}, {}, {}, {})), "No case's fault"));
}

TEST(Html, WellFormedWhateverOthersSay) {
  SubjectInfo info = subject();
  info.name = info.version = info.library = info.settings[testing::hostile()] = testing::hostile();
  HtmlFailure bad{judged(testing::hostile(), Verdict::too_deep, -INFINITY, NAN), cubes(testing::hostile(), 1), testing::hostile()};
  bad.outcome.detail = bad.outcome.variant = testing::hostile();
  bad.outcome.judgement->sentence = testing::hostile();
  const Element page = read_page(html_page(info, Outcomes{bad.outcome, outcome("</td>\xff", Verdict::garbage)}, Failures{bad}, {}));
  EXPECT_TRUE(says(page, "</td>\\xff"));
}

TEST(Html, Histograms) {
  Outcomes outcomes;
  for (const double error : {0.0, 1e-16, 2e-16, 5e-9, -0.3}) outcomes.push_back(judged("a::1", Verdict::pass, error, 0));
  for (const double error : {-0.0, 1e-40, 1e40, double{INFINITY}}) outcomes.push_back(judged("a::2", Verdict::too_deep, error, 0));
  const Element page = read_page(html_page(subject(), outcomes, {}, {}));
  ASSERT_EQ(page.all("svg").size(), 2u) << "relative, and in uR";
  std::multiset<std::string> titles;
  for (const Element* bar : page.all("svg")[0]->all("rect")) titles.insert(bar->children.at(0).text);
  EXPECT_EQ(titles, (std::multiset<std::string>{"pass: 1 case from 1e-1 to 1e0", "pass: 1 case from 1e-9 to 1e-8",
                                                "pass: 1 case with no error at all", "pass: 2 cases from 1e-16 to 1e-15",
                                                "too-deep: 1 case below 1e-17", "too-deep: 1 case with no error at all",
                                                "too-deep: 2 cases from 1e18 on"}));
}

TEST(Html, ThousandsOfFailures) {
  Outcomes outcomes;
  Failures failures;
  for (int i = 0; i < 6000; ++i) outcomes.push_back(judged("many::" + std::to_string(i), Verdict::too_shallow, -1e-3 * i, 1));
  outcomes.push_back(judged("rare::1", Verdict::too_shallow, -1e-9, 1));
  outcomes.push_back(judged("many::x", Verdict::too_deep, 1e-9, 1));
  for (const Outcome& each : outcomes) failures.push_back({each, cubes(each.id, 1), ""});
  const Element page = read_page(html_page(subject(), outcomes, failures, {}));
  EXPECT_EQ(page.all("article").size(), most_shown_failures);
  EXPECT_TRUE(says(page, "200 of 6002 are shown in full"));
  EXPECT_TRUE(says(page, "too-shallow: 199 of 6001"));
  EXPECT_TRUE(says(page, "5000 are listed below"));
  EXPECT_TRUE(says(page, "802 further failures are not listed here."));
}

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

TEST(Claims, TranslationsFollowTheConventions) {
  Reply reply{.overlap = true, .depth = -2, .direction = Triple{0, 0, 4}, .witness_a = {}, .witness_b = {}};
  Conventions conventions;
  conventions.depth = Conventions::Sign::negative;
  EXPECT_EQ(claimed_translation(reply, conventions), (Point{0, 0, 2}));
  conventions.moves = Conventions::Body::b;
  EXPECT_EQ(claimed_translation(reply, conventions), (Point{0, 0, -2}));
  reply.direction = Triple{0, 0, 0};
  EXPECT_EQ(claimed_translation(reply, conventions), std::nullopt);
  reply.direction = Triple{0, INFINITY, 0};
  EXPECT_EQ(claimed_translation(reply, conventions), std::nullopt);
  reply = {};
  EXPECT_EQ(claimed_translation(reply, conventions), std::nullopt);
}

}  // namespace
}  // namespace fathom::harness
