// SPDX-License-Identifier: GPL-3.0-or-later
// What subjects say: hellos and replies.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "kernels/near_miss.hpp"
#include "kernels/printable.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/loose_json.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::json;
constexpr std::size_t shown_bytes = 200;

[[noreturn]] void refuse(const std::string& expected, const std::string& found) {
  throw ProtocolError("expected " + expected + ", found " + found);
}

/// A number as it was written, which a parser of JSON would round: a type of value that no text makes.
Json number_as_written(const std::string& text) { return Json::binary({text.begin(), text.end()}); }
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
Json parsed(std::string_view line) {
  constexpr int deepest = 8;
  const WithoutNumbers rest = without_numbers(line);
  const auto keep = [&](int depth, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::value && value.is_number_unsigned())
      value = number_as_written(rest.numbers.at(value.get<std::size_t>()));
    return depth <= deepest;
  };
  return Json::parse(rest.text, keep, false);
}

Json object_on(std::string_view line) {
  if (line.find('\0') != std::string_view::npos)
    refuse("a JSON object", "a null byte in " + kernels::shown(line));  // to the parser, the end
  Json object = parsed(line);
  if (!object.is_object()) throw ProtocolError("expected a JSON object, found " + (line.empty() ? "an empty line" : kernels::shown(line)));
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

template <class Value>
Value word_in(const Json& object, const char* name, const char* of, std::initializer_list<std::pair<const char*, Value>> words) {
  const std::string text = text_in(object, name, of);
  std::vector<std::string> expected;
  for (const auto& [word, value] : words) {
    if (text == word) return value;
    expected.emplace_back(word);
  }
  refuse(fmt::format("{} for \"{}\" in {}", fmt::join(expected, ", "), name, of), kernels::shown(text));
}

bool flag_in(const Json& object, const char* name, const char* of, std::optional<bool> otherwise = std::nullopt) {
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

Conventions conventions_in(const Json& hello) {
  using C = Conventions;
  const char* const of = "the hello's conventions";
  const Json& said = object_in(hello, "conventions", "the hello");
  C conventions;
  conventions.touching = word_in<C::Touching>(
      said, "touching", of, {{"overlap", C::Touching::overlap}, {"separate", C::Touching::separate}, {"either", C::Touching::either}});
  conventions.depth = word_in<C::Sign>(said, "depth", of, {{"positive", C::Sign::positive}, {"negative", C::Sign::negative}});
  conventions.moves = word_in<C::Body>(said, "moves", of, {{"a", C::Body::a}, {"b", C::Body::b}});
  conventions.unit = flag_in(said, "unit", of);
  return conventions;
}

std::set<std::string> promises_in(const Json& list) {
  std::set<std::string> promises;
  if (!list.is_array()) refuse("a list for \"promises\" in the hello", shown_json(list));
  for (const Json& promise : list) {
    if (promise != "depth" && promise != "direction" && promise != "witness")
      refuse("depth, direction, witness in \"promises\" in the hello", shown_json(promise));
    promises.insert(promise.get<std::string>());
  }
  return promises;
}

std::set<std::string> shapes_in(const Json& list) {
  std::set<std::string> shapes;
  if (!list.is_array()) refuse("a list for \"shapes\" in its capabilities", shown_json(list));
  for (const Json& word : list) {
    const std::string name = word.is_string() ? word.get<std::string>() : "";
    const files::NamedShape named = files::named_shape(name);
    if (name != margin_word && (!named.shape || named.rounded))
      refuse(fmt::format("{}, {} in \"shapes\" in its capabilities", files::list_of_shapes(), margin_word), shown_json(word));
    shapes.insert(name);
  }
  return shapes;
}

void read_capabilities(const Json& capabilities, SubjectInfo& info) {
  info.wants_faces = flag_in(capabilities, "faces", "its capabilities", false);
  if (const Json* shapes = field(capabilities, "shapes")) info.shapes = shapes_in(*shapes);
}

/// A text, or an integer.
std::string id_in(const Json& reply) {
  const Json* id = field(reply, "id");
  if (!id || !is_number(*id)) return text_in(reply, "id", "the reply");
  const std::optional<std::string> integer = read_integer(written(*id));
  if (!integer) refuse("a text or an integer for \"id\" in the reply", shown_json(*id));
  return *integer;
}

/// The reason in the place of an answer.
std::string reason_in(const Json& reply, const char* name) {
  for (const char* other : {"overlap", "depth", "direction", "witness", "unsupported", "failed"})
    if (std::string_view(other) != name && field(reply, other))
      refuse(fmt::format("nothing but \"id\" beside \"{}\"", name), fmt::format("\"{}\"", other));
  return text_in(reply, name, "the reply");
}

Reply read_answer(const Json& object, Precision precision) {
  Reply reply;
  reply.overlap = flag_in(object, "overlap", "the reply");
  if (const Json* depth = field(object, "depth")) reply.depth = number_of(*depth, "depth", precision);
  reply.direction = triple_in(object, "direction", "direction", precision);
  if (const Json* witness = field(object, "witness")) {
    if (!witness->is_object()) refuse("an object for \"witness\"", shown_json(*witness));
    reply.witness_a = triple_in(*witness, "a", "witness.a", precision);
    reply.witness_b = triple_in(*witness, "b", "witness.b", precision);
  }
  return reply;
}

/// Of both objects of a reply.
std::string misspelt(const Json& reply) {
  constexpr std::string_view known[] = {"type", "id", "overlap", "depth", "direction", "witness", "unsupported", "failed"};
  constexpr std::string_view of_witness[] = {"a", "b"};
  const auto fields = [](const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) names.push_back(name);
    return names;
  };
  std::string remark = kernels::near_misses(fields(reply), known);
  if (const Json* witness = field(reply, "witness"))
    if (const std::string inside = kernels::near_misses(fields(*witness), of_witness); !inside.empty())
      remark += (remark.empty() ? "" : "; ") + inside;
  return remark;
}

}  // namespace

SubjectInfo read_hello(std::string_view line) {
  const Json hello = object_on(line);
  const char* const of = "the hello";
  if (text_in(hello, "type", of) != "hello") refuse("a message of type \"hello\"", kernels::shown(line));
  if (const std::string protocol = text_in(hello, "protocol", of); protocol != protocol_name)
    refuse(fmt::format("protocol {}", protocol_name), kernels::shown(protocol));
  SubjectInfo info;
  info.name = text_in(hello, "name", of);
  info.version = text_in(hello, "version", of);
  if (info.name.empty()) refuse("a name in the hello", "an empty one");
  if (field(hello, "library")) info.library = text_in(hello, "library", of);
  info.precision = word_in<Precision>(hello, "precision", of, {{"binary64", Precision::binary64}, {"binary32", Precision::binary32}});
  info.conventions = conventions_in(hello);
  if (field(hello, "capabilities")) read_capabilities(object_in(hello, "capabilities", of), info);
  if (field(hello, "settings"))
    for (const auto& [key, value] : object_in(hello, "settings", of).items())
      info.settings[key] = value.is_string() ? value.get<std::string>() : dumped(value);
  if (const Json* promises = field(hello, "promises")) info.promises = promises_in(*promises);
  return info;
}

SubjectAnswer read_reply(std::string_view line, Precision precision) {
  const Json object = object_on(line);
  if (text_in(object, "type", "the reply") != "reply") refuse("a message of type \"reply\"", kernels::shown(line));
  SubjectAnswer answer{id_in(object), Failed(), ""};
  if (field(object, "unsupported")) answer.said = Unsupported{reason_in(object, "unsupported")};
  else if (field(object, "failed")) answer.said = Failed{reason_in(object, "failed")};
  else answer.said = read_answer(object, precision), answer.remark = misspelt(object);
  return answer;
}

bool is_hello(std::string_view line) {
  const Json object = parsed(line);
  return object.is_object() && object.value("type", Json()) == "hello";
}

std::string hello_text(const SubjectInfo& info) {
  using C = Conventions;
  constexpr const char* touching[] = {"overlap", "separate", "either"};
  nlohmann::ordered_json text;
  text["type"] = "hello";
  text["protocol"] = protocol_name;
  text["name"] = info.name;
  text["version"] = info.version;
  if (!info.library.empty()) text["library"] = info.library;
  text["precision"] = name(info.precision);
  text["conventions"] = {{"touching", touching[static_cast<std::size_t>(info.conventions.touching)]},
                         {"depth", info.conventions.depth == C::Sign::positive ? "positive" : "negative"},
                         {"moves", info.conventions.moves == C::Body::a ? "a" : "b"},
                         {"unit", info.conventions.unit}};
  text["capabilities"] = {{"faces", info.wants_faces}};
  if (!info.shapes.empty()) text["capabilities"]["shapes"] = info.shapes;
  if (!info.promises.empty()) text["promises"] = info.promises;
  if (!info.settings.empty()) text["settings"] = info.settings;
  return text.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace fathom::harness
