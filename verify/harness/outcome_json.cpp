// SPDX-License-Identifier: GPL-3.0-or-later
// Outcomes as lines of schema fathom/verdict/1.
#include <gmpxx.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/judge/policy.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', true, Json::error_handler_t::replace); }

Json line_of(const char* type) { return {{"schema", "fathom/verdict/1"}, {"type", type}}; }

Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

Json triple(const Triple& t) { return {number(t[0]), number(t[1]), number(t[2])}; }

Json reply_json(const Reply& reply) {
  Json json = {{"overlap", reply.overlap}};
  if (reply.depth) json["depth"] = number(*reply.depth);
  if (reply.distance) json["distance"] = number(*reply.distance);
  if (reply.direction) json["direction"] = triple(*reply.direction);
  if (reply.witness_a) json["witness"]["a"] = triple(*reply.witness_a);
  if (reply.witness_b) json["witness"]["b"] = triple(*reply.witness_b);
  for (const ContactPoint& contact : reply.contacts) {
    Json each = {{"position", triple(contact.position)}};
    if (contact.depth) each["depth"] = number(*contact.depth);
    json["contacts"].push_back(std::move(each));
  }
  return json;
}

void put(Json& json, const char* name, const std::optional<double>& value) {
  if (value) json[name] = number(*value);
}
void put(Json& json, const char* name, const std::optional<mpq_class>& value) {
  if (value) json[name] = exact_text(*value);
}

void put(Json& json, const char* name, const std::optional<Between>& value) {
  if (value) json[name] = {{"low", number(value->low)}, {"high", number(value->high)}};
}

Json judgement_json(const Judgement& j) {
  Json json = {{"verdict", name(j.verdict)}, {"status", j.status ? name(*j.status) : "undecided"}};
  if (j.signed_depth) put(json, "signed_depth", j.signed_depth);
  else json["depth_squared"] = exact_text(j.depth_squared), json["distance_squared"] = exact_text(j.distance_squared);
  json["findings"] = Json::array();
  for (const Verdict finding : j.findings) json["findings"].push_back(name(finding));
  if (j.accuracy) json["accuracy"] = name(*j.accuracy);
  put(json, "error", j.error);
  put(json, "error_ulps", j.error_ulps);
  put(json, "error_relative", j.error_relative);
  put(json, "error_u_r", j.error_u_r);
  put(json, "price_squared", j.price_squared);
  put(json, "travel_squared", j.travel_squared);
  put(json, "price", j.price);
  put(json, "inconsistency", j.inconsistency);
  put(json, "overlap_left", j.overlap_left);
  put(json, "witness_a_squared", j.witness_a_squared);
  put(json, "witness_b_squared", j.witness_b_squared);
  put(json, "witness_a_distance", j.witness_a_distance);
  put(json, "witness_b_distance", j.witness_b_distance);
  put(json, "witness_gap", j.witness_gap);
  put(json, "contact_a_squared", j.contact_a_squared);
  put(json, "contact_b_squared", j.contact_b_squared);
  put(json, "contact_a_distance", j.contact_a_distance);
  put(json, "contact_b_distance", j.contact_b_distance);
  put(json, "deepest", j.deepest);
  put(json, "dearer", j.dearer);
  if (j.longer) json["longer"] = true;
  if (j.bounds) {
    const UnionBounds& bounds = *j.bounds;
    json["deepest_pair"] = {{"squared", exact_text(bounds.deepest_pair)}, {"pieces", {bounds.a, bounds.b}}};
    json["hulls_squared"] = exact_text(bounds.hulls);
    json["deeper_than_pair"] = number(root_binary64(j.depth_squared / bounds.deepest_pair, Rounding::rn));
  }
  if (j.deeper_squared) {
    json["deeper"] = number(root_binary64(*j.deeper_squared, Rounding::rn));
    json["deeper_squared"] = exact_text(*j.deeper_squared);
  }
  json["sentence"] = j.sentence;
  return json;
}

Json part_json(const TallyRow& row) {
  Json json = {{"cases", row.total}, {"passed", row.passes()}, {"failed", row.failures()}, {"unsupported", row[Verdict::unsupported]}};
  json["verdicts"] = Json::object();
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (row.verdicts[i] > 0) json["verdicts"][name(static_cast<Verdict>(i))] = row.verdicts[i];
  return json;
}

}  // namespace

std::string outcome_line(const Outcome& outcome) {
  Json json = line_of("case");
  json["id"] = outcome.id;
  if (!outcome.variant.empty()) json["variant"] = outcome.variant;
  json["digest"] = outcome.digest;
  json["solid"] = outcome.solid;
  json["metre_sized"] = outcome.metre_sized;
  json["verdict"] = name(outcome.verdict);
  if (!outcome.detail.empty()) json["detail"] = outcome.detail;
  json["seconds"] = number(outcome.seconds);
  if (outcome.microseconds) json["microseconds"] = number(*outcome.microseconds);
  if (outcome.fit != 0) json["fit"] = outcome.fit;
  if (outcome.radii != 0) json["radii"] = exact_text(outcome.radii);
  if (outcome.reply) json["reply"] = reply_json(in_unit(*outcome.reply, -outcome.fit));
  if (outcome.judgement) json["judgement"] = judgement_json(*outcome.judgement);
  if (outcome.hulls) {
    const AboutHulls& hulls = *outcome.hulls;
    json["hulls"] = {{"query", judgement_json(hulls.query)},
                     {"lost", number(root_binary64(hulls.lost_squared, Rounding::rn))},
                     {"lost_squared", exact_text(hulls.lost_squared)},
                     {"grown", number(root_binary64(hulls.grown_squared, Rounding::rn))},
                     {"grown_squared", exact_text(hulls.grown_squared)}};
  }
  if (outcome.pieces) {
    const AboutPieces& pieces = *outcome.pieces;
    json["pieces"] = {{"pairs", pieces.pairs}, {"answer_of", {pieces.a, pieces.b}}, {"query", judgement_json(pieces.query)}};
  }
  return dumped(json);
}

std::string unattributed_line(const Unattributed& unattributed) {
  Json json = line_of("unattributed");
  if (unattributed.after) json["after"] = *unattributed.after;
  json["detail"] = unattributed.detail;
  return dumped(json);
}

std::string header_line(const SubjectInfo& info, const Tolerance& tolerance, const RunInfo& from) {
  Json json = line_of("header");
  json["fathom"] = from.version;
  json["command"] = from.command;
  json["subject"] = Json::parse(hello_text(info));
  json["tolerance"] = {
      {"relative", exact_text(tolerance.relative)}, {"absolute", exact_text(tolerance.absolute)}, {"ulps", tolerance.ulps}};
  if (from.fit) json["fit"] = exact_text(*from.fit);
  json["policy"] = judging::policy_text(tolerance.policy);
  for (const Method method : from.second) json["methods"].push_back(name(method));
  return dumped(json);
}

std::string summary_line(const Totals& totals) {
  Json json = line_of("summary");
  json["cases"] = totals.cases;
  json["passed"] = totals.passed;
  json["failed"] = totals.failed;
  json["unsupported"] = totals.unsupported;
  json["unattributed"] = totals.unattributed;
  const Coverage& judged = totals.judged;
  json["judged"] = {{"overlap", judged.overlap},     {"overlapping", judged.overlapping}, {"depth", judged.depth},
                    {"direction", judged.direction}, {"witness", judged.witness},         {"contacts", judged.contacts},
                    {"distance", judged.distance}};
  if (totals.times && !totals.times->empty())
    json["microseconds"] = {{"answers", totals.times->count()},
                            {"median", number(totals.times->median())},
                            {"worst", number(totals.times->worst().amount)},
                            {"worst_case", totals.times->worst().id}};
  if (totals.hulls && totals.hulls->count > 0) {
    const HullCount& hulls = *totals.hulls;
    json["hulls"] = {{"answers", hulls.count}, {"query_passed", hulls.passed}};
    for (const auto& [name, most] : {std::pair("lost", &hulls.lost), {"grown", &hulls.grown}})
      json["hulls"][name] = {{"length", number(most->amount)}, {"case", most->id}};
  }
  if (totals.unions && totals.unions->count > 0) {
    const UnionCount& unions = *totals.unions;
    json["unions"] = {
        {"overlapping", unions.count}, {"pair_enough", unions.enough}, {"answers", unions.answers}, {"deeper", unions.deeper}};
    for (const auto& [name, most] : {std::pair("times", &unions.times), {"by", &unions.by}})
      if (!most->id.empty()) json["unions"][name] = {{"amount", number(most->amount)}, {"case", most->id}};
  }
  if (totals.all && !totals.all->dearer.empty())
    json["dearer"] = {{"answers", totals.all->dearer.size()},
                      {"median", number(totals.all->dearer.median())},
                      {"worst", number(totals.all->dearer.worst())},
                      {"longer_pass", totals.all->longer}};
  for (const Tally::Line& part : totals.parts) json["parts"][part.label] = part_json(part.row);
  return dumped(json);
}

}  // namespace fathom::harness
