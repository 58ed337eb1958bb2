// SPDX-License-Identifier: GPL-3.0-or-later
// The page: well-formed whatever others say, self-contained, nothing lost, and which failures it
// shows.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fathom/shape.hpp"
#include "reference/files/cases.hpp"
#include "tests/harness/report/outcomes.hpp"
#include "tests/harness/report/well_formed.hpp"
#include "tests/support/property.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"
#include "verify/harness/report/reports.hpp"

namespace fathom::harness {
namespace {

using testing::Element;
using testing::judged_outcome;
using testing::judged_subject;
using testing::outcome;
using Outcomes = std::vector<Outcome>;
using Failures = std::vector<HtmlFailure>;

Case cubes(const std::string& id, const mpq_class& x) {
  return {id, families::translated(families::cube(), {x, 0, 0}), families::cube()};
}

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

template <class Visit>
void visit_all(const Element& element, const Visit& visit) {
  visit(element);
  for (const Element& child : element.children) visit_all(child, visit);
}

/// A policy that lets the page's own style and script run, and nothing from elsewhere.
void check_policy(const Element& page) {
  const Element& policy = *page.all("meta").at(1);
  EXPECT_EQ(policy["http-equiv"], "Content-Security-Policy");
  EXPECT_TRUE(policy["content"].starts_with("default-src 'none'; script-src 'sha256-")) << policy["content"];
  for (const std::string unsafe : {"unsafe", "http", "*"})
    EXPECT_EQ(policy["content"].find(unsafe), std::string::npos) << unsafe;
  EXPECT_EQ(page.all("script").size(), 1u);
}

/// Every picture has something in it: each shape of it is somewhere.
void check_pictures(const Element& page) {
  for (const Element* picture : page.all("svg")) {
    std::size_t shapes = 0;
    for (const char* shape : {"path", "rect", "circle"}) shapes += picture->all(shape).size();
    EXPECT_GT(shapes, 0u) << (*picture)["class"];
  }
  for (const Element* path : page.all("path")) EXPECT_TRUE((*path)["d"].starts_with("M"));
}

/// Reads the page and checks what every page must be: self-contained, with unique ids, no dangling
/// link, and an accessible structure.
Element read_page(const std::string& text) {
  Element page = testing::read_xml(text);
  check_policy(page);
  check_pictures(page);
  std::set<std::string> ids;
  const auto visit = [&](const auto& self, const Element& element) -> void {
    EXPECT_FALSE((std::set<std::string>{"link", "img", "iframe", "object", "image"}).contains(element.name));
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
  visit_all(page, [&](const Element& element) {
    if (element.attributes.contains("data-of")) EXPECT_TRUE(ids.contains(element["data-of"])) << element["data-of"];
  });
  for (const Element* picture : page.all("svg")) {
    if (picture->attributes.contains("aria-hidden")) continue;
    EXPECT_EQ(std::pair(picture->children.at(0).name, picture->children.at(1).name),
              std::pair(std::string("title"), std::string("desc")));
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
  const Element page = read_page(html_page(
      judged_subject(), Outcomes{deep.outcome, judged_outcome("cubes::2", Verdict::pass, 0, 0)}, Failures{deep}, {}));
  ASSERT_EQ(page.all("article").size(), 1u);
  const Element& article = *page.all("article")[0];
  for (const std::string what : {"cubes::deep", "too-deep", "0.75", "(0.6, 0.8, 0)", "0.5 (squared: 1/4)",
                                 "depth^2 = 1/4", "a.cert", "translation of A = (1/2, 0, 0)", "(0.5, 0, 0)"})
    EXPECT_TRUE(says(article, what)) << what;
  EXPECT_TRUE(says(article, deep.outcome.judgement->sentence));
  ASSERT_GE(article.all("svg").size(), 1u);
  EXPECT_TRUE(says(page, "2 cases: 1 pass, 1 fail"));
  EXPECT_TRUE(says(page, "The only one is shown in full."));
  EXPECT_TRUE(says(page, "too-deep: 1 of 1"));
  const Element& copied = *article.all("pre").at(0);
  EXPECT_EQ(copied.text, files::case_json(deep.seen, "too-deep of demo 2.1"));
  EXPECT_EQ((*article.all("button").at(0))["data-of"], copied["id"]);
  EXPECT_TRUE(says(page, "relative 1/1000, absolute 1/1000000 of the extent"));
}

TEST(Html, AClaimedDerivativeBesideTheTrueOne) {
  Reply reply;
  reply.overlap = true;
  HtmlFailure moving = failure(cubes("cubes::moving", mpq_class(3, 2)), reply);
  moving.outcome.judgement->derivative = {2.5, mpq_class(-4), "", {"ties", "extended"}, 4.5, ""};
  HtmlFailure curved = failure(cubes("cubes::curved", mpq_class(3, 2)), reply);
  for (HtmlFailure* each : {&moving, &curved}) each->outcome.verdict = Verdict::wrong_derivative;
  curved.outcome.judgement->derivative = {1.75, {}, "curved", {}, {}, ""};
  const Element page =
      read_page(html_page(judged_subject(), Outcomes{moving.outcome, curved.outcome}, Failures{moving, curved}, {}));
  for (const std::string what : {"Derivative of the signed depth", "2.5", "-2 (squared: -4)", "ties, extended", "1.75"})
    EXPECT_TRUE(says(page, what)) << what;
  EXPECT_TRUE(says(page, "not judged\ncurved\n"));
}

// Of every family, with claims that are right, absurd and useless: a picture that stays in bounds,
// for flat, tiny and huge bodies too.
TEST(Html, PicturesOfAllFamilies) {
  Failures failures;
  Outcomes outcomes;
  std::vector<families::Family> drawn;
  for (const families::Kind kind : {families::Kind::polytopes, families::Kind::plane})
    std::ranges::copy(families::families(kind), std::back_inserter(drawn));
  for (const families::Family& family : drawn) {
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
    made.outcome.dimension = made.seen.a.dimension;
    failures.push_back(made);
    outcomes.push_back(made.outcome);
  }
  const Element page = read_page(html_page(judged_subject(), outcomes, failures, {}));
  EXPECT_EQ(page.all("article").size(), failures.size());
  for (const Element* article : page.all("article")) EXPECT_GE(article->all("svg").size(), 1u) << (*article)["id"];
  for (const Element* path : page.all("path")) {
    const std::string& d = (*path)["d"];
    EXPECT_TRUE(d.starts_with("M"));
    for (const std::string bad : {"nan", "inf", "e+"}) EXPECT_EQ(d.find(bad), std::string::npos) << d;
    EXPECT_LT(d.size(), 50'000u);
  }
}

// The plane is seen from above, its points have two coordinates, and round bodies a claim too.
TEST(Html, AFailureInThePlane) {
  Reply reply;
  reply.overlap = true;
  reply.depth = 0.75;
  reply.direction = Triple{0.6, 0.8, 0};
  Body square{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}, disc;
  square.dimension = disc.dimension = 2;
  disc.shape = moved(sphere(1), rigid_pose({1, 0, 0, 0}, {mpq_class(5, 2), 1, 0}));
  Failures failures;
  Outcomes outcomes;
  for (const Body& b : {square, disc}) {
    HtmlFailure made{outcome(b.shape ? "round" : "flat", Verdict::too_deep), {"in the plane", square, b}, ""};
    made.outcome.reply = reply;
    made.outcome.dimension = 2;
    failures.push_back(made);
    outcomes.push_back(made.outcome);
  }
  const Element page = read_page(html_page(judged_subject(), outcomes, failures, {}));
  ASSERT_EQ(page.all("article").size(), 2u);
  for (const Element* article : page.all("article")) {
    EXPECT_TRUE(says(*article, "in the plane: x to the right, y up"));
    EXPECT_TRUE(says(*article, "(0.6, 0.8)"));
    EXPECT_TRUE(says(*article, "The claimed translation is dashed.")) << "law: of round bodies too";
    EXPECT_EQ(article->all("button").size(), 1u) << "law: the case can be copied";
    EXPECT_FALSE(says(*article, "hidden edges"));
  }
  EXPECT_TRUE(says(page, "translation of A = (-2, 0)\n")) << "law: of two coordinates";
  EXPECT_TRUE(says(page, "; thick: the edges in contact"));
}

TEST(Html, NoPairAndNoAnswer) {
  const HtmlFailure lost{outcome("lost", Verdict::crash), {}, ""};
  const Element page = read_page(html_page({}, Outcomes{lost.outcome}, Failures{lost}, {}));
  EXPECT_EQ(page.all("article").size(), 1u);
  EXPECT_EQ(page.all("article")[0]->all("svg").size(), 0u);
  EXPECT_TRUE(says(read_page(html_page({}, {}, {}, {})), "There are none."));
}

TEST(Html, WhatIsNoCasesFault) {
  RunInfo run;
  run.unattributed = {{"ended by signal 11 after an answer", 2}, {testing::hostile(), 1}};
  const Element page = read_page(html_page(judged_subject(), Outcomes{outcome("fine", Verdict::pass)}, {}, {}, run));
  EXPECT_TRUE(says(page, "1 case: 1 pass, 0 fail; 3 unattributed"));
  EXPECT_TRUE(says(page, "2 x ended by signal 11 after an answer"));
  EXPECT_FALSE(says(read_page(html_page({}, {}, {}, {})), "No case's fault"));
}

TEST(Html, WellFormedWhateverOthersSay) {
  SubjectInfo info = judged_subject();
  info.name = info.version = info.library = info.settings[testing::hostile()] = testing::hostile();
  HtmlFailure bad{judged_outcome(testing::hostile(), Verdict::too_deep, -INFINITY, NAN), cubes(testing::hostile(), 1),
                  testing::hostile()};
  bad.outcome.detail = bad.outcome.variant = testing::hostile();
  bad.outcome.judgement->sentence = testing::hostile();
  const Element page =
      read_page(html_page(info, Outcomes{bad.outcome, outcome("</td>\xff", Verdict::garbage)}, Failures{bad}, {}));
  EXPECT_TRUE(says(page, "</td>\\xff"));
}

TEST(Html, Histograms) {
  Outcomes outcomes;
  for (const double error : {0.0, 1e-16, 2e-16, 5e-9, -0.3})
    outcomes.push_back(judged_outcome("a::1", Verdict::pass, error, 0));
  for (const double error : {-0.0, 1e-40, 1e40, double{INFINITY}})
    outcomes.push_back(judged_outcome("a::2", Verdict::too_deep, error, 0));
  const Element page = read_page(html_page(judged_subject(), outcomes, {}, {}));
  std::vector<const Element*> charts;
  for (const Element* picture : page.all("svg"))
    if (picture->attributes.contains("viewBox")) charts.push_back(picture);
  ASSERT_EQ(charts.size(), 2u) << "relative, and in uR";
  std::multiset<std::string> titles;
  for (const Element* bar : charts[0]->all("rect")) titles.insert(bar->children.at(0).text);
  EXPECT_EQ(titles,
            (std::multiset<std::string>{"pass: 1 case from 1e-1 to 1e0", "pass: 1 case from 1e-9 to 1e-8",
                                        "pass: 1 case with no error at all", "pass: 2 cases from 1e-16 to 1e-15",
                                        "too-deep: 1 case below 1e-17", "too-deep: 1 case with no error at all",
                                        "too-deep: 2 cases from 1e18 on"}));
}

TEST(Html, ThousandsOfFailures) {
  Outcomes outcomes;
  Failures failures;
  for (int i = 0; i < 6000; ++i)
    outcomes.push_back(judged_outcome("many::" + std::to_string(i), Verdict::too_shallow, -1e-3 * i, 1));
  outcomes.push_back(judged_outcome("rare::1", Verdict::too_shallow, -1e-9, 1));
  outcomes.push_back(judged_outcome("many::x", Verdict::too_deep, 1e-9, 1));
  for (const Outcome& each : outcomes) failures.push_back({each, cubes(each.id, 1), ""});
  const Element page = read_page(html_page(judged_subject(), outcomes, failures, {}));
  EXPECT_EQ(page.all("article").size(), most_shown_failures);
  EXPECT_TRUE(says(page, "200 of 6002 are shown in full"));
  EXPECT_TRUE(says(page, "too-shallow: 199 of 6001"));
  EXPECT_TRUE(says(page, "Cases: 5000 of 6002, failures first"));
  EXPECT_TRUE(says(page, "1002 further cases are not listed here"));
}

/// Rows of the element with this id, by the text of their cells.
std::vector<std::vector<std::string>> rows_of(const Element& page, const std::string& id) {
  std::vector<std::vector<std::string>> rows;
  visit_all(page, [&](const Element& element) {
    if (!element.attributes.contains("id") || element["id"] != id) return;
    for (const Element* row : element.all("tr")) {
      rows.emplace_back();
      for (const Element& cell : row->children)
        rows.back().push_back(cell.children.empty() ? cell.text : cell.children[0].text);
    }
  });
  return rows;
}

// A crash says nothing about the depth: it is shown, with the bodies, behind the answers that are
// wrong.
TEST(Html, WrongAnswersBeforeThoseThatAreNotThere) {
  Failures failures;
  Outcomes outcomes{judged_outcome("fine", Verdict::pass, 0, 0), outcome("touch", Verdict::touching_by_convention),
                    outcome("not mine", Verdict::unsupported)};
  for (const Verdict verdict : {Verdict::crash, Verdict::time_out})
    failures.push_back({outcome("lost", verdict), cubes("lost", 1), ""});
  for (const auto& [id, error] :
       {std::pair{"deep little", 0.25}, std::pair{"deep most", 4.0}, std::pair{"deep more", 0.5}})
    failures.push_back({judged_outcome(id, Verdict::too_deep, error, 1), cubes("deep", 1), ""});
  for (const HtmlFailure& each : failures) outcomes.push_back(each.outcome);
  const Element page = read_page(html_page(judged_subject(), outcomes, failures, {}));
  std::vector<std::string> headings, cards;
  for (const Element* heading : page.all("h3")) headings.push_back(heading->text);
  EXPECT_EQ(headings, (std::vector<std::string>{"too-deep: 3 of 3", "crash: 1 of 1", "time-out: 1 of 1"}));
  for (const Element* card : page.all("article")) {
    cards.push_back(card->all("a").at(0)->text);
    const Element& first = card->children.at(2).children.at(0).children.at(0);
    EXPECT_EQ(first.name, "figure") << "picture first";
    EXPECT_GE(first.all("path").size(), 4u);
  }
  EXPECT_EQ(cards, (std::vector<std::string>{"deep most", "deep more", "deep little", "lost", "lost"}));
  std::vector<std::string> ids;
  for (const auto& row : rows_of(page, "cases")) ids.push_back(row.at(0));
  EXPECT_EQ(ids, (std::vector<std::string>{"deep most", "deep more", "deep little", "lost", "lost", "not mine", "touch",
                                           "fine"}));
}

// The bar, its legend, the line above it, both tables and the filter count the same cases.
TEST(Html, CountsAgree) {
  Outcomes outcomes;
  std::map<Verdict, std::size_t> counts{{Verdict::pass, 5},
                                        {Verdict::touching_by_convention, 2},
                                        {Verdict::unsupported, 1},
                                        {Verdict::too_deep, 3},
                                        {Verdict::crash, 4}};
  for (const auto& [verdict, count] : counts)
    for (std::size_t i = 0; i < count; ++i)
      outcomes.push_back(outcome("a::" + std::to_string(outcomes.size()), verdict));
  const Element page = read_page(html_page(judged_subject(), outcomes, {}, {}));
  EXPECT_TRUE(says(page, "15 cases: 7 pass, 7 fail, 1 unsupported"));
  EXPECT_TRUE(says(page, "Passes are pass and touching-by-convention: 5 + 2."));
  const Element& bar = *page.all("figure").at(0);
  std::map<std::string, std::string> legend;
  for (const Element* item : bar.all("li"))
    legend[item->text.substr(item->text.find_last_of(' ') + 1)] = item->all("b").at(0)->text;
  double width = 0;
  for (const Element& part : bar.children.at(0).children)
    if (part.name == "rect") width += std::stod(part["width"]);
  EXPECT_NEAR(width, 100, 0.01);
  for (const auto& [verdict, count] : counts) {
    const std::string word(name(verdict));
    EXPECT_EQ(legend[word], std::to_string(count)) << word;
    EXPECT_TRUE(says(page, word + " (" + std::to_string(count) + ")")) << "the filter: " << word;
    const auto rows = rows_of(page, "cases");
    EXPECT_EQ(std::ranges::count(rows, word, [](const auto& row) { return row.at(1); }),
              static_cast<std::ptrdiff_t>(count))
        << word;
  }
  const Element& all = *page.all("tbody").at(0)->all("tr").at(0);
  std::vector<std::string> cells;
  for (const Element* cell : all.all("td"))
    cells.push_back(cell->children.empty() ? cell->text : cell->children[0].text);
  EXPECT_EQ(cells, (std::vector<std::string>{"15", "7", "5", "2", "4", "3", "1"})) << "cases, passes, and each verdict";
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

// JUnit XML: well-formed whatever others say, built as the JUnit schema has it, and every verdict
// in its place.

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
  const Element root = read_junit(junit_xml(judged_subject(), outcomes));
  for (const std::string verdict : {"crash", "time-out", "silent", "garbage", "failed"})
    EXPECT_EQ(child(root, verdict), "error") << verdict;
  for (const std::string verdict : {"pass", "touching-by-convention"}) EXPECT_EQ(child(root, verdict), "") << verdict;
  EXPECT_EQ(child(root, "unsupported"), "skipped");
  EXPECT_EQ(root.all("failure").size(), 19u);
  for (const Element* failure : root.all("failure"))
    EXPECT_EQ((*failure)["type"], (*failure)["message"]) << "no sentence: the verdict";
}

TEST(Junit, SuitesAreFamilies) {
  Outcome crash = outcome("b::1", Verdict::crash);
  crash.detail = "killed by signal 11";
  crash.seconds = 1.25;
  const Element root = read_junit(junit_xml(
      judged_subject(),
      Outcomes{judged_outcome("b::2", Verdict::too_deep, 1, 1), judged_outcome("a-n8-s1", Verdict::pass, 0, 0), crash,
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
  const Element root = read_junit(junit_xml(judged_subject(), outcomes, known));
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
  const Element root = read_junit(junit_xml(judged_subject(), Outcomes{outcome("fine", Verdict::pass)}, {}, run));
  EXPECT_EQ(root.children.back()["name"], "unattributed");
  EXPECT_EQ(root["errors"], "2");
  EXPECT_EQ(child(root, "2 x ended by signal 11 after an answer"), "error");
}

TEST(Junit, OfNothing) { EXPECT_EQ(read_junit(junit_xml(judged_subject(), {})).children.size(), 0u); }

TEST(Junit, WellFormedWhateverOthersSay) {
  SubjectInfo info = judged_subject();
  info.name = info.version = info.settings[testing::hostile()] = testing::hostile();
  Outcome bad = judged_outcome(testing::hostile(), Verdict::too_deep, 1, 1);
  bad.detail = bad.variant = testing::hostile();
  const auto known = ExpectedFailures::parse("nan gone%00%ff%3c", "list").check(Outcomes{bad});
  EXPECT_EQ(read_junit(junit_xml(info, Outcomes{bad, outcome(testing::hostile() + "::", Verdict::crash)}, known))
                .children.size(),
            3u);
  EXPECT_TRUE(holds({.seed = 73, .runs = 1000}, [](const std::string& id, const std::string& detail) {
    Outcome any = outcome(id, Verdict::garbage);
    any.detail = detail;
    const Element root = testing::read_xml(junit_xml(judged_subject(), Outcomes{any}));
    RC_ASSERT(root.all("error").size() == 1U);
  }));
}

}  // namespace
}  // namespace fathom::harness
