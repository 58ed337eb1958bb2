// SPDX-License-Identifier: GPL-3.0-or-later
// Writes and reads lines of schema fathom/verdict/1: the part of journal.hpp that is JSON; and
// hellos, which headers hold. The tables list the fields; this file converts values of each type.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "reference/text/json_value.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/report_fields.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::harness {
namespace {

using judging::fields_of;
using text::Json;

// ---- writing ----

Json line_of(const char* type) { return {{"schema", report_schema}, {"type", type}}; }

Json json_of(bool value) { return Json::boolean(value); }
Json json_of(long value) { return value; }
Json json_of(std::size_t value) { return value; }
Json json_of(const std::string& value) { return value; }
Json json_of(Verdict value) { return name(value); }
Json json_of(Accuracy value) { return name(value); }
Json json_of(const mpq_class& value) { return exact_text(value); }
Json json_of(const std::array<std::uint32_t, 2>& pair) { return Json::array({pair[0], pair[1]}); }
Json json_of(const Point& p) { return Json::array({json_of(p.x), json_of(p.y), json_of(p.z)}); }
Json json_of(const Vector& v) {
  return Json::array({json_of(mpq_class(v.x)), json_of(mpq_class(v.y)), json_of(mpq_class(v.z))});
}
Json json_of(std::uint32_t value) { return value; }
Json json_of(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}
template <class Value>
requires requires(Value value) { judging::words_of(value); }
Json json_of(Value value) { return judging::word_of(value); }
Json json_of(const NumberFormat& format) {
  if (format.points == format.answers) return name(format.points);
  return {{"points", name(format.points)}, {"answers", name(format.answers)}};
}
Json json_of(const std::set<std::string>& words) {
  return Json::array_of(words, [](const std::string& word) { return Json(word); });
}
Json json_of(const std::map<std::string, std::string>& texts) {
  Json json = Json::object();
  for (const auto& [key, text] : texts) json[key] = text;
  return json;
}
Json json_of(const std::map<std::string, mpq_class>& rounding) {
  Json json;
  for (const auto& [word, radius] : rounding)
    if (word.empty()) json = round_binary64(radius);
    else json[word] = round_binary64(radius);
  return json;
}
Json json_of(const Triple& t) { return Json::array({json_of(t[0]), json_of(t[1]), json_of(t[2])}); }
Json json_of(const Between& value) { return {{"low", json_of(value.low)}, {"high", json_of(value.high)}}; }
Json json_of(const std::optional<Status>& value) { return name(value); }
Json json_of(const UnionBounds& bounds) {
  return {{"squared", exact_text(bounds.deepest_pair)},
          {"pieces", Json::array({bounds.a, bounds.b})}};  // the depth of the hulls is a field of its own
}
Json json_of(const std::array<std::size_t, verdict_count>& verdicts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (verdicts[i] > 0) json[name(static_cast<Verdict>(i))] = verdicts[i];
  return json;
}
Json json_of(const std::vector<Tally::Line>& parts);
template <class T>
Json json_of(const std::vector<T>& list);
template <class T>
Json json_of(const std::optional<T>& value);
template <class T>
Json json_of(const T* value);
template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
Json json_of(const Struct& of);

/// Writes the fields that the struct has. Combines "witness.a" and "witness.b", which are adjacent
/// in its table, into one object "witness".
template <class Struct>
void write_fields(Json& json, const Struct& of) {
  std::string_view whole;
  Json parts;
  const auto close = [&] {
    if (!whole.empty()) json[whole] = parts;
    whole = {};
    parts = Json();
  };
  text::for_each_field(fields_of(&of), [&](const auto& field) {
    if (!text::has(field, of)) return;
    const std::size_t dot = field.name.find('.');
    const std::string_view within = dot == field.name.npos ? "" : field.name.substr(0, dot);
    if (within != whole) close();
    whole = within;
    (whole.empty() ? json : parts)[field.name.substr(whole.empty() ? 0 : dot + 1)] = json_of(text::value_of(field, of));
  });
  close();
}

template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
Json json_of(const Struct& of) {
  Json json = Json::object();
  write_fields(json, of);
  return json;
}
template <class T>
Json json_of(const std::optional<T>& value) {
  return json_of(*value);
}
template <class T>
Json json_of(const T* value) {
  return json_of(*value);
}
template <class T>
Json json_of(const std::vector<T>& list) {
  return Json::array_of(list, [](const T& item) { return json_of(item); });
}
Json json_of(const std::vector<Tally::Line>& parts) {
  Json json;
  for (const Tally::Line& part : parts) json[part.label] = json_of(part.row);
  return json;
}

template <class Struct>
std::string line(const char* type, const Struct& of) {
  Json json = line_of(type);
  write_fields(json, of);
  return json.text();
}

// ---- reading ----

using Read = text::JsonValue;

/// Thrown if a value is not exactly as `line` writes it.
struct Unreadable {};

void take(const Read& json, bool& value) { value = json.boolean(); }
void take(const Read& json, long& value) {
  constexpr double exact_up_to = 0x1p53;
  if (!json.is_number() || json.kind() == Read::Kind::real || std::abs(json.number()) >= exact_up_to)
    throw Unreadable();
  value = static_cast<long>(json.number());
}
void take(const Read& json, std::size_t& value) { value = json.natural(); }
void take(const Read& json, std::uint32_t& value) {
  value = static_cast<std::uint32_t>(json.natural(std::numeric_limits<std::uint32_t>::max()));
}
void take(const Read& json, std::string& value) { value = json.string(); }
void take(const Read& json, double& value) {
  if (json.is_number()) {
    value = json.number();
    return;
  }
  const std::string& text = json.string();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (text == "nan") value = std::numeric_limits<double>::quiet_NaN();
  else if (text == "inf" || text == "-inf") value = text == "inf" ? infinity : -infinity;
  else throw Unreadable();
}
void take(const Read& json, mpq_class& value) {
  const ParsedNumber parsed = text::exact_number(json);
  if (!parsed.value) throw Unreadable();
  value = *parsed.value;
}
void take(const Read& json, Verdict& value) {
  const std::optional<Verdict> verdict = verdict_named(json.string());
  if (!verdict) throw Unreadable();
  value = *verdict;
}
/// Returns the number of coordinates; those of the plane have no z.
std::size_t coordinates_in(const Read& json) {
  if (json.items().size() != 2 && json.items().size() != 3) throw Unreadable();
  return json.items().size();
}

void take(const Read& json, Point& p) {
  const std::size_t count = coordinates_in(json);
  take(json.at(0), p.x);
  take(json.at(1), p.y);
  if (count == 3) take(json.at(2), p.z);
}
void take(const Read& json, Vector& v) {
  Point p;
  take(json, p);
  v = {p.x.get_num(), p.y.get_num(), p.z.get_num()};
}
void take(const Read& json, Accuracy& value) {
  for (const Accuracy a :
       {Accuracy::correctly_rounded, Accuracy::ulps_4, Accuracy::u_r_16, Accuracy::millionth, Accuracy::tolerance}) {
    value = a;
    if (json.string() == name(a)) return;
  }
  throw Unreadable();
}
void take(const Read& json, std::optional<Status>& value) {
  const std::string& word = json.string();
  value = status_named(word);
  if (!value && word != name(value)) throw Unreadable();
}
void take(const Read& json, Triple& value) {
  value = {};
  for (std::size_t i = 0; i < coordinates_in(json); ++i) take(json.at(i), value[i]);
}
void take(const Read& json, std::array<std::uint32_t, 2>& pair) {
  take(json.at(0), pair[0]);
  take(json.at(1), pair[1]);
}
void take(const Read& json, Between& value) {
  take(json.at("low"), value.low);
  take(json.at("high"), value.high);
}
void take(const Read& json, UnionBounds& bounds) {
  take(json.at("squared"), bounds.deepest_pair);
  take(json.at("pieces").at(0), bounds.a);
  take(json.at("pieces").at(1), bounds.b);
}
template <class T>
void take(const Read& json, std::vector<T>& list);
template <class T>
void take(const Read& json, std::optional<T>& value);
template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
void take(const Read& json, Struct& to);

/// Returns the field by its name or its path; null if it is missing.
const Read* found(const Read& json, std::string_view path) {
  const std::size_t dot = path.find('.');
  const Read* const at = json.find(path.substr(0, dot));
  return !at || dot == path.npos ? at : found(*at, path.substr(dot + 1));
}

template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
void take(const Read& json, Struct& to) {
  text::for_each_field(fields_of(&to), [&](const auto& field) {
    if constexpr (std::decay_t<decltype(field)>::stored) {
      if (const Read* value = found(json, field.name)) take(*value, to.*field.member);
      else if (text::has(field, to)) throw Unreadable();
    }
  });
  if constexpr (std::is_same_v<Struct, Judgement>)
    if (to.bounds) take(json.at("hulls_squared"), to.bounds->hulls);
}
template <class T>
void take(const Read& json, std::optional<T>& value) {
  take(json, value.emplace());
}
template <class T>
void take(const Read& json, std::vector<T>& list) {
  list.clear();
  for (const Read& item : json.items()) take(item, list.emplace_back());
}

/// Returns nullopt if the text is not what `line` writes.
template <class Struct>
std::optional<Struct> read_line(std::string_view text, const char* type) try {
  const Read json = text::parsed_json(text);
  if (json.at("schema").string() != report_schema || json.at("type").string() != type) return std::nullopt;
  Struct result;
  take(json, result);
  return result;
} catch (const text::JsonFault&) {
  return std::nullopt;
} catch (const Unreadable&) {
  return std::nullopt;
}

/// Returns a reply, or faults of contacts, with two coordinates for each point and direction: all
/// arrays of three numbers, which may be texts, are such.
Json without_z(const Read& json) {
  if (json.is_object()) {
    Json result = Json::object();
    for (std::size_t i = 0; i < json.items().size(); ++i) result[json.key(i)] = without_z(json.items()[i]);
    return result;
  }
  if (!json.is_array()) return json.written(Read::Form::given);
  const auto is_number = [](const Read& item) { return item.is_number() || item.is_string(); };
  const bool is_point = json.items().size() == 3 && std::ranges::all_of(json.items(), is_number);
  Json result = Json::array();
  for (std::size_t i = 0; i < json.items().size() - (is_point ? 1 : 0); ++i) result.push_back(without_z(json.at(i)));
  return result;
}

/// Returns the fields of a header that must be equal in a run that continues the report; empty if
/// the header is no object.
std::map<std::string, std::string> lasting(std::string_view header) {
  std::map<std::string, std::string> fields;
  const text::JsonRead read = text::read_json(header);
  if (read.whole)
    for (const auto& [key, value] : read.value.fields()) fields[std::string(key)] = value->written().text();
  fields.erase("command");
  return fields;
}

}  // namespace

bool begins_line(std::string_view text, const char* type) {
  std::string head = line_of(type).text();
  head.pop_back();  // the object goes on
  return text.starts_with(head);
}

// Outcomes hold replies in the subject's unit; lines have them in that of the case.
std::string outcome_line(const Outcome& outcome) {
  const auto written = [&outcome](const std::string& text) {
    if (outcome.dimension == 3) return text;
    Json result = Json::object();
    const Read json = text::parsed_json(text);
    for (std::size_t i = 0; i < json.items().size(); ++i) {
      const std::string_view key = json.key(i);
      const Read& value = json.items()[i];
      result[key] = key == "reply" || key == "contact_faults" ? without_z(value) : value.written(Read::Form::given);
    }
    return result.text();
  };
  if (!outcome.reply || outcome.fit == 0) return written(line("case", outcome));
  Outcome scaled_back = outcome;
  scaled_back.reply = in_unit(*outcome.reply, -outcome.fit);
  return written(line("case", scaled_back));
}

std::optional<Outcome> read_outcome(std::string_view line) {
  std::optional<Outcome> outcome = read_line<Outcome>(line, "case");
  if (outcome && outcome->reply) outcome->reply = in_unit(*std::move(outcome->reply), outcome->fit);
  return outcome;
}

std::string unattributed_line(const Unattributed& unattributed) { return line("unattributed", unattributed); }

std::optional<Unattributed> read_unattributed(std::string_view line) {
  return read_line<Unattributed>(line, "unattributed");
}

std::string request_line(const std::string& id, const std::string& run, const Judgement& truth,
                         const judging::Accepted& accepted) {
  Json json = line_of("request");
  json["id"] = id;
  json["run"] = Json::written(run);
  Json known{{"status", json_of(truth.status)}};
  if (truth.signed_depth) known["signed_depth"] = json_of(*truth.signed_depth);
  else {
    known["depth_squared"] = json_of(truth.depth_squared);
    known["distance_squared"] = json_of(truth.distance_squared);
  }
  json["truth"] = known;
  json["accepted"] = {{"overlap", json_of(accepted.overlap)},
                      {"apart", json_of(accepted.apart)},
                      {"depth", json_of(accepted.depth)},
                      {"distance", json_of(accepted.distance)}};
  return json.text();
}

std::string summary_line(const Totals& totals) { return line("summary", totals); }

std::string hello_text(const SubjectInfo& info) {
  Json json{{"type", "hello"}, {"protocol", protocol_name}};
  write_fields(json, info);
  return json.text();
}

std::string header_line(const SubjectInfo& info, const Tolerance& tolerance, const RunInfo& from) {
  Json json = line_of("header");
  json["fathom"] = from.version;
  json["command"] = from.command;
  json["subject"] = Json::written(hello_text(info));
  Json allowed{{"relative", exact_text(tolerance.relative)},
               {"absolute", exact_text(tolerance.absolute)},
               {"ulps", tolerance.ulps}};
  if (tolerance.patch_slack) allowed["patch_slack"] = exact_text(*tolerance.patch_slack);
  json["tolerance"] = allowed;
  if (from.fit) json["fit"] = exact_text(*from.fit);
  json["policy"] = judging::policy_text(tolerance.policy);
  if (!from.second.empty())
    json["methods"] = Json::array_of(from.second, [](Method method) { return Json(name(method)); });
  return json.text();
}

bool same_run(std::string_view header, std::string_view other) {
  const std::map<std::string, std::string> one = lasting(header);
  return !one.empty() && one == lasting(other);
}

std::optional<std::string> difference(const Judgement& x, const Judgement& y) {
  const Read one = text::read_json(json_of(x).text()).value, other = text::read_json(json_of(y).text()).value;
  const auto shown = [](const Read& fields, std::string_view key) {
    const Read* const value = fields.find(key);
    return value ? value->written().text() : "nothing";
  };
  for (const Read* fields : {&one, &other})
    for (std::size_t i = 0; i < fields->items().size(); ++i)
      if (const std::string_view key = fields->key(i); shown(one, key) != shown(other, key))
        return fmt::format("judgement.{}: {} and {}", key, shown(one, key), shown(other, key));
  return std::nullopt;
}

}  // namespace fathom::harness
