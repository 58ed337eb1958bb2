// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/harness/message_json.hpp"
#include "verify/judge/fields.hpp"

namespace fathom::harness {
namespace {

void add_body(text::JsonStream& out, const Body& body, Precision precision, bool with_faces) {
  if (body.pieces && body.pieces->size() == 1)
    return add_body(out, Body{body.pieces->front()}, precision, with_faces);  // a polytope
  if (body.words && !body.pieces) {
    out.value(files::body_json(*body.words, files::Defaults::written).text());
    return;
  }
  out.object([&] {
    if (body.pieces) {
      out.key("pieces");
      out.array_of(*body.pieces,
                   [&](const std::vector<Point>& piece) { add_body(out, Body{piece}, precision, with_faces); });
      return;
    }
    const std::optional<GivenPoints> rounded = seen(body.points, precision);
    if (!rounded) throw std::invalid_argument("a coordinate overflows the subject's precision");
    out.key("vertices");
    // Read by strtod or by strtof, or by strtod and then rounded, each number is the same.
    out.array_of(rounded->binary64(),
                 [&](const std::array<double, 3>& p) { out.value(fmt::format("[{},{},{}]", p[0], p[1], p[2])); });
    const Faces faces = with_faces ? faces_of(body.points) : Faces();
    if (!faces.empty())
      out.key("faces"), out.array_of(faces, [&](const std::vector<std::uint32_t>& face) { out.array_of(face); });
  });
}

// ---- what subjects answer ----

using Json = JsonValue;

/// A text, or an integer.
std::string id_in(const Json& reply) {
  const Json* id = reply.find("id");
  if (!id || !id->is_number()) return text_in(reply, "id", "the reply");
  const std::optional<std::string> integer = read_integer(id->text());
  if (!integer) refuse("a text or an integer for \"id\" in the reply", shown_json(*id));
  return *integer;
}

/// The reason in the place of an answer.
std::string reason_in(const Json& reply, const char* name) {
  std::vector<std::string_view> others = text::names_of(judging::reply_fields);
  others.insert(others.end(), {"hull", "unsupported", "failed"});
  for (const std::string_view other : others)
    if (other != name && reply.find(other))
      refuse(fmt::format("nothing but \"id\" beside \"{}\"", name), fmt::format("\"{}\"", other));
  return text_in(reply, name, "the reply");
}

/// The vertices of one used hull, if there is one.
std::optional<std::vector<Triple>> hull_in(const Json& object, const char* name, const char* called,
                                           Precision precision) {
  const Json* list = object.find(name);
  if (!list) return std::nullopt;
  if (!list->is_array() || list->items().empty())
    refuse(fmt::format("a list of vertices for \"{}\"", called), shown_json(*list));
  std::vector<Triple> vertices;
  for (const Json& vertex : list->items()) {
    vertices.push_back(triple_of(vertex, called, precision));
    if (!std::ranges::all_of(vertices.back(), [](double x) { return std::isfinite(x); }))
      refuse(fmt::format("finite numbers for \"{}\"", called), shown_json(vertex));
  }
  return vertices;
}

/// What is beside an answer.
void read_rest(const Json& object, Precision points, SubjectAnswer& answer) {
  if (const Json* hull = object.find("hull")) {
    if (!hull->is_object()) refuse("an object for \"hull\"", shown_json(*hull));
    answer.hull_a = hull_in(*hull, "a", "hull.a", points);
    answer.hull_b = hull_in(*hull, "b", "hull.b", points);
  }
  const Json* time = object.find("microseconds");
  if (!time) return;
  const std::optional<double> value = time->is_number() ? read_number(time->text(), Precision::binary64) : std::nullopt;
  if (value && std::isfinite(*value) && *value >= 0) answer.microseconds = value;
  else answer.remark += (answer.remark.empty() ? "" : "; ") + ("\"microseconds\" is no time: " + shown_json(*time));
}

std::vector<ContactPoint> contacts_in(const Json& list, Precision precision) {
  if (!list.is_array() || list.items().empty()) refuse("a list of contacts for \"contacts\"", shown_json(list));
  std::vector<ContactPoint> contacts;
  for (const Json& each : list.items()) {
    const std::optional<Triple> position =
        each.is_object() ? triple_in(each, "position", "position", precision) : std::nullopt;
    if (!position) refuse("an object with a \"position\" in \"contacts\"", shown_json(each));
    contacts.push_back({*position, {}});
    if (const Json* depth = each.find("depth")) contacts.back().depth = number_of(*depth, "depth", precision);
  }
  return contacts;
}

// A field of a reply, if it is there: of the object, by its name there; `called` in messages.
void read(const Json& object, const char* name, const char* called, Precision precision, std::optional<double>& value) {
  if (const Json* found = object.find(name)) value = number_of(*found, called, precision);
}
void read(const Json& object, const char* name, const char* called, Precision precision, std::optional<Triple>& value) {
  value = triple_in(object, name, called, precision);
}
void read(const Json& object, const char* name, const char*, Precision precision, std::vector<ContactPoint>& contacts) {
  if (const Json* found = object.find(name)) contacts = contacts_in(*found, precision);
}
void read(const Json& object, const char* name, const char*, Precision, bool& value) {
  value = flag_in(object, name, "the reply");
}

Reply read_answer(const Json& object, Precision precision) {
  Reply reply;
  text::for_each_field(judging::reply_fields, [&](const auto& row) {
    const std::string path(row.name);
    const std::size_t dot = path.find('.');
    const Json* of = &object;
    if (dot != path.npos) {
      const std::string whole = path.substr(0, dot);
      of = object.find(whole);
      if (of && !of->is_object()) refuse(fmt::format("an object for \"{}\"", whole), shown_json(*of));
    }
    if (of) read(*of, path.c_str() + (dot == path.npos ? 0 : dot + 1), path.c_str(), precision, reply.*row.member);
  });
  return reply;
}

/// Of all objects of a reply.
std::string misspelt(const Json& reply) {
  constexpr std::string_view of_witness[] = {"a", "b"};
  const std::vector<std::string_view> of_contact = text::names_of(judging::contact_fields);
  std::vector<std::string_view> known = text::names_of(judging::reply_fields);
  known.insert(known.begin(), {"type", "id"});
  known.insert(known.end(), {"hull", "microseconds", "unsupported", "failed"});
  const auto fields = [](const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.fields()) names.emplace_back(name);
    return names;
  };
  std::string remark = kernels::near_misses(fields(reply), known);
  const auto look_inside = [&](const Json& object, std::span<const std::string_view> names) {
    if (const std::string inside = kernels::near_misses(fields(object), names); !inside.empty())
      remark += (remark.empty() ? "" : "; ") + inside;
  };
  if (const Json* witness = reply.find("witness")) look_inside(*witness, of_witness);
  if (const Json* contacts = reply.find("contacts"))
    for (const Json& contact : contacts->items()) look_inside(contact, of_contact);
  return remark;
}

// ---- what subjects say of themselves ----

// What is missing keeps its usual value, if the row says when it is there.
void read(const Json& said, const char* name, const char* of, bool& value) { value = flag_in(said, name, of); }
template <class Value>
void read(const Json& said, const char* name, const char* of, Value& value) {
  value = word_in<Value>(said, name, of);
}

Conventions conventions_in(const Json& hello) {
  const Json& said = object_in(hello, "conventions", "the hello");
  Conventions conventions;
  text::for_each_field(judging::conventions_fields, [&](const auto& row) {
    const std::string name(row.name);
    if (!row.there || said.find(name)) read(said, name.c_str(), "the hello's conventions", conventions.*row.member);
  });
  return conventions;
}

std::set<std::string> promises_in(const Json& list) {
  std::set<std::string> promises;
  if (!list.is_array()) refuse("a list for \"promises\" in the hello", shown_json(list));
  constexpr std::array<std::string_view, 5> known = {"depth", "direction", "witness", "contacts", "distance"};
  for (const Json& promise : list.items()) {
    if (!promise.is_string() || std::ranges::find(known, promise.string()) == known.end())
      refuse("depth, direction, witness, contacts, distance in \"promises\" in the hello", shown_json(promise));
    promises.insert(promise.string());
  }
  return promises;
}

std::set<std::string> shapes_in(const Json& list) {
  std::set<std::string> shapes;
  if (!list.is_array()) refuse("a list for \"shapes\" in its capabilities", shown_json(list));
  for (const Json& word : list.items()) {
    const std::string name = word.is_string() ? word.text() : "";
    const files::NamedShape named = files::named_shape(name);
    if (name != margin_word && name != pieces_word && (!named.shape || named.rounded))
      refuse(fmt::format("{}, {}, {} in \"shapes\" in its capabilities", files::list_of_shapes(), margin_word,
                         pieces_word),
             shown_json(word));
    shapes.insert(name);
  }
  return shapes;
}

void read_capabilities(const Json& capabilities, SubjectInfo& info) {
  info.wants_faces = flag_in(capabilities, "faces", "its capabilities", false);
  if (const Json* shapes = capabilities.find("shapes")) info.shapes = shapes_in(*shapes);
}

/// A type for both, or one for points and one for answers.
NumberFormat format_in(const Json& hello) {
  const auto type = [](const Json& object, const char* name, const char* of) {
    return word_in<Precision>(object, name, of);
  };
  const Json* said = hello.find("precision");
  if (!said || !said->is_object()) return type(hello, "precision", "the hello");
  return {type(*said, "points", "the hello's precision"), type(*said, "answers", "the hello's precision")};
}

mpq_class radius_in(const Json& value) {
  const double radius = value.is_number() ? number_of(value, "rounding", Precision::binary64) : -1;
  if (!std::isfinite(radius) || radius < 0) refuse("a radius of at least 0 for \"rounding\"", shown_json(value));
  return exact_value(radius);
}

/// A radius for all bodies, or one for each word.
std::map<std::string, mpq_class> rounding_in(const Json& said) {
  if (!said.is_object()) return {{"", radius_in(said)}};
  std::map<std::string, mpq_class> result;
  for (const auto& [word, value] : said.fields()) {
    const files::NamedShape named = files::named_shape(word);
    if (word != vertices_word && (!named.shape || named.rounded))
      refuse(fmt::format("{}, {} in \"rounding\" in the hello", vertices_word, files::list_of_shapes()),
             kernels::shown(word));
    result[std::string(word)] = radius_in(*value);
  }
  return result;
}

}  // namespace

Faces faces_of(const std::vector<Point>& points) {
  const polytope::Polytope hull = polytope::convex_hull(polytope::place(points, points).a.points());
  Faces faces;
  if (hull.rank < 3) return faces;
  for (const polytope::Facet& facet : hull.facets) {
    std::vector<std::uint32_t>& face = faces.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) face.push_back(hull.input_ids[hull.corners[i]]);
  }
  return faces;
}

std::string hello_message() { return fmt::format(R"({{"type":"hello","protocol":"{}"}})", protocol_name); }

std::string run_message(const std::string& ticket, const Case& seen, Precision precision, bool with_faces) {
  text::JsonStream out;
  out.open('{').key("type").plain("run").key("id").plain(ticket).key("a");
  add_body(out, seen.a, precision, with_faces);
  out.key("b");
  add_body(out, seen.b, precision, with_faces);
  return out.close('}').take();
}

std::string body_message(const Body& body, Precision precision, bool with_faces) {
  text::JsonStream out;
  add_body(out, body, precision, with_faces);
  return out.take();
}

std::string stop_message() { return R"({"type":"stop"})"; }

SubjectAnswer read_reply(std::string_view line, const NumberFormat& format) {
  const Json object = object_on(line);
  if (text_in(object, "type", "the reply") != "reply") refuse("a message of type \"reply\"", kernels::shown(line));
  SubjectAnswer answer{id_in(object), Failed()};
  if (object.find("unsupported")) answer.said = Unsupported{reason_in(object, "unsupported")};
  else if (object.find("failed")) answer.said = Failed{reason_in(object, "failed")};
  else {
    answer.said = read_answer(object, format.answers);
    answer.remark = misspelt(object);
    read_rest(object, format.points, answer);
  }
  return answer;
}

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
  if (hello.find("library")) info.library = text_in(hello, "library", of);
  info.format = format_in(hello);
  info.conventions = conventions_in(hello);
  if (hello.find("capabilities")) read_capabilities(object_in(hello, "capabilities", of), info);
  if (hello.find("settings"))
    for (const auto& [key, value] : object_in(hello, "settings", of).fields())
      info.settings[std::string(key)] =
          value->is_string() ? value->text() : value->written(JsonValue::Form::sorted).text();
  if (const Json* promises = hello.find("promises")) info.promises = promises_in(*promises);
  if (const Json* rounding = hello.find("rounding")) info.rounding = rounding_in(*rounding);
  return info;
}

bool is_hello(std::string_view line) {
  const Json object = json_on(line);
  const Json* const type = object.find("type");
  return type && type->is_string() && type->string() == "hello";
}

}  // namespace fathom::harness
