// SPDX-License-Identifier: GPL-3.0-or-later
// The page over data made by hand: gaps, sentences, escapes; what is not for those without scripts
// is hidden.
#include "view/page/page.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace {

using namespace fathom;

page::Data data(const char* text) { return text::parsed_json(text); }

std::size_t count(std::string_view text, std::string_view what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(Fill, PutsValuesInOnceAndAsTheyAre) {
  EXPECT_EQ(page::filled("a{{x}}b{{y}}{{x}}", {{"x", "{{y}}"}, {"y", "<2>"}}), "a{{y}}b<2>{{y}}");
  EXPECT_EQ(page::filled("no gaps } { }}", {}), "no gaps } { }}");
}

TEST(Fill, RefusesGapsWithoutValues) {
  EXPECT_THROW(page::filled("{{x}}", {{"y", ""}}), std::logic_error);
  EXPECT_THROW(page::filled("{{x", {{"x", ""}}), std::logic_error);
}

TEST(Answer, SaysWhatIsKnown) {
  const auto said = [](const char* text) { return page::answer_sentence(data(text)); };
  EXPECT_EQ(said(R"({"status":"penetrating","depth":{"value":0.25}})"), "A overlaps B by 0.25");
  EXPECT_EQ(said(R"({"status":"touching","depth":{"value":0}})"), "A and B touch");
  EXPECT_EQ(said(R"({"status":"disjoint","depth":{"value":0},"distance":{"value":1.5}})"), "A and B are apart by 1.5");
  EXPECT_EQ(
      said(R"({"status":"penetrating","depth":{"value":null,"rounded":null},"signed_depth":{"low":0.1,"high":0.2}})"),
      "A overlaps B by 0.1 to 0.2");
  EXPECT_EQ(
      said(R"({"status":"disjoint","distance":{"value":null,"rounded":null},"signed_depth":{"low":-0.2,"high":-0.1}})"),
      "A and B are apart by 0.1 to 0.2");
  EXPECT_EQ(said(R"({"status":"penetrating","depth":{"value":null,"rounded":{"f64":{"rn":"inf"}}}})"),
            "A overlaps B by more than the largest binary64");
  EXPECT_EQ(said(R"({"status":"penetrating","depth":{"value":null,"rounded":{"f64":{"rn":"0x0p+0"}}}})"),
            "A overlaps B by less than the least positive binary64");
  EXPECT_EQ(said(R"({"status":"undecided","depth":{"value":null},"signed_depth":{"low":-1e-300,"high":1e-300}})"),
            "The bounds leave open whether A and B overlap: signed depth -1e-300 to 1e-300");
}

TEST(Html, CutsNumbersThatAreTooLong) {
  const std::string digits(5000, '7');
  EXPECT_EQ(page::shown({page::Data::Kind::string, digits}), digits.substr(0, 4000) + "... (5000 characters)");
  EXPECT_EQ(page::shown(data(R"(["1/3", 2, null])")), "(1/3, 2, -)");
  EXPECT_EQ(page::shown({page::Data::Kind::string, "<b>"}), "&lt;b&gt;");
}

TEST(Facts, SayHowManyPlacesAreNotListed) {
  const auto facts_of = [](std::size_t patches, const std::string& status) {
    std::string all;
    const std::string one = R"({"corners":[{"a":["0","0","0"],"b":["0","0","0"],"on_a":[],"on_b":[]}]})";
    for (std::size_t i = 0; i < patches; ++i) all += (i ? "," : "") + one;
    return page::facts(data(
        fmt::format(R"({{"status":"{}","depth":{{"value":1}},"manifold":{{"patches":[{}]}}}})", status, all).c_str()));
  };
  const std::string listed = facts_of(50, "penetrating"), more = facts_of(53, "disjoint");
  EXPECT_EQ(count(listed, "data-patch"), 50U);
  EXPECT_NE(listed.find("Where they touch then: a point"), std::string::npos);
  EXPECT_EQ(listed.find("more"), std::string::npos);
  EXPECT_EQ(count(more, "data-patch"), 50U);
  EXPECT_NE(more.find("3 more"), std::string::npos) << "law: what is cut is counted";
  EXPECT_NE(more.find("Where they are nearest: a point"), std::string::npos);
  EXPECT_EQ(more.find("touch"), std::string::npos) << "law: bodies that are apart do not touch";
}

stages::Stages of_cubes() {
  stages::Stages made;
  made.id = "two cubes";
  made.status = Status::penetrating;
  made.sum.kind = stages::SumKind::p;
  for (unsigned i = 0; i < 25; ++i) {
    stages::StagedFacet facet;
    facet.squared = mpq_class(i < 2 ? 1 : i * i, 16);
    facet.squared.canonicalize();
    facet.kind = stages::SumFacetKind::edges;
    facet.a = {i};
    facet.b = {i, i + 1};
    facet.optimal = i < 2;
    made.sum.facets.push_back(facet);
  }
  return made;
}

TEST(Page, HoldsItsDataWithoutAnyTag) {
  const stages::Stages made = of_cubes();
  const std::string depth =
      R"({"id":"</script><!--","status":"penetrating","depth":{"value":0.25,"squared":"1/16"},"optima":[{}],"method":"exact"})";
  const std::string text = page::html_page({"1.2.3", depth, made, R"({"id":"<b>"})", {"A is <dented>"}, "<svg></svg>"});
  EXPECT_EQ(count(text, "</script"), 6U) << "law: five blocks and a script, whatever ids hold";
  EXPECT_EQ(text.find("<!--", text.find("<body")), std::string::npos);
  EXPECT_NE(text.find("A is &lt;dented&gt;"), std::string::npos);
  EXPECT_NE(text.find(R"({"id":"\u003cb>"})"), std::string::npos);
  EXPECT_NE(text.find("<svg></svg>"), std::string::npos);
  EXPECT_EQ(count(text.substr(0, text.find("<script")), " hidden>"), 5U)
      << "law: what the script paints waits for it, and so do links there";
  EXPECT_EQ(text.find("{{"), text.find("{{", text.find(page::script().substr(0, 40))))
      << "law: no gap is left open before the script";
}

TEST(Page, RefusesAnAnswerThatIsNone) {
  const stages::Stages made;
  EXPECT_THROW(page::html_page({"1", "[]", made, "{}", {}, ""}), std::invalid_argument);
  EXPECT_THROW(page::html_page({"1", "{", made, "{}", {}, ""}), std::invalid_argument);
}

TEST(Script, HoldsNothingThatEndsItsElement) {
  for (const std::string_view words : {"</script", "<!--"})
    EXPECT_EQ(page::script().find(words), std::string_view::npos) << words;
}

}  // namespace
