// SPDX-License-Identifier: GPL-3.0-or-later
// Each field of a table is everywhere: in JSON, out and in, in differences, schemas, the page of a
// failure, VERDICTS.md, the class of Python, and what Python and C take. That each member of a
// struct has its row, and each number its member in C, the compiler asks.
#include "verify/judge/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "reference/output/result_fields.hpp"
#include "verify/claims/claims.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/report/reports.hpp"
#include "verify/harness/report_fields.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::ordered_json;
using judging::fields_of;
using text::for_each_field;
using Names = std::vector<std::string>;

std::string file_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(std::string(FATHOM_TEST_DATA) + "/../../" + path).rdbuf();
  EXPECT_FALSE(text.str().empty()) << path;
  return text.str();
}

// ---- structs that have everything ----

void fill(bool& value) { value = true; }
void fill(long& value) { value = 7; }
void fill(unsigned& value) { value = 2; }  // a dimension: then points have no z in lines
void fill(std::size_t& value) { value = 8; }
void fill(double& value) { value = 0.1; }
void fill(std::string& value) { value = "a text"; }
void fill(mpq_class& value) { value = mpq_class(2, 3); }
void fill(Verdict& value) { value = Verdict::too_near; }
void fill(Accuracy& value) { value = Accuracy::u_r_16; }
void fill(Status& value) { value = Status::penetrating; }
void fill(Triple& value) { value = {0.5, -1, 2}; }
void fill(Between& value) { value = {0.25, 0.75}; }
void fill(Point& value) { value = {mpq_class(1, 2), mpq_class(-2, 3), 5}; }
void fill(Vector& value) { value = {3, -1, 0}; }
void fill(UnionBounds& value) { value = {mpq_class(1, 6), 3, 4, mpq_class(7, 3)}; }
void fill(std::array<std::uint32_t, 2>& value) { value = {5, 6}; }
void fill(NumberFormat& value) { value = {Precision::binary32, Precision::binary64}; }
void fill(std::set<std::string>& words) { words = {"depth"}; }
void fill(std::map<std::string, std::string>& settings) { settings = {{"tolerance", "1e-4"}}; }
void fill(std::map<std::string, mpq_class>& rounding) { rounding = {{"", mpq_class(1, 2)}}; }
template <class Value>
requires requires(Value value) { judging::words_of(value); }
void fill(Value& value) { value = judging::words_of(value).back().value; }
template <class T>
void fill(std::vector<T>& list);
template <class T>
void fill(std::optional<T>& value);
template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
void fill(Struct& all) {
  for_each_field(fields_of(&all), [&](const auto& field) {
    if constexpr (std::decay_t<decltype(field)>::stored) fill(all.*field.member);
  });
  if constexpr (std::is_same_v<Struct, Judgement>) all.signed_depth.reset();
}
template <class T>
void fill(std::optional<T>& value) {
  fill(value.emplace());
}
template <class T>
void fill(std::vector<T>& list) {
  fill(list.emplace_back());
}

template <class Struct>
Struct filled() {
  Struct all;
  fill(all);
  return all;
}

/// Of unions, which have squares; or of shapes, which have a signed depth in their place, and no
/// bounds of unions.
Judgement filled_judgement(bool of_shapes) {
  auto all = filled<Judgement>();
  if (!of_shapes) return all;
  fill(all.signed_depth);
  all.bounds.reset();
  return all;
}

/// The names of what is there; "witness.a" is in "witness".
template <class Struct>
Names names_in(const Struct& of, bool whole = false) {
  Names names;
  for_each_field(fields_of(&of), [&](const auto& field) {
    if (!text::has(field, of)) return;
    std::string name(field.name.substr(0, whole ? field.name.npos : field.name.find('.')));
    if (names.empty() || names.back() != name) names.push_back(std::move(name));
  });
  return names;
}

Names keys_of(const Json& object) {
  Names keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

// ---- JSON ----

Outcome outcome_with(const Judgement& judgement) {
  auto outcome = filled<Outcome>();
  outcome.judgement = judgement;
  return outcome;
}

TEST(Fields, AreInJsonInOrderAndComeBack) {
  for (const bool of_shapes : {false, true}) {
    const Outcome outcome = outcome_with(filled_judgement(of_shapes));
    const std::string line = outcome_line(outcome);
    const Json json = Json::parse(line);
    Names of_case{"schema", "type"};
    for (const std::string& name : names_in(outcome)) of_case.push_back(name);
    EXPECT_EQ(keys_of(json), of_case);
    EXPECT_EQ(keys_of(json["judgement"]), names_in(*outcome.judgement));
    EXPECT_EQ(keys_of(json["reply"]), names_in(*outcome.reply));
    EXPECT_EQ(keys_of(json["hulls"]), names_in(*outcome.hulls));
    EXPECT_EQ(keys_of(json["pieces"]), names_in(*outcome.pieces));
    EXPECT_EQ(keys_of(json["judgement"]["derivative"]), names_in(*outcome.judgement->derivative));
    EXPECT_EQ(keys_of(json["contact_faults"][0]), names_in(outcome.contact_faults[0]));
    const std::optional<Outcome> read = read_outcome(line);
    ASSERT_TRUE(read) << line;
    EXPECT_EQ(outcome_line(*read), line) << "law: what was written is read as it was";
  }
}

TEST(Fields, DifferInTheirOwnNames) {
  for (const bool of_shapes : {false, true}) {
    const Judgement all = filled_judgement(of_shapes);
    EXPECT_FALSE(difference(all, all));
    for_each_field(judging::judgement_fields, [&](const auto& field) {
      if constexpr (std::decay_t<decltype(field)>::stored) {
        if (!text::has(field, all) || field.name == "signed_depth") return;
        Judgement other = all;
        other.*field.member = Judgement().*field.member;
        const std::string found = difference(all, other).value_or("no difference");
        const Names squares{"depth_squared", "deeper_squared", "extent_missed_squared", "extent_covered_squared"};
        const bool is_derived =  // what follows from it may come first
            std::ranges::find(squares, field.name) != squares.end();
        EXPECT_TRUE(is_derived ? found != "no difference"
                               : found.starts_with("judgement." + std::string(field.name) + ':'))
            << found;
      }
    });
  }
}

// ---- schemas ----

/// What the schema must say of a value.
std::string kind(const bool&) { return "boolean"; }
std::string kind(const std::string&) { return "string"; }
std::string kind(const double&) { return "number"; }
std::string kind(const mpq_class&) { return "rational"; }
std::string kind(const Between&) { return "between"; }
std::string kind(const Triple&) { return "triple"; }
std::string kind(const Verdict&) { return "verdict"; }
template <class T>
std::string kind(const T&) {
  return "";
}
template <class T>
std::string kind(const std::optional<T>& value) {
  return kind(value.value_or(T()));  // the type decides alone
}

/// "rational" stands for "nonnegative" too.
std::string kind_in(const Json& property) {
  if (property.contains("const")) return property["const"].is_boolean() ? "boolean" : "";
  if (property.contains("$ref")) {
    const std::string name = property["$ref"].get<std::string>();
    const std::string last = name.substr(name.rfind('/') + 1);
    return last == "nonnegative" ? "rational" : last;
  }
  return property.value("type", "");
}

template <class Struct>
void expect_described(const Json& object, const Names& first = {}) {
  const Struct all = filled<Struct>();
  Names expected = first;
  for_each_field(fields_of(&all), [&](const auto& field) {
    const std::string name(field.name.substr(0, field.name.find('.')));
    if (expected.empty() || expected.back() != name) expected.push_back(name);
    ASSERT_TRUE(object["properties"].contains(name)) << "law: the schema has " << name;
    const Json& property = object["properties"][name];
    const std::string expected_kind = kind(text::value_of(field, all));
    const bool is_of_one_kind = name == field.name && !expected_kind.empty() && expected_kind != "string";
    EXPECT_TRUE(!is_of_one_kind || kind_in(property) == expected_kind)
        << name << ": " << property << ", " << expected_kind;
    EXPECT_TRUE((!std::is_same_v<Struct, Judgement> || property.value("description", "") == field.meaning))
        << name << ": " << property;
  });
  EXPECT_EQ(keys_of(object["properties"]), expected) << "law: the schema has the fields of the table";
  EXPECT_EQ(object.value("additionalProperties", true), false);
}

TEST(Fields, AreInTheSchemas) {
  const Json schema = Json::parse(file_of("verify/harness/verdict.schema.json"))["$defs"];
  const Names head{"schema", "type"};
  expect_described<Judgement>(schema["judgement"]);
  expect_described<Reply>(schema["reply"]);
  expect_described<ContactPoint>(schema["reply"]["properties"]["contacts"]["items"]);
  expect_described<AboutHulls>(schema["hulls"]);
  expect_described<AboutPieces>(schema["case"]["properties"]["pieces"]);
  expect_described<DerivativeJudgement>(schema["derivative"]);
  const Json& fault = schema["contact_fault"]["properties"];
  expect_described<judging::ContactFault>(schema["contact_fault"]);
  expect_described<patch::TwoPlanes>(fault["planes"]);
  expect_described<patch::LineOverlap>(fault["lines"]["items"]);
  expect_described<judging::MissedPoint>(fault["missed"]["items"]);
  expect_described<Outcome>(schema["case"], head);
  expect_described<Unattributed>(schema["unattributed"], head);
  const Json protocol = Json::parse(file_of("verify/harness/subject.schema.json"))["$defs"]["reply"]["properties"];
  for (const std::string& name : names_in(filled<Reply>()))
    EXPECT_TRUE(protocol.contains(name)) << "law: the protocol has " << name;
}

/// Each field in order, with its meaning.
template <class... Rows>
void expect_described(const std::tuple<Rows...>& table, const Json& object, const Names& first) {
  Names expected = first;
  for_each_field(table, [&](const auto& field) {
    expected.emplace_back(field.name);
    EXPECT_EQ(object["properties"].value(expected.back(), Json::object()).value("description", ""), field.meaning)
        << "law: the schema has " << field.name;
  });
  EXPECT_EQ(keys_of(object["properties"]), expected) << "law: the schema has the fields of the table";
  EXPECT_EQ(object.value("additionalProperties", true), false);
}

TEST(Fields, OfResultsAndClaimsAreInTheirSchemas) {
  const Names head{"schema", "fathom"};
  const auto schema = [](const std::string& path) { return Json::parse(file_of(path)); };
  expect_described(output::result_fields, schema("reference/output/result.schema.json")["$defs"]["result"], head);
  expect_described(output::union_result_fields, schema("reference/output/union.schema.json")["$defs"]["union"], head);
  const Json claim = schema("verify/claims/claim.schema.json");
  expect_described(claims::claim_fields, claim, head);
  expect_described(claims::statement_fields, claim["properties"]["statements"]["items"], {});
}

TEST(Fields, OfTheSummaryAreInTheSchema) {
  const Json defs = Json::parse(file_of("verify/harness/verdict.schema.json"))["$defs"];
  const auto expect_names = [](const auto& table, const Json& object, const Names& first = {}) {
    Names expected = first;
    for_each_field(table, [&](const auto& field) { expected.emplace_back(field.name); });
    EXPECT_EQ(keys_of(object["properties"]), expected) << "law: the schema has the fields of the table";
  };
  const Json& of = defs["summary"]["properties"];
  expect_names(totals_fields, defs["summary"], {"schema", "type"});
  expect_names(coverage_fields, of["judged"]);
  expect_names(times_fields, of["microseconds"]);
  expect_names(hull_count_fields, of["hulls"]);
  expect_names(union_count_fields, of["unions"]);
  expect_names(relative_excess_fields, of["relative_excess"]);
  expect_names(part_fields, defs["part"]);
  expect_names(most_fields, defs["most_of_unions"]);
  expect_names(longest_fields, defs["most"]);
}

TEST(Fields, OfAHelloComeBackAndAreInTheSchema) {
  auto all = filled<SubjectInfo>();
  all.shapes = {"sphere"};
  fill(all.conventions.manifold);
  const std::string text = hello_text(all);
  const Json json = Json::parse(text),
             schema = Json::parse(file_of("verify/harness/subject.schema.json"))["$defs"]["hello"];
  Names expected{"type", "protocol"};
  for (const std::string_view name : text::names_of(hello_fields)) expected.emplace_back(name);
  EXPECT_EQ(keys_of(json), expected);
  EXPECT_EQ(keys_of(schema["properties"]), expected) << "law: the schema has the fields of the table";
  EXPECT_EQ(keys_of(json["conventions"]), names_in(all.conventions));
  EXPECT_EQ(keys_of(schema["properties"]["conventions"]["properties"]), names_in(all.conventions));
  EXPECT_EQ(keys_of(schema["properties"]["capabilities"]["properties"]), keys_of(json["capabilities"]));
  EXPECT_EQ(keys_of(schema["properties"]["manifold"]["properties"]), names_in(*all.conventions.manifold));
  for (const unsigned dimension : {2U, 3U}) {
    all.dimension = dimension;
    all.wants_twist = dimension == 3;
    all.shapes = {dimension == 3 ? "sphere" : "circle"};
    EXPECT_EQ(hello_text(read_hello(hello_text(all))), hello_text(all)) << "law: what was written is read as it was";
  }
  const std::string python = file_of("bindings/python/fathom/_questions.py");
  for (const std::string& name : names_in(all.conventions))  // the sign of a depth, beside the depth itself
    EXPECT_NE(python.find((name == "depth" ? "sign" : name) + ": "), std::string::npos)
        << "law: Python's judge takes " << name;
}

// ---- pages ----

TEST(Fields, OfAJudgementAreOnThePageOfAFailure) {
  for (const bool of_shapes : {false, true}) {
    const Outcome outcome = outcome_with(filled_judgement(of_shapes));
    SubjectInfo subject;
    subject.name = "s";
    const std::string page = failure_article(subject, {outcome, Case{"a text", {}, {}}, ""}, "f1");
    for_each_field(judging::judgement_fields, [&](const auto& field) {
      if constexpr (requires { field.label; }) {
        const bool is_there = !text::has(field, *outcome.judgement) || page.find(std::string(field.label)) != page.npos;
        EXPECT_TRUE(is_there) << "law: the residuals have " << field.name;
      }
      using Value = std::decay_t<decltype(text::value_of(field, *outcome.judgement))>;
      constexpr bool is_exact = std::is_same_v<Value, mpq_class> || std::is_same_v<Value, std::optional<mpq_class>>;
      if (!is_exact || !text::has(field, *outcome.judgement)) return;
      const std::string name(field.name.substr(0, field.name.size() - std::string_view("_squared").size()));
      EXPECT_TRUE(page.find('\n' + name + "^2 = ") != page.npos || page.find('>' + name + "^2 = ") != page.npos)
          << "law: the exact numbers have " << field.name;
    });
    EXPECT_EQ(page.find("\ndeepest_pair^2 = 1/6\n") == std::string::npos, of_shapes);
  }
}

/// The words of a text with one blank between them.
std::string words_of(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

TEST(Fields, OfAJudgementAreInVerdictsMd) {
  const std::string page = words_of(file_of("verify/judge/VERDICTS.md"));
  for_each_field(judging::judgement_fields, [&](const auto& field) {
    std::ostringstream entry;
    entry << "- `" << field.name << '`' << (field.unit.empty() ? "" : ", ") << field.unit
          << (field.since == text::first_version ? "" : ", since " + std::string(field.since)) << ": " << field.meaning;
    EXPECT_NE(page.find(entry.str()), std::string::npos) << "law: the page has this entry:\n" << entry.str();
  });
}

// ---- Python and C ----

/// How Python types a value.
template <class Value>
std::string annotation() {
  if constexpr (std::is_same_v<Value, bool>) return "bool";
  if constexpr (std::is_same_v<Value, std::vector<Verdict>>) return "list[str]";
  if constexpr (std::is_same_v<Value, mpq_class> || std::is_same_v<Value, std::optional<mpq_class>>)
    return "Fraction | None";
  if constexpr (std::is_same_v<Value, std::optional<double>>) return "float | None";
  if constexpr (std::is_same_v<Value, std::optional<Between>>) return "tuple[float, float] | None";
  if constexpr (std::is_same_v<Value, std::optional<Accuracy>>) return "str | None";
  if constexpr (std::is_same_v<Value, std::optional<UnionBounds>> ||
                std::is_same_v<Value, std::optional<DerivativeJudgement>>)
    return "dict[str, Any] | None";
  return "str";
}

TEST(Fields, OfAJudgementAreInPythonsClass) {
  const std::string text = file_of("bindings/python/fathom/_questions.py");
  const std::size_t begin = text.find("class Judgement(NamedTuple)");
  const std::string body = text.substr(begin, text.find("\ndef judge(", begin) - begin);
  const std::regex row("\n    ([a-z_]+): ([^#\n]*[^# \n])");
  Names found, expected{"passed: bool"};
  for (std::sregex_iterator at(body.begin(), body.end(), row), end; at != end; ++at)
    found.push_back((*at)[1].str() + ": " + (*at)[2].str());
  for_each_field(judging::judgement_fields, [&](const auto& field) {
    using Value = std::decay_t<decltype(text::value_of(field, std::declval<const Judgement&>()))>;
    expected.push_back(std::string(field.name) + ": " + annotation<Value>());
  });
  EXPECT_EQ(found, expected) << "law: Python's class has the fields of the table, in order";
}

TEST(Fields, OfAReplyAreTakenByPythonAndC) {
  const std::string python = file_of("bindings/python/fathom/_questions.py"), c = file_of("include/fathom/fathom.h");
  const std::string judge = python.substr(python.find("\ndef judge("));
  const std::size_t begin = c.find("typedef struct fathom_claim {");
  const std::string claim = c.substr(begin, c.find("} fathom_claim;") - begin);
  for_each_field(judging::reply_fields, [&](const auto& field) {
    const std::string name(field.name), part = name.substr(0, name.find('.'));
    EXPECT_NE(judge.find(' ' + part + ": "), std::string::npos) << "law: Python's judge takes " << part;
    const std::string member =
        std::regex_replace(name == "contacts" ? "contact_positions" : name, std::regex("[.]"), "_");
    EXPECT_TRUE(std::regex_search(claim, std::regex("[ *]" + member + "(\\[3\\])?[,;]")))
        << "law: fathom_claim has " << member;
  });
}

}  // namespace
}  // namespace fathom::harness
