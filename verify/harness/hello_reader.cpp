// SPDX-License-Identifier: GPL-3.0-or-later
// What subjects say of themselves.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/message_json.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/judge/fields.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::json;

// What is missing keeps its usual value, if the row says when it is there.
void read(const Json& said, const char* name, const char* of, bool& value) { value = flag_in(said, name, of); }
template <class Value>
void read(const Json& said, const char* name, const char* of, Value& value) {
  value = word_in<Value>(said, name, of);
}

Conventions conventions_in(const Json& hello) {
  const Json& said = object_in(hello, "conventions", "the hello");
  Conventions conventions;
  judging::for_each_field(judging::conventions_fields, [&](const auto& row) {
    const std::string name(row.name);
    if (!row.there || field(said, name.c_str())) read(said, name.c_str(), "the hello's conventions", conventions.*row.member);
  });
  return conventions;
}

std::set<std::string> promises_in(const Json& list) {
  std::set<std::string> promises;
  if (!list.is_array()) refuse("a list for \"promises\" in the hello", shown_json(list));
  for (const Json& promise : list) {
    if (promise != "depth" && promise != "direction" && promise != "witness" && promise != "contacts" && promise != "distance")
      refuse("depth, direction, witness, contacts, distance in \"promises\" in the hello", shown_json(promise));
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
    if (name != margin_word && name != pieces_word && (!named.shape || named.rounded))
      refuse(fmt::format("{}, {}, {} in \"shapes\" in its capabilities", files::list_of_shapes(), margin_word, pieces_word),
             shown_json(word));
    shapes.insert(name);
  }
  return shapes;
}

void read_capabilities(const Json& capabilities, SubjectInfo& info) {
  info.wants_faces = flag_in(capabilities, "faces", "its capabilities", false);
  if (const Json* shapes = field(capabilities, "shapes")) info.shapes = shapes_in(*shapes);
}

/// A type for both, or one for points and one for answers.
NumberFormat format_in(const Json& hello) {
  const auto type = [](const Json& object, const char* name, const char* of) { return word_in<Precision>(object, name, of); };
  const Json* said = field(hello, "precision");
  if (!said || !said->is_object()) return type(hello, "precision", "the hello");
  return {type(*said, "points", "the hello's precision"), type(*said, "answers", "the hello's precision")};
}

mpq_class radius_in(const Json& value) {
  const double radius = is_number(value) ? number_of(value, "rounding", Precision::binary64) : -1;
  if (!std::isfinite(radius) || radius < 0) refuse("a radius of at least 0 for \"rounding\"", shown_json(value));
  return exact_value(radius);
}

/// A radius for all bodies, or one for each word.
std::map<std::string, mpq_class> rounding_in(const Json& said) {
  if (!said.is_object()) return {{"", radius_in(said)}};
  std::map<std::string, mpq_class> result;
  for (const auto& [word, value] : said.items()) {
    const files::NamedShape named = files::named_shape(word);
    if (word != vertices_word && (!named.shape || named.rounded))
      refuse(fmt::format("{}, {} in \"rounding\" in the hello", vertices_word, files::list_of_shapes()), kernels::shown(word));
    result[word] = radius_in(value);
  }
  return result;
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
  info.format = format_in(hello);
  info.conventions = conventions_in(hello);
  if (field(hello, "capabilities")) read_capabilities(object_in(hello, "capabilities", of), info);
  if (field(hello, "settings"))
    for (const auto& [key, value] : object_in(hello, "settings", of).items())
      info.settings[key] = value.is_string() ? value.get<std::string>() : dumped(value);
  if (const Json* promises = field(hello, "promises")) info.promises = promises_in(*promises);
  if (const Json* rounding = field(hello, "rounding")) info.rounding = rounding_in(*rounding);
  return info;
}

bool is_hello(std::string_view line) {
  const Json object = json_on(line);
  return object.is_object() && object.value("type", Json()) == "hello";
}

}  // namespace fathom::harness
