// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/message_json.hpp"

#include <array>
#include <set>

#include "verify/harness/loose_json.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::json;
constexpr std::size_t shown_bytes = 200;

/// A number as it was written, which a parser of JSON would round: a type of value that no text makes.
Json number_as_written(const std::string& text) { return Json::binary({text.begin(), text.end()}); }

}  // namespace

void refuse(const std::string& expected, const std::string& found) { throw ProtocolError("expected " + expected + ", found " + found); }

bool is_number(const Json& value) { return value.is_binary(); }
std::string written(const Json& number) { return {number.get_binary().begin(), number.get_binary().end()}; }

/// As JSON, but with numbers as they were written.
std::string dumped(const Json& value) {
  if (is_number(value)) return written(value);
  if (!value.is_structured()) return value.dump(-1, ' ', true, Json::error_handler_t::replace);
  std::string text;
  for (const auto& [key, part] : value.items()) {
    text += text.empty() ? "" : ",";
    text += (value.is_object() ? Json(key).dump(-1, ' ', true, Json::error_handler_t::replace) + ':' : "") + dumped(part);
  }
  return value.is_object() ? '{' + text + '}' : '[' + text + ']';
}

std::string shown_json(const Json& value) { return '\'' + kernels::printable(dumped(value), shown_bytes) + '\''; }

/// The JSON on the line. What is nested deeper than any message of ours is left out, so that no line costs more than a few times its
/// length.
Json json_on(std::string_view line, std::string* repeated) {
  constexpr int deepest = 8;
  const WithoutNumbers rest = without_numbers(line);
  std::array<std::set<std::string>, deepest + 2> names;  // of the object at each depth
  const auto keep = [&](int depth, Json::parse_event_t event, Json& value) {
    const auto level = static_cast<std::size_t>(depth);
    if (event == Json::parse_event_t::object_start && level + 1 < names.size()) names[level + 1].clear();
    if (repeated && event == Json::parse_event_t::key && level < names.size())
      if (auto name = value.get<std::string>(); !names[level].insert(name).second && repeated->empty()) *repeated = std::move(name);
    if (event == Json::parse_event_t::value && value.is_number_unsigned())
      value = number_as_written(rest.numbers.at(value.get<std::size_t>()));
    return depth <= deepest;
  };
  return Json::parse(rest.text, keep, false);
}

Json object_on(std::string_view line) {
  if (line.find('\0') != std::string_view::npos)
    refuse("a JSON object", "a null byte in " + kernels::shown(line));  // to the parser, the end
  std::string repeated;
  Json object = json_on(line, &repeated);
  if (!object.is_object()) throw ProtocolError("expected a JSON object, found " + (line.empty() ? "an empty line" : kernels::shown(line)));
  if (!repeated.empty()) refuse("each field once", kernels::shown(repeated) + " twice");
  return object;
}

/// Null is no way to leave a field out: it is what many a program writes for NaN.
const Json* field(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::string text_in(const Json& object, const char* name, const char* of) {
  const Json* value = field(object, name);
  if (!value) refuse(fmt::format("\"{}\" in {}", name, of), "none");
  if (!value->is_string()) refuse(fmt::format("a text for \"{}\" in {}", name, of), shown_json(*value));
  return value->get<std::string>();
}

bool flag_in(const Json& object, const char* name, const char* of, std::optional<bool> otherwise) {
  const Json* value = field(object, name);
  if (!value && otherwise) return *otherwise;
  if (!value) refuse(fmt::format("\"{}\" in {}", name, of), "none");
  if (!value->is_boolean()) refuse(fmt::format("true or false for \"{}\" in {}", name, of), shown_json(*value));
  return value->get<bool>();
}

const Json& object_in(const Json& object, const char* name, const char* of) {
  const Json* value = field(object, name);
  if (!value || !value->is_object()) refuse(fmt::format("an object for \"{}\" in {}", name, of), value ? shown_json(*value) : "none");
  return *value;
}

double number_of(const Json& value, const char* name, Precision precision) {
  std::optional<double> number;
  if (is_number(value) || value.is_string()) number = read_number(is_number(value) ? written(value) : value.get<std::string>(), precision);
  if (!number) refuse(fmt::format("a number for \"{}\"{}", name, value.is_null() ? " (NaN is \"nan\")" : ""), shown_json(value));
  return *number;
}

std::optional<Triple> triple_in(const Json& object, const char* name, const char* called, Precision precision) {
  const Json* value = field(object, name);
  if (!value) return std::nullopt;
  Triple triple;
  if (!value->is_array() || value->size() != triple.size()) refuse(fmt::format("three numbers for \"{}\"", called), shown_json(*value));
  for (std::size_t i = 0; i < triple.size(); ++i) triple[i] = number_of((*value)[i], called, precision);
  return triple;
}

}  // namespace fathom::harness
