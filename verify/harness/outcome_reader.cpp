// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of schema fathom/verdict/1 back as outcomes. Whatever is not exactly as it was written is refused by an exception inside.
#include <limits>
#include <nlohmann/json.hpp>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/journal.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::json;

struct Unreadable {};

double number(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const std::string text = json.get<std::string>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw Unreadable();
}

mpq_class exact(const Json& json) {
  const ParsedNumber parsed = parse_number(json.get_ref<const std::string&>(), Decimals::exact);
  if (!parsed.value) throw Unreadable();
  return *parsed.value;
}

std::optional<Triple> triple(const Json& json, const char* name) {
  if (!json.contains(name)) return std::nullopt;
  const Json& list = json.at(name);
  return Triple{number(list.at(0)), number(list.at(1)), number(list.at(2))};
}

Verdict verdict(const Json& json) {
  const std::optional<Verdict> verdict = verdict_named(json.get_ref<const std::string&>());
  if (!verdict) throw Unreadable();
  return *verdict;
}

std::optional<Status> status(const Json& json) {
  const std::string& word = json.get_ref<const std::string&>();
  const std::optional<Status> status = status_named(word);
  if (!status && word != "undecided") throw Unreadable();
  return status;
}

Accuracy accuracy(const Json& json) {
  for (const Accuracy a : {Accuracy::correctly_rounded, Accuracy::ulps_4, Accuracy::u_r_16, Accuracy::millionth, Accuracy::tolerance})
    if (json.get_ref<const std::string&>() == name(a)) return a;
  throw Unreadable();
}

void take(const Json& json, const char* name, std::optional<double>& value) {
  if (json.contains(name)) value = number(json.at(name));
}
void take(const Json& json, const char* name, std::optional<mpq_class>& value) {
  if (json.contains(name)) value = exact(json.at(name));
}

void take(const Json& json, const char* name, std::optional<Between>& value) {
  if (json.contains(name)) value = {number(json.at(name).at("low")), number(json.at(name).at("high"))};
}

Reply reply(const Json& json) {
  Reply reply;
  reply.overlap = json.at("overlap").get<bool>();
  take(json, "depth", reply.depth);
  take(json, "distance", reply.distance);
  reply.direction = triple(json, "direction");
  if (json.contains("witness")) {
    reply.witness_a = triple(json.at("witness"), "a");
    reply.witness_b = triple(json.at("witness"), "b");
  }
  for (const Json& each : json.value("contacts", Json::array())) {
    ContactPoint contact{triple(each, "position").value(), {}};
    take(each, "depth", contact.depth);
    reply.contacts.push_back(contact);
  }
  return reply;
}

Judgement judgement(const Json& json) {
  Judgement j;
  j.verdict = verdict(json.at("verdict"));
  j.status = status(json.at("status"));
  take(json, "signed_depth", j.signed_depth);
  if (!j.signed_depth) j.depth_squared = exact(json.at("depth_squared"));
  if (json.contains("distance_squared")) j.distance_squared = exact(json.at("distance_squared"));
  for (const Json& finding : json.at("findings")) j.findings.push_back(verdict(finding));
  if (json.contains("accuracy")) j.accuracy = accuracy(json.at("accuracy"));
  take(json, "error", j.error);
  take(json, "error_ulps", j.error_ulps);
  take(json, "error_relative", j.error_relative);
  take(json, "error_u_r", j.error_u_r);
  take(json, "price_squared", j.price_squared);
  take(json, "travel_squared", j.travel_squared);
  take(json, "price", j.price);
  take(json, "inconsistency", j.inconsistency);
  take(json, "overlap_left", j.overlap_left);
  take(json, "witness_a_squared", j.witness_a_squared);
  take(json, "witness_b_squared", j.witness_b_squared);
  take(json, "witness_a_distance", j.witness_a_distance);
  take(json, "witness_b_distance", j.witness_b_distance);
  take(json, "witness_gap", j.witness_gap);
  take(json, "contact_a_squared", j.contact_a_squared);
  take(json, "contact_b_squared", j.contact_b_squared);
  take(json, "contact_a_distance", j.contact_a_distance);
  take(json, "contact_b_distance", j.contact_b_distance);
  take(json, "deepest", j.deepest);
  take(json, "dearer", j.dearer);
  j.longer = json.value("longer", false);
  if (json.contains("deepest_pair")) {
    const Json& pair = json.at("deepest_pair");
    const Json& pieces = pair.at("pieces");
    j.bounds = {exact(pair.at("squared")), pieces.at(0).get<std::uint32_t>(), pieces.at(1).get<std::uint32_t>(),
                exact(json.at("hulls_squared"))};
  }
  take(json, "deeper_squared", j.deeper_squared);
  j.sentence = json.at("sentence").get<std::string>();
  return j;
}

Outcome outcome(const Json& json) {
  if (json.at("schema") != "fathom/verdict/1" || json.at("type") != "case") throw Unreadable();
  Outcome outcome;
  outcome.id = json.at("id").get<std::string>();
  outcome.variant = json.value("variant", std::string());
  outcome.digest = json.at("digest").get<std::string>();
  outcome.solid = json.value("solid", false);
  outcome.metre_sized = json.value("metre_sized", false);
  outcome.verdict = verdict(json.at("verdict"));
  outcome.detail = json.value("detail", std::string());
  outcome.seconds = number(json.at("seconds"));
  outcome.fit = json.value("fit", 0L);
  if (json.contains("radii")) outcome.radii = exact(json.at("radii"));
  if (json.contains("reply")) outcome.reply = in_unit(reply(json.at("reply")), outcome.fit);
  if (json.contains("judgement")) outcome.judgement = judgement(json.at("judgement"));
  if (json.contains("microseconds")) outcome.microseconds = number(json.at("microseconds"));
  if (json.contains("hulls")) {
    const Json& hulls = json.at("hulls");
    outcome.hulls = {judgement(hulls.at("query")), exact(hulls.at("lost_squared")), exact(hulls.at("grown_squared"))};
  }
  if (json.contains("pieces")) {
    const Json& pieces = json.at("pieces");
    const Json& pair = pieces.at("answer_of");
    outcome.pieces = {pieces.at("pairs").get<std::size_t>(), pair.at(0).get<std::uint32_t>(), pair.at(1).get<std::uint32_t>(),
                      judgement(pieces.at("query"))};
  }
  return outcome;
}

/// What must not change from a run to the one that goes on with its report.
Json lasting(std::string_view header) {
  Json json = Json::parse(header, nullptr, false);
  if (json.is_object()) json.erase("command");
  return json;
}

Unattributed unattributed(const Json& json) {
  if (json.at("schema") != "fathom/verdict/1" || json.at("type") != "unattributed") throw Unreadable();
  Unattributed unattributed;
  if (json.contains("after")) unattributed.after = json.at("after").get<std::string>();
  unattributed.detail = json.at("detail").get<std::string>();
  return unattributed;
}

/// Returns nullopt if `line` is not what `read` reads.
template <class Line>
std::optional<Line> read_line(std::string_view line, Line (*read)(const Json&)) {
  try {
    return read(Json::parse(line));
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const Unreadable&) {
    return std::nullopt;
  }
}

}  // namespace

bool same_run(std::string_view header, std::string_view other) {
  const Json one = lasting(header);
  return one.is_object() && one == lasting(other);
}

std::optional<Outcome> read_outcome(std::string_view line) { return read_line(line, outcome); }

std::optional<Unattributed> read_unattributed(std::string_view line) { return read_line(line, unattributed); }

}  // namespace fathom::harness
