// SPDX-License-Identifier: GPL-3.0-or-later
// The fields that a case may have, and the walk over all that was read of one, in its order, which
// says where the first fault is.
#include "reference/files/case_fields.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernels/messages.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

using Names = std::vector<std::string_view>;

constexpr std::array<std::string_view, 11> of_cases = {
    "schema", "id", "a", "b", "pose_rounding", "twist", "flags", "source", "comment", "dimension", "motion"};
constexpr std::array<std::string_view, 8> of_bodies = {"vertices", "faces",         "pose",   "shape",
                                                       "margin",   "pose_rounding", "pieces", "solid"};
constexpr std::array<std::string_view, 8> of_poses = {"translation", "quaternion", "xyz",   "quat",
                                                      "xyzw",        "rpy",        "euler", "unit"};

void add_fields(const ShapeName& shape, Names& names) {
  for (const NumberField& field : shape.numbers) names.push_back(field.name);
  if (shape.part == ShapePart::axis) names.push_back("axis");
  if (shape.part == ShapePart::terms) names.push_back("terms");
}

const Names& of_any_body() {
  static const Names names = [] {
    Names all(of_bodies.begin(), of_bodies.end());
    for (const ShapeName& shape : shape_names()) add_fields(shape, all);
    return all;
  }();
  return names;
}

template <class Known>
bool is_near_one(std::string_view key, const Known& known) {
  if (std::ranges::find(known, key) != known.end()) return false;
  return std::ranges::any_of(known, [key](std::string_view word) { return kernels::is_near(key, word); });
}

void note(const text::JsonValue& object, const std::string& path, std::span<const std::string_view> known,
          std::vector<CaseNote>& notes) {
  std::vector<std::string> there;
  for (const auto& [key, value] : object.fields()) there.emplace_back(key);
  const std::string sentence = kernels::near_misses(there, known);
  if (!sentence.empty()) notes.push_back({CaseNote::field, (path.empty() ? "" : path + ": ") + sentence});
}

// ---- the walk: it goes on after a fault, as an id that comes later still names the case ----

using text::JsonValue;

/// Where a value stands: a field, or an element, of what stands at `outer`.
struct Path {
  static constexpr std::size_t no_index = std::string_view::npos;

  const Path* outer = nullptr;
  std::string_view field;
  std::size_t index = no_index;

  [[nodiscard]] std::string text() const {
    if (!outer) return "";
    const std::string before = outer->text();
    if (index != no_index) return before + "[" + std::to_string(index) + "]";
    return before + (before.empty() || field.empty() ? "" : ".") + std::string(field);
  }
};

/// Returns what belongs there, for messages.
std::string expected_at(CasePlace place) {
  switch (place) {
    case CasePlace::whole: return "a case (a JSON object)";
    case CasePlace::schema: return '"' + std::string(case_schema) + '"';
    case CasePlace::id: return "text or a number";
    case CasePlace::rounding:
    case CasePlace::body_rounding: return "\"binary64\"";
    case CasePlace::dimension: return "2 or 3";
    case CasePlace::twist: return "an object with 'a' or 'b'";
    case CasePlace::body: return "an object with 'vertices', 'shape', 'pieces' or 'solid'";
    case CasePlace::vertices: return "an array of points";
    case CasePlace::vertex: return "three coordinates";
    case CasePlace::faces: return "an array of faces";
    case CasePlace::pose: return "three rows of four numbers";
    case CasePlace::pose_row: return "four numbers";
    default: return "a number, or an exact number in quotes";
  }
}

class CaseWalk {
 public:
  CaseFields fields;

  void value(const JsonValue& value, CasePlace place, const Path& path, BodyFields* body);

 private:
  using FieldsRead = std::vector<std::string_view>;

  void fault(const Path& path, const std::string& expected, const std::string& found) {
    const std::string where = path.text();
    report((where.empty() ? "" : where + ": ") + "expected " + expected + ", found " + found);
  }
  void wrong(const Path& path, CasePlace place, const std::string& found) { fault(path, expected_at(place), found); }
  void report(const std::string& sentence) {
    if (fields.fault.empty()) fields.fault = sentence;
  }

  void string(const JsonValue& value, CasePlace place, const Path& path, BodyFields* body);
  void skip(const JsonValue& value, CasePlace place, const Path& path, BodyFields* body);
  void find_limits(const JsonValue& value, const Path& path);
  /// A body that read_shapes reads.
  void of_plane(const JsonValue& value, const Path& path) {
    fields.misspelt = true;  // perhaps
    find_limits(value, path);
  }
  void too_large(const JsonValue& value, const Path& path) {
    fields.fault.clear();  // the text ends here
    fault(path, "a number within the range of binary64", kernels::shown(value.text()));
  }
  CasePlace field(std::string_view key, CasePlace place, const Path& path, FieldsRead& seen);
  /// Looks at the fields of a body, or of the case if there is none, and returns those that are
  /// ours.
  FieldsRead all_fields(const JsonValue& object, const Path& path, BodyFields* body);
  void whole(const JsonValue& object, const Path& path);
  void body_of(const JsonValue& object, const Path& path, BodyFields& body);
  void vertices(const JsonValue& rows, const Path& path, BodyFields& body);
  void pose(const JsonValue& rows, const Path& path, BodyFields& body);
  std::array<mpq_class, 4> row(const JsonValue& numbers, CasePlace place, const Path& path, BodyFields& body);
};

/// Returns whether null there means the same as no field.
bool may_be_null(CasePlace place) {
  return place == CasePlace::other || place == CasePlace::shape || place == CasePlace::id ||
         place == CasePlace::twist || place == CasePlace::pose || place == CasePlace::faces ||
         place == CasePlace::rounding || place == CasePlace::body_rounding || place == CasePlace::dimension;
}

bool is_dimension(const JsonValue& value, CasePlace place) {
  return place == CasePlace::dimension && value.is_natural() && (value.number() == 2 || value.number() == 3);
}

void CaseWalk::value(const JsonValue& value, CasePlace place, const Path& path, BodyFields* body) {
  const bool of_shape = place == CasePlace::shape;
  if (value.too_large) return too_large(value, path);
  switch (value.kind()) {
    case JsonValue::Kind::null:
      if (!may_be_null(place)) wrong(path, place, "null");
      return;
    case JsonValue::Kind::boolean:
      if (of_shape) body->is_shape = true;
      else if (place != CasePlace::other) wrong(path, place, value.text());
      return;
    case JsonValue::Kind::string: return string(value, place, path, body);
    case JsonValue::Kind::object:
      if (of_shape || place == CasePlace::pose) body->is_shape = true;
      if (place == CasePlace::whole) return whole(value, path);
      if (place == CasePlace::body) return fields.plane ? of_plane(value, path) : body_of(value, path, *body);
      return skip(value, place, path, body);
    case JsonValue::Kind::array:
      if (place == CasePlace::vertices) return vertices(value, path, *body);
      if (place == CasePlace::pose) return pose(value, path, *body);
      return skip(value, place, path, body);
    default:  // a number
      if (place == CasePlace::id) fields.id = value.text();
      else if (of_shape) body->is_shape = true;
      else if (place != CasePlace::other && !is_dimension(value, place))
        wrong(path, place, kernels::printable(value.text(), kernels::readable));
  }
}

void CaseWalk::string(const JsonValue& value, CasePlace place, const Path& path, BodyFields* body) {
  const std::string text = value.text();
  bool good = true;
  switch (place) {
    case CasePlace::shape:
    case CasePlace::pose: body->is_shape = true; break;
    case CasePlace::id: fields.id = text; break;
    case CasePlace::schema: good = text == case_schema; break;
    case CasePlace::rounding: good = fields.rounded = text == "binary64"; break;
    case CasePlace::body_rounding: good = body->rounded = text == "binary64"; break;
    default: good = place == CasePlace::other;
  }
  if (!good) wrong(path, place, "\"" + kernels::printable(text, kernels::readable) + "\"");
}

/// An array or object that is not ours, or not where it stands, or read elsewhere.
void CaseWalk::skip(const JsonValue& value, CasePlace place, const Path& path, BodyFields* body) {
  if (place == CasePlace::faces) body->has_faces = true;
  if (place == CasePlace::twist) fields.moves = true;
  if (place == CasePlace::shape) body->is_shape = true;
  const bool elsewhere = place == CasePlace::other || place == CasePlace::shape || place == CasePlace::faces ||
                         (place == CasePlace::pose && body->is_shape) ||
                         (place == CasePlace::twist && value.is_object());
  if (!elsewhere) wrong(path, place, value.is_object() ? "an object" : "an array");
  find_limits(value, path);
}

/// Whether something in it could not be read.
void CaseWalk::find_limits(const JsonValue& value, const Path& path) {
  if (value.too_deep) fault(Path(), "values nested at most 64 deep", "a deeper one");
  if (value.too_large) too_large(value, path);
  for (const JsonValue& item : value.items()) find_limits(item, path);
}

// A repeated key of ours is refused: readers differ in which of the two they take.
CasePlace CaseWalk::field(std::string_view key, CasePlace place, const Path& path, FieldsRead& seen) {
  if (place == CasePlace::other) return place;
  if (std::ranges::find(seen, key) == seen.end()) seen.push_back(key);
  else fault(path, "one field of this name", "a second one");
  return place;
}

CaseWalk::FieldsRead CaseWalk::all_fields(const JsonValue& object, const Path& path, BodyFields* body) {
  FieldsRead seen;
  for (std::size_t i = 0; i < object.items().size(); ++i) {
    const std::string_view key = object.key(i);
    const Path place{&path, key};
    const CasePlace kind = field(key, body ? field_of_body(key) : field_of_case(key), place, seen);
    if (kind == CasePlace::other) fields.misspelt = fields.misspelt || looks_misspelt(key, body != nullptr);
    value(object.items()[i], kind, place, body ? body : key == "a" ? &fields.a : &fields.b);
  }
  return seen;
}

void CaseWalk::whole(const JsonValue& object, const Path& path) {
  if (const JsonValue* const dimension = object.find("dimension"))  // it may stand behind the bodies
    fields.plane = is_dimension(*dimension, CasePlace::dimension) && dimension->number() == 2;
  const FieldsRead seen = all_fields(object, path, nullptr);
  for (const std::string name : {"a", "b"})
    if (std::ranges::find(seen, name) == seen.end()) fault(path, "a field '" + name + "'", "none");
  if (fields.plane && fields.moves) fault({&path, "twist"}, "no such field in the plane", "one");
}

void CaseWalk::body_of(const JsonValue& object, const Path& path, BodyFields& body) {
  const FieldsRead seen = all_fields(object, path, &body);
  if (!body.is_shape && std::ranges::find(seen, "vertices") == seen.end()) fault(path, "a field 'vertices'", "none");
}

void CaseWalk::vertices(const JsonValue& rows, const Path& path, BodyFields& body) {
  std::vector<Point>& points = body.vertices.edit();
  for (std::size_t i = 0; i < rows.items().size(); ++i) {
    const Path place{&path, "", i};
    if (!rows.items()[i].is_array()) {
      value(rows.items()[i], CasePlace::vertex, place, &body);
      continue;
    }
    auto [x, y, z, more] = row(rows.items()[i], CasePlace::coordinate, place, body);
    points.push_back({std::move(x), std::move(y), std::move(z)});
    if (rows.items()[i].items().size() != 3)
      wrong(place, CasePlace::vertex, std::to_string(rows.items()[i].items().size()));
  }
  if (rows.items().empty()) fault(path, "at least one point", "none");
}

void CaseWalk::pose(const JsonValue& rows, const Path& path, BodyFields& body) {
  body.pose.emplace();
  for (std::size_t i = 0; i < rows.items().size(); ++i) {
    const Path place{&path, "", i};
    if (!rows.items()[i].is_array()) {
      value(rows.items()[i], CasePlace::pose_row, place, &body);
      continue;
    }
    std::array<mpq_class, 4> entries = row(rows.items()[i], CasePlace::pose_entry, place, body);
    if (i < body.pose->size()) (*body.pose)[i] = std::move(entries);
    if (rows.items()[i].items().size() != 4)
      wrong(place, CasePlace::pose_row, std::to_string(rows.items()[i].items().size()));
  }
  if (rows.items().size() == 4) body.is_shape = true;
  else if (rows.items().size() != 3) wrong(path, CasePlace::pose, std::to_string(rows.items().size()));
}

/// The first four numbers of a row, whose length is not looked at.
std::array<mpq_class, 4> CaseWalk::row(const JsonValue& numbers, CasePlace place, const Path& path, BodyFields& body) {
  std::array<mpq_class, 4> result;
  for (std::size_t i = 0; i < numbers.items().size(); ++i) {
    const JsonValue& item = numbers.items()[i];
    const Path at{&path, "", i};
    ParsedNumber number = item.too_large ? ParsedNumber() : text::exact_number(item);
    if (!number.error.empty()) report(at.text() + ": " + number.error);
    else if (!number.value) value(item, place, at, &body);
    else if (i < result.size()) result[i] = *std::move(number.value);
  }
  return result;
}

}  // namespace

CasePlace field_of_case(std::string_view key) {
  if (key == "schema") return CasePlace::schema;
  if (key == "id") return CasePlace::id;
  if (key == "pose_rounding") return CasePlace::rounding;
  if (key == "twist") return CasePlace::twist;
  if (key == "dimension") return CasePlace::dimension;
  return key == "a" || key == "b" ? CasePlace::body : CasePlace::other;
}

CasePlace field_of_body(std::string_view key) {
  if (key == "vertices") return CasePlace::vertices;
  if (key == "pose") return CasePlace::pose;
  if (key == "faces") return CasePlace::faces;
  if (key == "pose_rounding") return CasePlace::body_rounding;
  return is_field_of_shapes(key) ? CasePlace::shape : CasePlace::other;
}

bool is_field_of_shapes(std::string_view key) {
  constexpr std::array<std::string_view, 7> others = {"shape", "axis", "vertices", "faces", "terms", "pieces", "solid"};
  return std::ranges::find(others, key) != others.end() || number_field(key) != nullptr;
}

bool has_field(const ShapeName& shape, std::string_view key) {
  if (key == "axis") return shape.part == ShapePart::axis;
  if (key == "vertices") return shape.part == ShapePart::vertices;
  if (key == "faces") return shape.name == "hull";
  if (key == "terms") return shape.part == ShapePart::terms;
  return key == "shape" || number_field(shape, key);
}

bool looks_misspelt(std::string_view key, bool of_body) {
  return of_body ? is_near_one(key, of_any_body()) : is_near_one(key, of_cases);
}

std::string misspelt_in_pose(std::span<const std::string> keys) { return kernels::near_misses(keys, of_poses); }

std::vector<CaseNote> misspelt_fields(const text::JsonValue& document, bool plane) {
  std::vector<CaseNote> notes;
  note(document, "", of_cases, notes);
  for (const char* name : {"a", "b"}) {
    const text::JsonValue* const body = document.find(name);
    if (!body || !body->is_object()) continue;
    Names known(of_bodies.begin(), of_bodies.end());
    const text::JsonValue* const shape = body->find("shape");
    if (shape && shape->is_string())
      if (const ShapeName* const named = named_shape(shape->text(), plane ? 2 : 3).shape) add_fields(*named, known);
    note(*body, name, known, notes);
  }
  return notes;
}

CaseFields read_case_fields(std::string_view text, const text::JsonRead& read) {
  CaseWalk walk;
  walk.value(read.value, CasePlace::whole, Path(), nullptr);
  CaseFields fields = std::move(walk.fields);
  const auto column = [&](std::size_t position) {
    const std::string_view before = text.substr(0, position);
    fields.fault_line = static_cast<std::size_t>(std::ranges::count(before, '\n'));
    return "column " + std::to_string(before.size() - (before.rfind('\n') + 1) + 1);
  };
  constexpr std::size_t readable_reason = 160;
  if (!read.whole) {
    const std::string place = column(read.error_at);
    if (!read.error.empty())
      fields.fault =
          "expected JSON, found a syntax error at " + place + ": " + kernels::printable(read.error, readable_reason);
  }
  // To the parser it is the end of the text: what follows would be passed over.
  if (const std::size_t null = text.find('\0'); null != text.npos)
    fields.fault = "expected JSON, found a null byte at " + column(null);
  return fields;
}

}  // namespace fathom::files
