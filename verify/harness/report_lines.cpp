// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of schema fathom/verdict/1, out and in: the part of journal.hpp that is JSON; and hellos,
// which headers hold. Fields come from the tables; here is how a value of each type is written and
// read.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/report_fields.hpp"
#include "verify/judge/words.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::ordered_json;
using judging::fields_of;

// ---- out ----

std::string dumped(const Json& json) { return json.dump(-1, ' ', true, Json::error_handler_t::replace); }

Json line_of(const char* type) { return {{"schema", "fathom/verdict/1"}, {"type", type}}; }

Json json_of(bool value) { return value; }
Json json_of(long value) { return value; }
Json json_of(std::size_t value) { return value; }
Json json_of(const std::string& value) { return value; }
Json json_of(Verdict value) { return name(value); }
Json json_of(Accuracy value) { return name(value); }
Json json_of(const mpq_class& value) { return exact_text(value); }
Json json_of(const std::array<std::uint32_t, 2>& pair) { return {pair[0], pair[1]}; }
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
Json json_of(const std::set<std::string>& words) { return words; }
Json json_of(const std::map<std::string, std::string>& texts) { return texts; }
Json json_of(const std::map<std::string, mpq_class>& rounding) {
  Json json;
  for (const auto& [word, radius] : rounding) (word.empty() ? json : json[word]) = round_binary64(radius);
  return json;
}
Json json_of(const Triple& t) { return {json_of(t[0]), json_of(t[1]), json_of(t[2])}; }
Json json_of(const Between& value) { return {{"low", json_of(value.low)}, {"high", json_of(value.high)}}; }
Json json_of(const std::optional<Status>& value) { return value ? name(*value) : "undecided"; }
Json json_of(const UnionBounds& bounds) {
  return {{"squared", exact_text(bounds.deepest_pair)},
          {"pieces", {bounds.a, bounds.b}}};  // the hulls have a field of their own
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

/// Writes the fields that the struct has; "witness.a" into the object "witness".
template <class Struct>
void write_fields(Json& json, const Struct& of) {
  judging::for_each_field(fields_of(&of), [&](const auto& field) {
    if (!judging::has(field, of)) return;
    const std::size_t dot = field.name.find('.');
    Json& into = dot == field.name.npos ? json : json[std::string(field.name.substr(0, dot))];
    into[std::string(field.name.substr(dot == field.name.npos ? 0 : dot + 1))] = json_of(judging::value_of(field, of));
  });
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
  Json json = Json::array();
  for (const T& item : list) json.push_back(json_of(item));
  return json;
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
  return dumped(json);
}

// ---- in ----

using Read = nlohmann::json;

/// What is not exactly as it was written.
struct Unreadable {};

void take(const Read& json, bool& value) { value = json.get<bool>(); }
void take(const Read& json, long& value) { value = json.get<long>(); }
void take(const Read& json, std::size_t& value) { value = json.get<std::size_t>(); }
void take(const Read& json, std::string& value) { value = json.get<std::string>(); }
void take(const Read& json, double& value) {
  if (json.is_number()) {
    value = json.get<double>();
    return;
  }
  const std::string text = json.get<std::string>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (text == "nan") value = std::numeric_limits<double>::quiet_NaN();
  else if (text == "inf" || text == "-inf") value = text == "inf" ? infinity : -infinity;
  else throw Unreadable();
}
void take(const Read& json, mpq_class& value) {
  const ParsedNumber parsed = parse_number(json.get_ref<const std::string&>(), Decimals::exact);
  if (!parsed.value) throw Unreadable();
  value = *parsed.value;
}
void take(const Read& json, Verdict& value) {
  const std::optional<Verdict> verdict = verdict_named(json.get_ref<const std::string&>());
  if (!verdict) throw Unreadable();
  value = *verdict;
}
void take(const Read& json, Accuracy& value) {
  for (const Accuracy a :
       {Accuracy::correctly_rounded, Accuracy::ulps_4, Accuracy::u_r_16, Accuracy::millionth, Accuracy::tolerance}) {
    value = a;
    if (json.get_ref<const std::string&>() == name(a)) return;
  }
  throw Unreadable();
}
void take(const Read& json, std::optional<Status>& value) {
  const std::string& word = json.get_ref<const std::string&>();
  value = status_named(word);
  if (!value && word != "undecided") throw Unreadable();
}
void take(const Read& json, Triple& value) {
  for (std::size_t i = 0; i < value.size(); ++i) take(json.at(i), value[i]);
}
void take(const Read& json, std::array<std::uint32_t, 2>& pair) {
  pair = {json.at(0).get<std::uint32_t>(), json.at(1).get<std::uint32_t>()};
}
void take(const Read& json, Between& value) {
  take(json.at("low"), value.low);
  take(json.at("high"), value.high);
}
void take(const Read& json, UnionBounds& bounds) {
  take(json.at("squared"), bounds.deepest_pair);
  bounds.a = json.at("pieces").at(0).get<std::uint32_t>();
  bounds.b = json.at("pieces").at(1).get<std::uint32_t>();
}
template <class T>
void take(const Read& json, std::vector<T>& list);
template <class T>
void take(const Read& json, std::optional<T>& value);
template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
void take(const Read& json, Struct& to);

/// The field, by its name or its path; null if it is not there.
const Read* found(const Read& json, std::string_view path) {
  const std::size_t dot = path.find('.');
  const auto at = json.find(std::string(path.substr(0, dot)));
  if (at == json.end()) return nullptr;
  return dot == path.npos ? &*at : found(*at, path.substr(dot + 1));
}

template <class Struct>
requires requires(const Struct* it) { fields_of(it); }
void take(const Read& json, Struct& to) {
  judging::for_each_field(fields_of(&to), [&](const auto& field) {
    if constexpr (std::decay_t<decltype(field)>::stored) {
      if (const Read* value = found(json, field.name)) take(*value, to.*field.member);
      else if (judging::has(field, to)) throw Unreadable();
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
  for (const Read& item : json) take(item, list.emplace_back());
}

/// Returns nullopt if the text is not what `line` writes.
template <class Struct>
std::optional<Struct> read_line(std::string_view text, const char* type) try {
  const Read json = Read::parse(text);
  if (json.at("schema") != "fathom/verdict/1" || json.at("type") != type) return std::nullopt;
  Struct result;
  take(json, result);
  return result;
} catch (const Read::exception&) {
  return std::nullopt;
} catch (const Unreadable&) {
  return std::nullopt;
}

/// What must not change from a run to the one that goes on with its report.
Read lasting(std::string_view header) {
  Read json = Read::parse(header, nullptr, false);
  if (json.is_object()) json.erase("command");
  return json;
}

}  // namespace

// Replies are kept in the subject's unit, and written in that of the case.
std::string outcome_line(const Outcome& outcome) {
  if (!outcome.reply || outcome.fit == 0) return line("case", outcome);
  Outcome written = outcome;
  written.reply = in_unit(*outcome.reply, -outcome.fit);
  return line("case", written);
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

std::string summary_line(const Totals& totals) { return line("summary", totals); }

std::string hello_text(const SubjectInfo& info) {
  Json json{{"type", "hello"}, {"protocol", protocol_name}};
  write_fields(json, info);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string header_line(const SubjectInfo& info, const Tolerance& tolerance, const RunInfo& from) {
  Json json = line_of("header");
  json["fathom"] = from.version;
  json["command"] = from.command;
  json["subject"] = Json::parse(hello_text(info));
  json["tolerance"] = {{"relative", exact_text(tolerance.relative)},
                       {"absolute", exact_text(tolerance.absolute)},
                       {"ulps", tolerance.ulps}};
  if (from.fit) json["fit"] = exact_text(*from.fit);
  json["policy"] = judging::policy_text(tolerance.policy);
  for (const Method method : from.second) json["methods"].push_back(name(method));
  return dumped(json);
}

bool same_run(std::string_view header, std::string_view other) {
  const Read one = lasting(header);
  return one.is_object() && one == lasting(other);
}

std::optional<std::string> difference(const Judgement& x, const Judgement& y) {
  const Json one = json_of(x), other = json_of(y);
  const auto shown = [](const Json& fields, const std::string& key) {
    return fields.contains(key) ? fields.at(key).dump() : "nothing";
  };
  for (const Json* fields : {&one, &other}) {
    for (const auto& [key, value] : fields->items())
      if (shown(one, key) != shown(other, key))
        return fmt::format("judgement.{}: {} and {}", key, shown(one, key), shown(other, key));
  }
  return std::nullopt;
}

}  // namespace fathom::harness
