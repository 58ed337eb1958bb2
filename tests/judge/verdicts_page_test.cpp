// SPDX-License-Identifier: GPL-3.0-or-later
// The page verify/judge/VERDICTS.md tells the truth: it has a section for each verdict, in order of
// rank, and its examples are judged as it says.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"

namespace fathom::judging {
namespace {

using Json = nlohmann::json;

struct Section {
  std::string title;
  std::vector<Json> examples;
  std::vector<std::string> commands;
};

std::vector<Section> sections_of_page() {
  std::ifstream page(std::string(FATHOM_TEST_DATA) + "/../../verify/judge/VERDICTS.md");
  std::vector<Section> sections;
  std::string line;
  while (std::getline(page, line)) {
    if (line.starts_with("## ")) sections.push_back({line.substr(3), {}, {}});
    if (!line.starts_with("```")) continue;
    const std::string language = line.substr(3);
    std::string block;
    while (std::getline(page, line) && line != "```") block += line + "\n";
    if (language == "json") sections.back().examples.push_back(Json::parse(block));
    if (language == "sh") sections.back().commands.push_back(block);
  }
  return sections;
}

double number(const Json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

std::optional<Triple> triple(const Json& object, const char* key) {
  if (!object.contains(key)) return std::nullopt;
  const Json& v = object[key];
  return Triple{number(v.at(0)), number(v.at(1)), number(v.at(2))};
}

Reply reply_of(const Json& json, Precision precision) {
  Reply reply;
  reply.overlap = json.at("overlap").get<bool>();
  if (json.contains("depth")) reply.depth = number(json["depth"]);
  if (reply.depth && precision == Precision::binary32) reply.depth = static_cast<float>(*reply.depth);
  if (json.contains("distance")) reply.distance = number(json["distance"]);
  if (json.contains("derivative")) reply.derivative = number(json["derivative"]);
  reply.direction = triple(json, "direction");
  const Json witness = json.value("witness", Json::object());
  reply.witness_a = triple(witness, "a");
  reply.witness_b = triple(witness, "b");
  for (const Json& contact : json.value("contacts", Json::array()))
    reply.contacts.push_back({triple(contact, "position").value(),
                              contact.contains("depth") ? std::optional(number(contact["depth"])) : std::nullopt});
  return reply;
}

Conventions conventions_of(const Json& json) {
  using Touching = Conventions::Touching;
  const std::map<std::string, Touching> touching{
      {"either", Touching::either}, {"overlap", Touching::overlap}, {"separate", Touching::separate}};
  Conventions result;
  result.touching = touching.at(json.value("touching", "either"));
  result.depth =
      json.value("depth", "positive") == "negative" ? Conventions::Sign::negative : Conventions::Sign::positive;
  result.moves = json.value("moves", "a") == "b" ? Conventions::Body::b : Conventions::Body::a;
  result.unit = json.value("unit", true);
  if (json.contains("manifold"))
    result.manifold = ContactLimits{
        json["manifold"].value("most", 0U) > 0 ? std::optional<std::size_t>(json["manifold"]["most"]) : std::nullopt,
        json["manifold"].value("margin", 0.0)};
  result.claims =
      json.value("claims", "minimum") == "separating" ? Conventions::Claims::separating : Conventions::Claims::minimum;
  return result;
}

Judgement judged(const Json& example, const Json& usual_case) {
  const CaseItem item = parse_case(example.value("case", usual_case).dump(), "VERDICTS.md");
  const Precision precision =
      example.value("precision", "binary64") == "binary32" ? Precision::binary32 : Precision::binary64;
  Tolerance tolerance;
  const Json off_by = example.value("tolerance", Json::object());
  if (off_by.contains("relative")) tolerance.relative = mpq_class(off_by["relative"].get<std::string>());
  if (off_by.contains("patch_slack")) tolerance.patch_slack = mpq_class(off_by["patch_slack"].get<std::string>());
  const Reply reply = reply_of(example.at("reply"), precision);
  const Conventions conventions = conventions_of(example.value("conventions", Json::object()));
  if (item.value().b.pieces)
    return judge(truth_about(pieces_of(item.value().a), pieces_of(item.value().b)), reply, conventions, precision,
                 tolerance);
  const Truth truth = truth_about(*seen(item.value().a.points, precision), *seen(item.value().b.points, precision));
  return judge(truth, reply, conventions, precision, tolerance, item.value().motion);
}

TEST(VerdictsPage, HasASectionForEachVerdictInOrder) {
  const std::vector<Section> sections = sections_of_page();
  ASSERT_EQ(sections.size(), static_cast<std::size_t>(Verdict::pass) + 2);
  EXPECT_EQ(sections.front().title, "Words");
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const auto verdict = static_cast<Verdict>(i - 1);
    EXPECT_EQ(sections[i].title, name(verdict));
    EXPECT_EQ(verdict_named(sections[i].title), verdict);
    const bool of_a_harness =
        verdict <= Verdict::failed || verdict == Verdict::not_invariant || verdict == Verdict::unsupported;
    EXPECT_EQ(sections[i].examples.empty(), of_a_harness) << sections[i].title;
    EXPECT_EQ(sections[i].commands.empty(), !of_a_harness) << sections[i].title;
    for (const std::string& command : sections[i].commands)
      EXPECT_TRUE(command.starts_with("fathom certify ")) << command;
  }
  EXPECT_FALSE(verdict_named("too deep"));
}

TEST(VerdictsPage, ItsExamplesAreJudgedAsItSays) {
  const std::vector<Section> sections = sections_of_page();
  const Json usual = sections.at(0).examples.at(0).at("case");
  std::size_t examples = 0;
  for (std::size_t i = 1; i < sections.size(); ++i) {
    for (const Json& example : sections[i].examples) {
      const Judgement result = judged(example, usual);
      EXPECT_EQ(name(result.verdict), example.at("verdict").get<std::string>()) << result.sentence;
      const auto verdict = static_cast<Verdict>(i - 1);
      const bool is_found = std::ranges::find(result.findings, verdict) != result.findings.end();
      EXPECT_TRUE(result.verdict == verdict || (verdict == Verdict::tips && is_found)) << "it never stands alone";
      EXPECT_EQ(result.sentence, example.at("says").get<std::string>());
      const std::string accuracy = example.value("accuracy", "");
      EXPECT_EQ(result.accuracy ? name(*result.accuracy) : "", accuracy);
      ++examples;
    }
  }
  EXPECT_GE(examples, 14U);
}

}  // namespace
}  // namespace fathom::judging
