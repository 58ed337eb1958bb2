// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of tests/data/judged.jsonl: what the judge finds is the same in C++ and in C. Python
// reads them in tests/python/test_judged.py, the program in tests/cli/judged_test.py.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "fathom/fathom.h"
#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "reference/text/json_value.hpp"
#include "tests/c/handles.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/judge/truth.hpp"

namespace fathom {
namespace {

using text::JsonValue;

/// What is asked about one pair of bodies, and what is to be found.
struct Row {
  std::string bodies, what;  ///< a case; the row, for messages
  Reply reply;
  NumberFormat format;
  Conventions conventions;
  Tolerance tolerance;
  std::vector<Verdict> found;
  std::map<std::string, std::string, std::less<>> told;  ///< fields of the judgement, as they are written
};

std::string written(const JsonValue* value, const std::string& otherwise = "") {
  return value ? value->written().text() : otherwise;
}

/// A hello that says what the row declares, and else the usual.
harness::SubjectInfo declared(const JsonValue* row) {
  const auto word = [&](std::string_view name, const std::string& usual) {
    return written(row ? row->find(name) : nullptr, usual);
  };
  const std::string points = word("precision", "\"binary64\""), manifold = word("manifold", "");
  return harness::read_hello(
      R"({"type":"hello","protocol":"fathom/subject/1","name":"row","version":"1","precision":{"points":)" + points +
      R"(,"answers":)" + word("answers", points) + R"(},"conventions":{"touching":)" + word("touching", "\"either\"") +
      R"(,"depth":)" + word("depth", "\"positive\"") + R"(,"moves":)" + word("moves", "\"a\"") + R"(,"unit":)" +
      word("unit", "true") + R"(,"claims":)" + word("claims", "\"minimum\"") + "}" +
      (manifold.empty() ? "" : R"(,"manifold":)" + manifold) + "}");
}

Tolerance tolerance(const JsonValue* row) {
  Tolerance result;
  if (!row) return result;
  if (const JsonValue* const q = row->find("relative"))
    result.relative = *parse_number(q->text(), Decimals::exact).value;
  if (const JsonValue* const q = row->find("absolute"))
    result.absolute = *parse_number(q->text(), Decimals::exact).value;
  if (const JsonValue* const n = row->find("ulps")) result.ulps = static_cast<unsigned long>(n->number());
  if (const JsonValue* const policy = row->find("policy")) result.policy = *judging::policy_of(policy->text());
  return result;
}

Row row_of(const JsonValue& json, const std::string& bodies) {
  const harness::SubjectInfo hello = declared(json.find("declared"));
  std::string reply = written(json.find("reply"));
  reply = R"({"type":"reply","id":"1",)" + reply.substr(1);
  Row row{bodies,
          json.written().text(),
          std::get<Reply>(harness::read_reply(reply, hello.format).said),
          hello.format,
          hello.conventions,
          tolerance(json.find("by")),
          {},
          {}};
  for (const JsonValue& name : json.find("found")->items()) row.found.push_back(verdict_named(name.text()).value());
  if (const JsonValue* const told = json.find("told"))
    for (const auto& [name, value] : told->fields()) row.told.emplace(name, value->written().text());
  return row;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    std::vector<Row> result;
    std::map<std::string, std::string> pairs;
    std::ifstream file(FATHOM_TEST_DATA "/judged.jsonl");
    for (std::string line; std::getline(file, line);) {
      const JsonValue json = text::read_json(line).value;
      if (const JsonValue* const name = json.find("pair")) pairs[name->text()] = line;
      else result.push_back(row_of(json, pairs.at(json.find("of")->text())));
    }
    return result;
  }();
  return all;
}

Judgement judged(const Row& row) {
  const Case pair = std::get<Case>(parse_case(row.bodies, "judged.jsonl", 1).outcome);
  const auto a = judging::body_seen(pair.a, row.format), b = judging::body_seen(pair.b, row.format);
  return judging::judged(judging::truth_of(*a, *b), row.reply, row.conventions, row.format, row.tolerance);
}

TEST(JudgedRows, InCpp) {
  EXPECT_GT(rows().size(), 250U);
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.what);
    harness::Outcome outcome;
    const Judgement& found = outcome.judgement.emplace(judged(row));
    EXPECT_EQ(found.findings, row.found) << found.sentence;
    const Verdict passed = found.status == Status::touching ? Verdict::touching_by_convention : Verdict::pass;
    EXPECT_EQ(found.verdict, row.found.empty() ? passed : row.found.front());
    EXPECT_FALSE(found.sentence.empty() || found.sentence.find('\n') != std::string::npos);
    const JsonValue line = text::read_json(harness::outcome_line(outcome)).value;
    for (const auto& [name, value] : row.told)
      EXPECT_EQ(written(line.find("judgement")->find(name), "null"), value) << name;
  }
}

fathom_claim claim_of(const Row& row, std::vector<double>& positions, std::vector<double>& depths) {
  fathom_claim claim;
  fathom_claim_init(&claim);
  const Conventions& by = row.conventions;
  const auto precision = [](Precision p) { return p == Precision::binary32 ? FATHOM_BINARY32 : FATHOM_BINARY64; };
  claim.precision = precision(row.format.points);
  claim.answers = precision(row.format.answers);
  claim.touching = by.touching == Conventions::Touching::either    ? FATHOM_TOUCHING_EITHER
                   : by.touching == Conventions::Touching::overlap ? FATHOM_TOUCHING_IS_OVERLAP
                                                                   : FATHOM_TOUCHING_IS_APART;
  claim.depth_negative = by.depth == Conventions::Sign::negative;
  claim.moves_b = by.moves == Conventions::Body::b;
  claim.not_unit = !by.unit;
  claim.separating = by.claims == Conventions::Claims::separating;
  claim.has_manifold = by.manifold.has_value();
  if (by.manifold) claim.most_contacts = by.manifold->most.value_or(0);
  claim.tol_relative = row.tolerance.relative.get_d();
  claim.tol_absolute = row.tolerance.absolute.get_d();
  claim.tol_ulps = static_cast<double>(row.tolerance.ulps);
  claim.policy = static_cast<int>(row.tolerance.policy.kind);
  claim.policy_most = row.tolerance.policy.most.get_d();
  const Reply& reply = row.reply;
  const auto point = [](const std::optional<Triple>& from, double(&to)[3], int& has) {
    has = from.has_value();
    if (from) std::copy(from->begin(), from->end(), to);
  };
  claim.overlap = reply.overlap;
  claim.has_depth = reply.depth.has_value();
  claim.depth = reply.depth.value_or(0);
  claim.has_distance = reply.distance.has_value();
  claim.distance = reply.distance.value_or(0);
  point(reply.direction, claim.direction, claim.has_direction);
  point(reply.witness_a, claim.witness_a, claim.has_witness_a);
  point(reply.witness_b, claim.witness_b, claim.has_witness_b);
  for (const ContactPoint& contact : reply.contacts) {
    positions.insert(positions.end(), contact.position.begin(), contact.position.end());
    if (contact.depth) depths.push_back(*contact.depth);
  }
  claim.contact_count = reply.contacts.size();
  claim.contact_positions = positions.data();
  claim.contact_depths = depths.empty() ? nullptr : depths.data();
  return claim;
}

/// NaN, or a length by its signed square, rounded: what C has of it.
double rounded(const std::optional<mpq_class>& square, Rounding mode) {
  return square ? round_binary64(Surd{0, *square}, mode) : NAN;
}
void expect_equal(double found, const std::optional<double>& expected, const char* what) {
  if (expected && !std::isnan(*expected)) EXPECT_EQ(found, *expected) << what;
  else EXPECT_TRUE(std::isnan(found)) << what;
}
void expect_between(double low, double high, const std::optional<mpq_class>& square,
                    const std::optional<Between>& bounds, const char* what) {
  expect_equal(low, bounds ? bounds->low : rounded(square, Rounding::rd), what);
  expect_equal(high, bounds ? bounds->high : rounded(square, Rounding::ru), what);
}

void expect_equal(const fathom_judgement& found, const Judgement& expected) {
  unsigned findings = 0;
  for (const Verdict verdict : expected.findings)
    for (int i = 0; fathom_verdict_name(i); ++i)
      if (name(verdict) == fathom_verdict_name(i)) findings |= 1U << i;
  EXPECT_EQ(found.findings, findings);
  EXPECT_EQ(fathom_verdict_name(found.verdict), name(expected.verdict));
  EXPECT_EQ(found.accuracy, expected.accuracy ? static_cast<int>(*expected.accuracy) : FATHOM_NO_CLASS);
  EXPECT_EQ(fathom_status_name(found.status), name(expected.status.value()));
  EXPECT_EQ(found.excess_allowed != 0, expected.excess_allowed);
  const bool apart = expected.status == Status::disjoint;
  if (!expected.signed_depth) {
    const mpq_class truth = apart ? mpq_class(-expected.distance_squared) : expected.depth_squared;
    expect_between(found.signed_depth_low, found.signed_depth_high, truth, {}, "signed_depth");
  }
  EXPECT_LE(found.signed_depth_low, found.signed_depth_high);
  EXPECT_FALSE(found.signed_depth < found.signed_depth_low || found.signed_depth > found.signed_depth_high);
  expect_equal(found.error, expected.error, "error");
  expect_equal(found.error_ulps, expected.error_ulps, "error_ulps");
  expect_equal(found.error_relative, expected.error_relative, "error_relative");
  expect_equal(found.error_u_r, expected.error_u_r, "error_u_r");
  expect_equal(found.inconsistency, expected.inconsistency, "inconsistency");
  expect_equal(found.overlap_left, expected.overlap_left, "overlap_left");
  expect_equal(found.witness_gap, expected.witness_gap, "witness_gap");
  expect_equal(found.deepest, expected.deepest, "deepest");
  expect_equal(found.relative_excess, expected.relative_excess, "relative_excess");
  expect_equal(found.exit_distance, rounded(expected.exit_distance_squared, Rounding::rn), "exit_distance");
  expect_between(found.separating_distance_low, found.separating_distance_high, expected.separating_distance_squared,
                 expected.separating_distance, "separating_distance");
  expect_between(found.witness_a_low, found.witness_a_high, expected.witness_a_squared, expected.witness_a_distance,
                 "witness_a");
  expect_between(found.witness_b_low, found.witness_b_high, expected.witness_b_squared, expected.witness_b_distance,
                 "witness_b");
  expect_between(found.contact_a_low, found.contact_a_high, expected.contact_a_squared, expected.contact_a_distance,
                 "contact_a");
  expect_between(found.contact_b_low, found.contact_b_high, expected.contact_b_squared, expected.contact_b_distance,
                 "contact_b");
  const auto& bounds = expected.bounds;
  const auto root = [](const mpq_class& square) { return root_binary64(square, Rounding::rn); };
  expect_equal(found.deepest_pair, bounds ? root(bounds->deepest_pair) : NAN, "deepest_pair");
  expect_equal(found.hulls, bounds ? root(bounds->hulls) : NAN, "hulls");
  expect_equal(found.deeper_than_pair, bounds ? root(expected.depth_squared / bounds->deepest_pair) : NAN, "pair");
  expect_equal(found.deeper, expected.deeper_squared ? root(*expected.deeper_squared) : NAN, "deeper");
  EXPECT_EQ(found.deepest_pieces[0], bounds ? bounds->a : 0);
  EXPECT_EQ(found.deepest_pieces[1], bounds ? bounds->b : 0);
}

// C has depths of all contacts or of none, and a margin of its own.
TEST(JudgedRows, InC) {
  std::size_t count = 0;
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.what);
    std::vector<double> positions, depths;
    const fathom_claim claim = claim_of(row, positions, depths);
    if (!depths.empty() && depths.size() < row.reply.contacts.size()) continue;
    fathom_body *a = nullptr, *b = nullptr;
    ASSERT_EQ(fathom_bodies_from_case(row.bodies.c_str(), &a, &b), FATHOM_OK) << fathom_last_error();
    const testing::BodyHandle own_a(a), own_b(b);
    fathom_judgement found;
    fathom_judgement_init(&found);
    char* text = nullptr;
    ASSERT_EQ(fathom_judge(a, b, &claim, &found, &text), FATHOM_OK) << fathom_last_error();
    const Judgement expected = judged(row);
    EXPECT_EQ(testing::taken(text), expected.sentence);
    expect_equal(found, expected);
    ++count;
  }
  EXPECT_GT(count, 250U);
}

}  // namespace
}  // namespace fathom
