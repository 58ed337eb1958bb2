// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/protocol.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/judge/fields.hpp"

namespace fathom::harness {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool same_word(std::string_view text, std::string_view lower) {
  if (text.size() != lower.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(text[i])) != lower[i]) return false;
  return true;
}

/// Returns the bare word at the beginning of a text; "nan(0x8000)" is one word.
std::string_view first_word(std::string_view text) {
  std::size_t end = 0;
  const auto belongs = [&](char c) {
    return is_letter(c) || is_digit(c) || c == '+' || c == '-' || c == '.' || c == '_' || c == '#';
  };
  while (end < text.size() && belongs(text[end])) ++end;
  if (end < text.size() && text[end] == '(') {
    const std::size_t close = text.find(')', end);
    if (close != std::string_view::npos) end = close + 1;
  }
  return text.substr(0, end);
}

/// Returns whether the word is "nan", or "nan(0x8000)" with a payload as C writes it.
bool is_nan(std::string_view word) {
  if (!same_word(word.substr(0, word.find('(')), "nan")) return false;
  const std::string_view rest = word.substr(3);
  const auto belongs = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  return rest.empty() ||
         (rest.size() > 1 && rest.back() == ')' && std::all_of(rest.begin() + 1, rest.end() - 1, belongs));
}

std::string_view without_sign(std::string_view word) {
  return word.starts_with('-') || word.starts_with('+') ? word.substr(1) : word;
}

bool is_infinite(std::string_view word) { return same_word(word, "inf") || same_word(word, "infinity"); }

bool looks_like_a_number(std::string_view word) {
  const std::string_view size = without_sign(word);
  return !size.empty() && (is_digit(size[0]) || size[0] == '.' || is_nan(size) || is_infinite(size));
}

/// Returns the number with its exponent limited to the largest that parse_number reads. Beyond
/// that, every number of at most `longest` characters is infinite, or 0, with either exponent.
std::string with_exponent_in_reach(std::string_view text) {
  constexpr std::size_t longest = 90'000;  // characters: fewer digits, and fewer bits, than the exponents' limits
  const std::string_view size = without_sign(text);
  const bool hex = size.size() > 1 && same_word(size.substr(0, 2), "0x");
  const std::size_t letter = text.find_first_of(hex ? "pP" : "eE");
  if (letter == text.npos || text.size() > longest) return std::string(text);
  const std::size_t digits =
      letter + 1 + (letter + 1 < text.size() && (text[letter + 1] == '-' || text[letter + 1] == '+') ? 1 : 0);
  if (digits == text.size() || !std::all_of(text.begin() + static_cast<std::ptrdiff_t>(digits), text.end(), is_digit))
    return std::string(text);
  const std::string_view exponent = text.substr(std::min(text.find_first_not_of('0', digits), text.size()));
  const std::string largest = std::to_string(hex ? largest_binary_exponent : largest_decimal_exponent);
  const bool in_reach = exponent.size() < largest.size() || (exponent.size() == largest.size() && exponent <= largest);
  return std::string(text.substr(0, digits)) + (in_reach ? std::string(text.substr(digits)) : largest);
}

constexpr std::size_t shown_bytes = 200;

/// Returns the name of a field that occurs twice in an object of the value, or "".
std::string repeated_field(const JsonValue& value) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < value.items().size(); ++i) {
    if (value.is_object()) names.push_back(value.key(i));
    if (std::string within = repeated_field(value.items()[i]); !within.empty()) return within;
  }
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  return twice == names.end() ? "" : std::string(*twice);
}

Body piece_of(const Body& body, const std::vector<Point>& piece) {
  Body result{piece};
  result.dimension = body.dimension;
  return result;
}

void add_body(text::JsonStream& out, const Body& body, Precision precision, bool with_faces) {
  if (body.pieces && body.pieces->size() == 1)  // a union of one piece is a polytope
    return add_body(out, piece_of(body, body.pieces->front()), precision, with_faces);
  if (body.words && !body.pieces) {
    out.value(files::body_json(*body.words, files::Defaults::written).text());
    return;
  }
  out.object([&] {
    if (body.pieces) {
      out.key("pieces");
      out.array_of(*body.pieces, [&](const std::vector<Point>& piece) {
        add_body(out, piece_of(body, piece), precision, with_faces);
      });
      return;
    }
    const bool in_plane = body.dimension == 2;
    const GivenPoints points = in_plane && body.shape ? GivenPoints(core_of(body)) : body.points;
    const std::optional<GivenPoints> rounded = seen(points, precision);
    if (!rounded) throw std::invalid_argument("a coordinate overflows the subject's precision");
    out.key("vertices");
    // Whether a subject reads a number by strtod, by strtof, or by strtod with subsequent rounding,
    // it gets the same number.
    out.array_of(rounded->binary64(), [&](const std::array<double, 3>& p) {
      out.value(in_plane ? fmt::format("[{},{}]", p[0], p[1]) : fmt::format("[{},{},{}]", p[0], p[1], p[2]));
    });
    if (in_plane && body.shape) out.key("margin").value(fmt::format("{}", round_binary64(body.shape->radius)));
    const Faces faces = !with_faces ? Faces() : in_plane ? edges_in_plane(points.exact()) : faces_of(points.exact());
    if (!faces.empty())
      out.key("faces"), out.array_of(faces, [&](const std::vector<std::uint32_t>& face) { out.array_of(face); });
  });
}

// ---- replies ----

/// Returns the JSON in quotes for messages, with numbers as they were written.
std::string shown_json(const JsonValue& value) {
  return '\'' + kernels::printable(value.written(JsonValue::Form::sorted).text(), shown_bytes) + '\'';
}

/// Throws ProtocolError: "expected ..., found ...".
[[noreturn]] void refuse(const std::string& expected, const std::string& found) {
  throw ProtocolError("expected " + expected + ", found " + found);
}

// Each function throws ProtocolError unless the field `name` exists and has its type; `of` names
// the object in the message.
std::string text_in(const JsonValue& object, const char* name, const char* of) {
  const JsonValue* value = object.find(name);
  if (!value) refuse(fmt::format("\"{}\" in {}", name, of), "none");
  if (!value->is_string()) refuse(fmt::format("a text for \"{}\" in {}", name, of), shown_json(*value));
  return value->text();
}

/// Returns an id, which may be a text or an integer.
std::string id_in(const JsonValue& reply) {
  const JsonValue* id = reply.find("id");
  if (!id || !id->is_number()) return text_in(reply, "id", "the reply");
  const std::optional<std::string> integer = read_integer(id->text());
  if (!integer) refuse("a text or an integer for \"id\" in the reply", shown_json(*id));
  return *integer;
}

/// Returns the reason of a reply without an answer.
std::string reason_in(const JsonValue& reply, const char* name) {
  std::vector<std::string_view> others = text::names_of(judging::reply_fields);
  others.insert(others.end(), {"hull", "unsupported", "failed"});
  for (const std::string_view other : others)
    if (other != name && reply.find(other))
      refuse(fmt::format("nothing but \"id\" beside \"{}\"", name), fmt::format("\"{}\"", other));
  return text_in(reply, name, "the reply");
}

/// Reads a decimal or C99 hex float with any exponent, rounded once to the precision, or a spelling
/// of NaN or infinity with or without a sign, in upper or lower case ("-nan", "NAN", "nan(0x8000)",
/// "inf", "-Infinity"). Returns nullopt for anything else, ratios included.
std::optional<double> read_number(std::string_view text, Precision precision) {
  const std::string_view word = without_sign(text);
  if (is_nan(word)) return std::numeric_limits<double>::quiet_NaN();
  if (is_infinite(word)) return (text[0] == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
  if (text.find('/') != text.npos) return std::nullopt;
  const ParsedNumber number = parse_number(with_exponent_in_reach(text), Decimals::exact);
  if (!number.value) return std::nullopt;
  if (precision == Precision::binary32) return round_binary32(*number.value, Rounding::rn);
  return round_binary64(*number.value, Rounding::rn);
}

/// Returns a number, or the number in a text, rounded to the precision; NaN and infinities too.
double number_of(const JsonValue& value, const char* name, Precision precision) {
  std::optional<double> number;
  if (value.is_number()) number = kernels::quick_number(value.text(), Decimals::binary64);
  // A decimal whose nearest binary64 is a binary32 has that for its nearest binary32.
  if (number && (precision == Precision::binary64 || kernels::nearest_binary32(*number) == *number))
    return *number == 0 ? 0 : *number;  // not -0
  if (value.is_number() || value.is_string()) number = read_number(value.text(), precision);
  if (!number)
    refuse(fmt::format("a number for \"{}\"{}", name, value.is_null() ? " (NaN is \"nan\")" : ""), shown_json(value));
  return *number;
}

/// The numbers of replies, and how many coordinates a point has.
struct Coordinates {
  Precision precision;
  unsigned dimension;
};

/// Returns the triple in a value, in the plane with z = 0; `name` is its field's, for messages.
Triple triple_of(const JsonValue& value, const char* name, Coordinates of) {
  Triple triple{};
  if (value.items().size() != of.dimension || !value.is_array())
    refuse(fmt::format("{} numbers for \"{}\"", of.dimension == 2 ? "two" : "three", name), shown_json(value));
  for (std::size_t i = 0; i < of.dimension; ++i) triple[i] = number_of(value.items()[i], name, of.precision);
  return triple;
}

/// Returns the vertices of a hull that the subject used, if the reply has it.
std::optional<std::vector<Triple>> hull_in(const JsonValue& object, const char* name, const char* called,
                                           Coordinates of) {
  const JsonValue* list = object.find(name);
  if (!list) return std::nullopt;
  if (!list->is_array() || list->items().empty())
    refuse(fmt::format("a list of vertices for \"{}\"", called), shown_json(*list));
  std::vector<Triple> vertices;
  for (const JsonValue& vertex : list->items()) {
    vertices.push_back(triple_of(vertex, called, of));
    if (!std::ranges::all_of(vertices.back(), [](double x) { return std::isfinite(x); }))
      refuse(fmt::format("finite numbers for \"{}\"", called), shown_json(vertex));
  }
  return vertices;
}

/// Reads the optional fields beside an answer.
void read_rest(const JsonValue& object, Coordinates points, SubjectAnswer& answer) {
  if (const JsonValue* hull = object.find("hull")) {
    if (!hull->is_object()) refuse("an object for \"hull\"", shown_json(*hull));
    answer.hull_a = hull_in(*hull, "a", "hull.a", points);
    answer.hull_b = hull_in(*hull, "b", "hull.b", points);
  }
  const JsonValue* time = object.find("microseconds");
  if (!time) return;
  const std::optional<double> value = time->is_number() ? read_number(time->text(), Precision::binary64) : std::nullopt;
  if (value && std::isfinite(*value) && *value >= 0) answer.microseconds = value;
  else answer.remark += (answer.remark.empty() ? "" : "; ") + ("\"microseconds\" is no time: " + shown_json(*time));
}

/// Returns three numbers; nullopt if the field is missing.
std::optional<Triple> triple_in(const JsonValue& object, const char* name, const char* called, Coordinates of) {
  const JsonValue* value = object.find(name);
  return value ? std::optional(triple_of(*value, called, of)) : std::nullopt;
}

std::vector<ContactPoint> contacts_in(const JsonValue& list, Coordinates of) {
  if (!list.is_array() || list.items().empty()) refuse("a list of contacts for \"contacts\"", shown_json(list));
  std::vector<ContactPoint> contacts;
  for (const JsonValue& each : list.items()) {
    const std::optional<Triple> position =
        each.is_object() ? triple_in(each, "position", "position", of) : std::nullopt;
    if (!position) refuse("an object with a \"position\" in \"contacts\"", shown_json(each));
    contacts.push_back({*position, {}});
    if (const JsonValue* depth = each.find("depth")) contacts.back().depth = number_of(*depth, "depth", of.precision);
  }
  return contacts;
}

// These functions read an optional field `name` of a reply's object; `called` names it in messages.
void read(const JsonValue& object, const char* name, const char* called, Coordinates of, std::optional<double>& value) {
  if (const JsonValue* found = object.find(name)) value = number_of(*found, called, of.precision);
}
void read(const JsonValue& object, const char* name, const char* called, Coordinates of, std::optional<Triple>& value) {
  value = triple_in(object, name, called, of);
}
void read(const JsonValue& object, const char* name, const char*, Coordinates of, std::vector<ContactPoint>& contacts) {
  if (const JsonValue* found = object.find(name)) contacts = contacts_in(*found, of);
}
bool flag_in(const JsonValue& object, const char* name, const char* of, std::optional<bool> otherwise = std::nullopt) {
  const JsonValue* value = object.find(name);
  if (!value && otherwise) return *otherwise;
  if (!value) refuse(fmt::format("\"{}\" in {}", name, of), "none");
  if (!value->is_boolean()) refuse(fmt::format("true or false for \"{}\" in {}", name, of), shown_json(*value));
  return value->boolean();
}

void read(const JsonValue& object, const char* name, const char*, Coordinates, bool& value) {
  value = flag_in(object, name, "the reply");
}

Reply read_answer(const JsonValue& object, Coordinates numbers) {
  Reply reply;
  text::for_each_field(judging::reply_fields, [&](const auto& row) {
    const std::string path(row.name);
    const std::size_t dot = path.find('.');
    const JsonValue* of = &object;
    if (dot != path.npos) {
      const std::string whole = path.substr(0, dot);
      of = object.find(whole);
      if (of && !of->is_object()) refuse(fmt::format("an object for \"{}\"", whole), shown_json(*of));
    }
    if (of) read(*of, path.c_str() + (dot == path.npos ? 0 : dot + 1), path.c_str(), numbers, reply.*row.member);
  });
  return reply;
}

/// Returns a remark on misspelt fields in all objects of a reply, or "".
std::string misspelt(const JsonValue& reply) {
  constexpr std::string_view of_witness[] = {"a", "b"};
  static const std::vector<std::string_view> of_contact = text::names_of(judging::contact_fields);
  static const std::vector<std::string_view> known = [] {
    std::vector<std::string_view> names = text::names_of(judging::reply_fields);
    names.insert(names.begin(), {"type", "id"});
    names.insert(names.end(), {"hull", "microseconds", "unsupported", "failed"});
    return names;
  }();
  const auto fields = [](const JsonValue& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.fields()) names.emplace_back(name);
    return names;
  };
  std::string remark = kernels::near_misses(fields(reply), known);
  const auto look_inside = [&](const JsonValue& object, std::span<const std::string_view> names) {
    if (const std::string inside = kernels::near_misses(fields(object), names); !inside.empty())
      remark += (remark.empty() ? "" : "; ") + inside;
  };
  if (const JsonValue* witness = reply.find("witness")) look_inside(*witness, of_witness);
  if (const JsonValue* contacts = reply.find("contacts"))
    for (const JsonValue& contact : contacts->items()) look_inside(contact, of_contact);
  return remark;
}

// ---- the hello ----

/// Returns the value of its type's word in the field.
template <class Value>
Value word_in(const JsonValue& object, const char* name, const char* of) {
  const std::string text = text_in(object, name, of);
  std::vector<std::string_view> expected;
  for (const auto& [word, value] : judging::words_of(Value())) {
    if (text == word) return value;
    expected.push_back(word);
  }
  refuse(fmt::format("{} for \"{}\" in {}", fmt::join(expected, ", "), name, of), kernels::shown(text));
}

// These functions read a field of the hello. An absent one keeps its default, if its row says that
// it may be absent.
void read(const JsonValue& said, const char* name, const char* of, bool& value) { value = flag_in(said, name, of); }
template <class Value>
void read(const JsonValue& said, const char* name, const char* of, Value& value) {
  value = word_in<Value>(said, name, of);
}

const JsonValue& object_in(const JsonValue& object, const char* name, const char* of) {
  const JsonValue* value = object.find(name);
  if (!value || !value->is_object())
    refuse(fmt::format("an object for \"{}\" in {}", name, of), value ? shown_json(*value) : "none");
  return *value;
}

Conventions conventions_in(const JsonValue& hello) {
  const JsonValue& said = object_in(hello, "conventions", "the hello");
  Conventions conventions;
  text::for_each_field(judging::conventions_fields, [&](const auto& row) {
    const std::string name(row.name);
    if (!row.there || said.find(name)) read(said, name.c_str(), "the hello's conventions", conventions.*row.member);
  });
  return conventions;
}

std::set<std::string> promises_in(const JsonValue& list) {
  std::set<std::string> promises;
  if (!list.is_array()) refuse("a list for \"promises\" in the hello", shown_json(list));
  constexpr std::array<std::string_view, 6> known = {"depth",    "direction", "witness",
                                                     "contacts", "distance",  "derivative"};
  for (const JsonValue& promise : list.items()) {
    if (!promise.is_string() || std::ranges::find(known, promise.string()) == known.end())
      refuse(fmt::format("{} in \"promises\" in the hello", fmt::join(known, ", ")), shown_json(promise));
    promises.insert(promise.string());
  }
  return promises;
}

/// The words for what a subject takes beside polytopes.
std::vector<std::string> words_for_shapes(unsigned dimension) {
  if (dimension == 2) return {std::string(circle_word), std::string(capsule_word), margin_word, pieces_word};
  std::vector<std::string> words;
  for (const files::ShapeName& shape : files::shape_names()) words.emplace_back(shape.name);
  words.insert(words.end(), {margin_word, pieces_word});
  return words;
}

std::set<std::string> shapes_in(const JsonValue& list, unsigned dimension) {
  std::set<std::string> shapes;
  const std::vector<std::string> words = words_for_shapes(dimension);
  if (!list.is_array()) refuse("a list for \"shapes\" in its capabilities", shown_json(list));
  for (const JsonValue& word : list.items()) {
    const std::string name = word.is_string() ? word.text() : "";
    if (std::ranges::find(words, name) == words.end())
      refuse(fmt::format("{} in \"shapes\" in its capabilities", fmt::join(words, ", ")), shown_json(word));
    shapes.insert(name);
  }
  return shapes;
}

void read_capabilities(const JsonValue& capabilities, SubjectInfo& info) {
  info.wants_faces = flag_in(capabilities, "faces", "its capabilities", false);
  info.wants_twist = flag_in(capabilities, "twist", "its capabilities", false);
  if (const JsonValue* shapes = capabilities.find("shapes")) info.shapes = shapes_in(*shapes, info.dimension);
}

unsigned dimension_in(const JsonValue& said) {
  for (const unsigned dimension : {2U, 3U})
    if (said.is_number() && read_integer(said.text()) == std::to_string(dimension)) return dimension;
  refuse("2 or 3 for \"dimension\" in the hello", shown_json(said));
}

/// Reads the number format: one type for both points and answers, or one for each.
NumberFormat format_in(const JsonValue& hello) {
  const auto type = [](const JsonValue& object, const char* name, const char* of) {
    return word_in<Precision>(object, name, of);
  };
  const JsonValue* said = hello.find("precision");
  if (!said || !said->is_object()) return type(hello, "precision", "the hello");
  return {type(*said, "points", "the hello's precision"), type(*said, "answers", "the hello's precision")};
}

double radius_in(const JsonValue& value, const char* name) {
  const double radius = value.is_number() ? number_of(value, name, Precision::binary64) : -1;
  if (!std::isfinite(radius) || radius < 0)
    refuse(fmt::format("a radius of at least 0 for \"{}\"", name), shown_json(value));
  return radius;
}

/// Reads the radii of rounding: one for all bodies, or one for each name.
std::map<std::string, mpq_class> rounding_in(const JsonValue& said) {
  if (!said.is_object()) return {{"", exact_value(radius_in(said, "rounding"))}};
  std::map<std::string, mpq_class> result;
  for (const auto& [word, value] : said.fields()) {
    const files::NamedShape named = files::named_shape(word);
    if (word != vertices_word && (!named.shape || named.rounded))
      refuse(fmt::format("{}, {} in \"rounding\" in the hello", vertices_word, files::list_of_shapes()),
             kernels::shown(word));
    result[std::string(word)] = exact_value(radius_in(*value, "rounding"));
  }
  return result;
}

/// Reads {"most": 4, "margin": 0.01}, both optional.
ContactLimits manifold_in(const JsonValue& said) {
  ContactLimits limits;
  if (!said.is_object()) refuse("an object for \"manifold\" in the hello", shown_json(said));
  if (const JsonValue* most = said.find("most")) {
    const double count = radius_in(*most, "manifold.most");
    if (count < 1 || count > 1e9 || std::floor(count) != count)
      refuse("a number of contacts for \"manifold.most\"", shown_json(*most));
    limits.most = static_cast<std::size_t>(count);
  }
  if (const JsonValue* margin = said.find("margin")) limits.margin = radius_in(*margin, "manifold.margin");
  return limits;
}

/// Returns the object on a line, in which each field must occur once, because readers of JSON
/// differ in which of two they take.
JsonValue object_on(std::string_view line) {
  if (line.find('\0') != std::string_view::npos)
    refuse("a JSON object", "a null byte in " + kernels::shown(line));  // to the parser, the end of the text
  JsonValue object = json_on(line);
  if (!object.is_object())
    throw ProtocolError("expected a JSON object, found " + (line.empty() ? "an empty line" : kernels::shown(line)));
  if (const std::string repeated = repeated_field(object); !repeated.empty())
    refuse("each field once", kernels::shown(repeated) + " twice");
  return object;
}

}  // namespace

std::size_t number_word(std::string_view text) {
  const std::string_view word = first_word(text);
  return looks_like_a_number(word) ? word.size() : 0;
}

std::optional<std::string> read_integer(std::string_view text) {
  const ParsedNumber number = parse_number(text, Decimals::exact);
  if (!number.value || number.value->get_den() != 1) return std::nullopt;
  return number.value->get_num().get_str();
}

JsonValue json_on(std::string_view line) {
  text::JsonRead read = text::read_json(line, number_word);
  return read.whole ? std::move(read.value) : JsonValue();
}

Faces faces_of(const std::vector<Point>& points) {
  const polytope::Polytope hull = polytope::hull_of(points);
  Faces faces;
  if (hull.rank < 3) return faces;
  for (const polytope::Facet& facet : hull.facets) {
    std::vector<std::uint32_t>& face = faces.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) face.push_back(hull.input_ids[hull.corners[i]]);
  }
  return faces;
}

Faces edges_in_plane(const std::vector<Point>& points) {
  const polytope::Polytope hull = polytope::hull_of(points);
  if (hull.rank < 2) return {};
  const auto facet = std::ranges::find_if(hull.facets, [](const polytope::Facet& each) { return each.normal.z > 0; });
  Faces edges;
  for (std::uint32_t i = facet->begin; i < facet->end; ++i) {
    const std::uint32_t next = i + 1 < facet->end ? i + 1 : facet->begin;
    edges.push_back({hull.input_ids[hull.corners[i]], hull.input_ids[hull.corners[next]]});
  }
  return edges;
}

std::string hello_message() { return text::Json{{"type", "hello"}, {"protocol", protocol_name}}.text(); }

std::string run_message(const std::string& ticket, const Case& seen, Precision precision, bool with_faces) {
  text::JsonStream out;
  out.open('{').key("type").plain("run").key("id").plain(ticket).key("a");
  add_body(out, seen.a, precision, with_faces);
  out.key("b");
  add_body(out, seen.b, precision, with_faces);
  if (seen.motion) out.key("twist").value(files::motion_json(*seen.motion).text());
  return out.close('}').take();
}

std::string body_message(const Body& body, Precision precision, bool with_faces) {
  text::JsonStream out;
  add_body(out, body, precision, with_faces);
  return out.take();
}

std::string stop_message() { return text::Json{{"type", "stop"}}.text(); }

SubjectAnswer read_reply(std::string_view line, const NumberFormat& format, unsigned dimension) {
  const JsonValue object = object_on(line);
  if (text_in(object, "type", "the reply") != "reply") refuse("a message of type \"reply\"", kernels::shown(line));
  SubjectAnswer answer{id_in(object), Failed()};
  if (object.find("unsupported")) answer.said = Unsupported{reason_in(object, "unsupported")};
  else if (object.find("failed")) answer.said = Failed{reason_in(object, "failed")};
  else {
    answer.said = read_answer(object, {format.answers, dimension});
    answer.remark = misspelt(object);
    read_rest(object, {format.points, dimension}, answer);
  }
  return answer;
}

SubjectInfo read_hello(std::string_view line) {
  const JsonValue hello = object_on(line);
  const char* const of = "the hello";
  if (text_in(hello, "type", of) != "hello") refuse("a message of type \"hello\"", kernels::shown(line));
  if (const std::string protocol = text_in(hello, "protocol", of); protocol != protocol_name)
    refuse(fmt::format("protocol {}", protocol_name), kernels::shown(protocol));
  SubjectInfo info;
  info.name = text_in(hello, "name", of);
  info.version = text_in(hello, "version", of);
  if (info.name.empty()) refuse("a name in the hello", "an empty one");
  if (hello.find("library")) info.library = text_in(hello, "library", of);
  if (const JsonValue* dimension = hello.find("dimension")) info.dimension = dimension_in(*dimension);
  info.format = format_in(hello);
  info.conventions = conventions_in(hello);
  if (hello.find("capabilities")) read_capabilities(object_in(hello, "capabilities", of), info);
  if (info.dimension == 2 && info.wants_twist)
    refuse("no \"twist\" among the capabilities of a subject of the plane", "one");
  if (hello.find("settings"))
    for (const auto& [key, value] : object_in(hello, "settings", of).fields())
      info.settings[std::string(key)] =
          value->is_string() ? value->text() : value->written(JsonValue::Form::sorted).text();
  if (const JsonValue* promises = hello.find("promises")) info.promises = promises_in(*promises);
  if (const JsonValue* rounding = hello.find("rounding")) info.rounding = rounding_in(*rounding);
  if (const JsonValue* manifold = hello.find("manifold")) info.conventions.manifold = manifold_in(*manifold);
  return info;
}

bool is_hello(std::string_view line) {
  const JsonValue object = json_on(line);
  const JsonValue* const type = object.find("type");
  return type && type->is_string() && type->string() == "hello";
}

}  // namespace fathom::harness
