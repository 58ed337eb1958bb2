// SPDX-License-Identifier: GPL-3.0-or-later
// Unlike vertices, which come by millions, these are read from a document: their objects are small,
// and some hold others.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/case_fields.hpp"
#include "reference/files/mesh_formats.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

using text::JsonValue;

constexpr const char* expected_pose =
    "three rows of four numbers, or an object with 'quaternion', or text such as \"xyz=0,0,1 rpy=0,0,90deg\"";

constexpr const char* expected_plane_pose =
    "two rows of three numbers, or an object with 'half_angle' or 'translation'";

std::string shown(const JsonValue& value) { return kernels::printable(value.written().text(), kernels::readable); }

std::string found(const JsonValue& value) {
  if (value.is_object()) return "an object";
  return value.is_array() ? "an array of " + std::to_string(value.items().size()) : shown(value);
}

/// The value of the field; null if it is not there, or if null is its value.
const JsonValue* given(const JsonValue& object, std::string_view name) {
  const JsonValue* const value = object.find(name);
  return value && !value->is_null() ? value : nullptr;
}

/// Returns whether the field means something in a body: such a field must not be repeated, since
/// readers differ in which one they take.
bool is_ours(std::string_view key) {
  return is_field_of_shapes(key) || key == "pose" || key == "pose_rounding" || key == "unit" || key == "half_angle" ||
         pose_word(key);
}

/// A field of ours that an object in the document has twice, the first by its second place; or "".
std::string repeated_field(const JsonValue& value) {
  std::vector<std::string_view> seen;
  for (std::size_t i = 0; i < value.items().size(); ++i) {
    if (value.is_object() && is_ours(value.key(i))) {
      if (std::ranges::find(seen, value.key(i)) != seen.end()) return std::string(value.key(i));
      seen.push_back(value.key(i));
    }
    if (std::string within = repeated_field(value.items()[i]); !within.empty()) return within;
  }
  return "";
}

/// In binary64 if all are numbers of it, as vertices of space are read.
GivenPoints points_as_given(std::vector<Point> points) {
  CollectedPoints collected;
  const auto coordinate = [](mpq_class& x) -> Coordinate {
    if (const std::optional<double> same = kernels::in_binary64(x)) return *same;
    return std::move(x);
  };
  for (Point& p : points) collected.add({coordinate(p.x), coordinate(p.y), coordinate(p.z)});
  return collected.take();
}

/// Reads one object, and those in it. After the first fault what is returned means nothing.
class Reader {
 public:
  std::string fault;
  std::vector<CaseNote> notes;
  unsigned dimension = 3;  // 2: a point has two coordinates, and its z is 0

  Body body(const JsonValue& json, const std::string& path, bool rounded);
  Twist twist(const JsonValue& json, const std::string& path);
  std::optional<GivenPose> pose(const JsonValue& value, const std::string& path);

 private:
  void report(const std::string& path, const std::string& expected, const std::string& instead) {
    refuse(path + ": expected " + expected + ", found " + instead);
  }
  void refuse(const std::string& sentence) {  // "" if there is nothing to refuse
    if (fault.empty()) fault = sentence;
  }

  mpq_class number(const JsonValue& value, const std::string& path);
  std::vector<mpq_class> numbers(const JsonValue& value, std::size_t count, const std::string& path);
  std::vector<Point> points(const JsonValue& value, const std::string& path);
  Axis axis(const JsonValue& value, const std::string& path);
  std::optional<GivenPose> plane_pose(const JsonValue& value, const std::string& path);
  std::vector<mpq_class> euler(const JsonValue& value, const std::string& path, std::string& wrong);
  GivenPose pose_of_words(const JsonValue& value, const std::string& path, std::string& wrong);
  ShapeFields fields(const JsonValue& json, const NamedShape& named, const std::string& path, NamedBody& words);
  Shape unplaced(const JsonValue& json, const std::string& path, NamedBody& words);
  Shape placed_shape(Shape shape, const JsonValue& json, const std::string& path, NamedBody& words);
  void round(Shape& shape, const std::string& path);
  Body piece(const JsonValue& json, const std::string& path);
  Body union_of(const JsonValue& json, const std::string& path, bool rounded);
  Body solid_of(const JsonValue& json, const std::string& path, bool rounded);
  void place_parts(std::vector<Body>& parts, const JsonValue& json, const std::string& path, bool rounded);
  bool is_rounded(const JsonValue& json, const std::string& path);
};

mpq_class Reader::number(const JsonValue& value, const std::string& path) {
  ParsedNumber parsed = text::exact_number(value);
  if (parsed.value) return *std::move(parsed.value);
  if (!parsed.error.empty()) refuse(path + ": " + parsed.error);
  else report(path, "a number, or an exact number in quotes", found(value));
  return 1;
}

std::vector<mpq_class> Reader::numbers(const JsonValue& value, std::size_t count, const std::string& path) {
  if (count == 1) return {number(value, path)};
  std::vector<mpq_class> result;
  if (!value.is_array() || value.items().size() != count) {
    report(path, count == 2 ? "two numbers" : count == 3 ? "three numbers" : "four numbers", found(value));
    result.resize(count, 1);
    return result;
  }
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(number(value.items()[i], path + "[" + std::to_string(i) + "]"));
  return result;
}

// Of a repeated field the last would count.
Twist Reader::twist(const JsonValue& json, const std::string& path) {
  if (!json.is_object()) {
    report(path, "an object", found(json));
    return {};
  }
  if (json.fields().size() < json.items().size()) report(path, "each field once", "one twice");
  const auto part = [&](const char* name) -> Point {
    const JsonValue* const value = json.find(name);
    if (!value) report(path, "a field '" + std::string(name) + "'", "none");
    const std::vector<mpq_class> x = value ? numbers(*value, 3, path + "." + name) : std::vector<mpq_class>(3);
    return {x[0], x[1], x[2]};
  };
  return {part("v"), part("w")};
}

std::vector<Point> Reader::points(const JsonValue& value, const std::string& path) {
  if (!value.is_array() || value.items().empty()) {
    report(path, "an array of points", found(value));
    return {{}};
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < value.items().size(); ++i) {
    const std::vector<mpq_class> p = numbers(value.items()[i], dimension, path + "[" + std::to_string(i) + "]");
    result.push_back({p[0], p[1], dimension == 2 ? mpq_class(0) : p[2]});
  }
  return result;
}

Axis Reader::axis(const JsonValue& value, const std::string& path) {
  for (const auto& [name, axis] : {std::pair("x", Axis::x), std::pair("y", Axis::y), std::pair("z", Axis::z)})
    if (value.is_string() && value.text() == name && (dimension == 3 || axis != Axis::z)) return axis;
  report(path, dimension == 2 ? R"("x" or "y")" : R"("x", "y" or "z")", found(value));
  return Axis::z;
}

// The tangent of half the angle is that of a quaternion about z.
std::optional<GivenPose> Reader::plane_pose(const JsonValue& value, const std::string& path) {
  GivenPose result;
  if (value.is_array() && value.items().size() == 2) {
    std::array<std::array<mpq_class, 3>, 2> rows;
    for (std::size_t row = 0; row < 2; ++row)
      std::ranges::copy(numbers(value.items()[row], 3, path + "[" + std::to_string(row) + "]"), rows[row].begin());
    result = files::plane_pose(rows);
  } else if (value.is_object()) {
    const JsonValue *const half_angle = given(value, "half_angle"), *const translation = given(value, "translation");
    if (!half_angle && !translation) report(path, expected_plane_pose, found(value));
    if (half_angle) result.turn.z = number(*half_angle, path + ".half_angle");
    const std::vector<mpq_class> t =
        translation ? numbers(*translation, 2, path + ".translation") : std::vector<mpq_class>(2);
    result.place = {t[0], t[1], 0};
    for (const auto& [key, of_space] : value.fields())
      if (!of_space->is_null() && pose_word(key) && key != "translation" && key != "half_angle")
        report(path + "." + std::string(key), "no such field of a pose in the plane", "one");
  } else {
    report(path, expected_plane_pose, found(value));
  }
  return fault.empty() ? std::optional(result) : std::nullopt;
}

std::optional<GivenPose> Reader::pose(const JsonValue& value, const std::string& path) {
  if (dimension == 2) return plane_pose(value, path);
  std::string wrong;
  GivenPose result;
  if (value.is_string()) {
    result = parse_pose(value.text(), Decimals::exact, wrong);
    if (result.plane && wrong.empty()) wrong = "expected a pose in space, found one in the plane";
  } else if (value.is_array() && (value.items().size() == 3 || value.items().size() == 4)) {
    std::vector<std::array<mpq_class, 4>> rows(value.items().size());
    for (std::size_t row = 0; row < rows.size(); ++row)
      std::ranges::copy(numbers(value.items()[row], 4, path + "[" + std::to_string(row) + "]"), rows[row].begin());
    result = pose_of(rows, wrong);
  } else if (value.is_object()) {
    result = pose_of_words(value, path, wrong);
  } else {
    report(path, expected_pose, found(value));
  }
  if (!wrong.empty()) refuse(path + ": " + wrong);
  if (!fault.empty()) return std::nullopt;
  return result;
}

// ["intrinsic zyx", 10, 20, 30]
std::vector<mpq_class> Reader::euler(const JsonValue& value, const std::string& path, std::string& wrong) {
  std::vector<mpq_class> angles(3);
  const bool good = value.is_array() && value.items().size() == 4 && value.items().front().is_string();
  if (!good) report(path, R"(an order and three angles, ["intrinsic zyx", 10, 20, 30])", found(value));
  for (std::size_t i = 0; good && i < 3; ++i)
    angles[i] = number(value.items()[i + 1], path + "[" + std::to_string(i + 1) + "]");
  return good ? euler_turns(value.items().front().text(), angles, wrong) : std::vector<mpq_class>(6);
}

GivenPose Reader::pose_of_words(const JsonValue& value, const std::string& path, std::string& wrong) {
  PoseWords words;
  std::vector<std::string> keys;
  for (const auto& [key, numbers_of_it] : value.fields()) {
    const std::optional<PoseWord> word = pose_word(key);
    keys.emplace_back(key);
    if (!word || is_of_plane(*word) || numbers_of_it->is_null()) continue;
    const std::string place = path + "." + std::string(key);
    std::vector<mpq_class> read = *word == PoseWord::euler ? euler(*numbers_of_it, place, wrong)
                                                           : numbers(*numbers_of_it, numbers_of(*word), place);
    if (!words.emplace(*word, std::move(read)).second)
      wrong = "expected one " + std::string(name(*word)) + ", found two";
  }
  if (const std::string sentence = misspelt_in_pose(keys); !sentence.empty())
    notes.push_back({CaseNote::field, path + ": " + sentence});
  if (words.empty()) report(path, expected_pose, found(value));
  const JsonValue* const unit_given = value.find("unit");
  const bool of_angles = words.contains(PoseWord::rpy) || words.contains(PoseWord::euler);
  const std::string unit = !of_angles ? R"("deg")" : unit_given ? unit_given->written().text() : "null";
  if (unit != R"("deg")" && unit != R"("rad")")
    report(path + ".unit", words.contains(PoseWord::rpy) ? R"("deg" or "rad", of rpy)" : R"("deg" or "rad", of euler)",
           kernels::printable(unit, kernels::readable));
  return fault.empty() && wrong.empty()
             ? pose_of(words, unit == R"("deg")" ? AngleUnit::degrees : AngleUnit::radians, wrong)
             : GivenPose{};
}

ShapeFields Reader::fields(const JsonValue& json, const NamedShape& named, const std::string& path, NamedBody& words) {
  const ShapeName& shape = *named.shape;
  ShapeFields result;
  if (dimension == 2) result.axis = Axis::x;
  const auto require = [&](std::string_view name) {
    const JsonValue* const there = json.find(name);
    if (!there) report(path, "a field '" + std::string(name) + "'", "none");
    return there;
  };
  for (const auto& [key, value] : json.fields()) {
    if (!is_field_of_shapes(key) || value->is_null()) continue;
    const std::string place = path + "." + std::string(key);
    if (!has_field(shape, key)) report(place, "no such field of a " + std::string(shape.name), "one");
    else if (const NumberField* const field = number_field(shape, key))
      result.numbers[std::string(key)] = numbers(*value, field->count, place);
  }
  for (const NumberField& field : shape.numbers)
    if (!result.numbers.contains(field.name)) report(path, "a field '" + std::string(field.name) + "'", "none");
  if (named.rounded && !result.numbers.contains("margin")) report(path, "a field 'margin'", "none");
  if (shape.part == ShapePart::axis)
    if (const JsonValue* const value = json.find("axis")) result.axis = axis(*value, path + ".axis");
  if (shape.part == ShapePart::vertices)
    if (const JsonValue* const value = require("vertices")) result.vertices = points(*value, path + ".vertices");
  if (shape.part != ShapePart::terms) return result;
  const JsonValue* const terms = require("terms");
  if (terms && !terms->is_array()) report(path + ".terms", "an array of shapes", found(*terms));
  for (std::size_t i = 0; terms && terms->is_array() && i < terms->items().size(); ++i) {
    const std::string place = path + ".terms[" + std::to_string(i) + "]";
    const JsonValue& json_of_term = terms->items()[i];
    NamedBody& of_term = words.terms.emplace_back();
    Shape term = unplaced(json_of_term, place, of_term);
    if (!fault.empty()) break;
    if (json_of_term.find("pose_rounding")) report(place + ".pose_rounding", "no such field of a term", "one");
    result.terms.push_back(placed_shape(std::move(term), json_of_term, place, of_term));
  }
  return result;
}

Shape Reader::unplaced(const JsonValue& json, const std::string& path, NamedBody& words) {
  if (!json.is_object()) {
    report(path, "a shape", found(json));
    return {};
  }
  NamedShape named = named_shape(dimension == 2 ? "polygon" : "hull", dimension);
  if (const JsonValue* const name = json.find("shape")) {
    named = name->is_string() ? named_shape(name->text(), dimension) : NamedShape{};
    if (!named.shape) {
      report(path + ".shape", list_of_shapes(dimension) + ", or one of them after 'rounded_'", found(*name));
      return {};
    }
  }
  words.shape = (named.rounded ? "rounded_" : "") + std::string(named.shape->name);
  words.fields = fields(json, named, path, words);
  if (!fault.empty()) return {};
  try {
    Shape shape = made_shape(*named.shape, words.fields);
    words.fields.terms.clear();  // they have words
    return shape;
  } catch (const std::invalid_argument& error) {
    refuse(path + ": " + error.what());
    return {};
  }
}

// The shape where its field "pose" puts it, if it has one.
Shape Reader::placed_shape(Shape shape, const JsonValue& json, const std::string& path, NamedBody& words) {
  const JsonValue* const there = given(json, "pose");
  if (!fault.empty() || !there) return shape;
  const std::optional<GivenPose> placing = pose(*there, path + ".pose");
  if (!fault.empty()) return shape;
  if (const std::string note = pose_note(*placing, shape.radius > 0); !note.empty())
    notes.push_back({CaseNote::pose, path + ".pose: " + note});
  try {
    words.turn = placing->turn;
    words.place = placing->place;
    words.matrix = placing->matrix;
    return moved(shape, exact_pose(*placing));
  } catch (const std::invalid_argument& error) {
    refuse(path + ".pose: " + error.what());
    return shape;
  }
}

void Reader::round(Shape& shape, const std::string& path) {
  if (!points_of(shape)) {
    refuse(path +
           ".pose_rounding: expected a body of points, found one with discs, balls, terms or a plane, which are not "
           "rounded");
    return;
  }
  for (Atom& atom : std::get<std::vector<Term>>(shape.core).front().atoms)
    if (!round_to_binary64(atom.center))
      refuse(path + ": expected points within binary64 once placed, found a larger one");
}

// A piece, where its own pose puts it.
Body Reader::piece(const JsonValue& json, const std::string& path) {
  if (dimension == 2 && json.is_array()) return {points(json, path)};
  NamedBody words;
  const Shape shape = placed_shape(unplaced(json, path, words), json, path, words);
  if (!fault.empty()) return {};
  if (json.find("pose_rounding")) report(path + ".pose_rounding", "no such field of a piece", "one");
  std::optional<std::vector<Point>> points = points_of(shape);
  if (!points)
    refuse(path + ": expected a " + (dimension == 2 ? "polygon or a box" : "hull, a box or a triangle") +
           ", found another shape");
  else if (shape.radius != 0)
    refuse(path + ": expected a piece without a radius: to add the radii of unions to a depth would be wrong");
  Body body{std::move(points).value_or(std::vector<Point>())};
  if (const JsonValue* const faces = json.find("faces"); faces && fault.empty())
    refuse(read_faces(*faces, path + ".faces", body));
  return body;
}

// Moves the parts, each of which stands where its own pose puts it, to where the body's does.
void Reader::place_parts(std::vector<Body>& parts, const JsonValue& json, const std::string& path, bool rounded) {
  rounded = is_rounded(json, path) || rounded;
  std::optional<GivenPose> placing;
  if (const JsonValue* const there = given(json, "pose"); there && fault.empty())
    placing = pose(*there, path + ".pose");
  for (std::size_t i = 0; fault.empty() && i < parts.size(); ++i)
    for (Point& p : parts[i].points.edit()) {
      if (placing) p = placed(p, exact_pose(*placing));
      if (rounded && !round_to_binary64(p))
        report(path + ".pieces[" + std::to_string(i) + "]", "points within binary64 once placed", "a larger one");
    }
  if (!fault.empty() || !placing) return;
  if (const std::string note = pose_note(*placing, false); !note.empty())
    notes.push_back({CaseNote::pose, path + ".pose: " + note});
}

Body Reader::union_of(const JsonValue& json, const std::string& path, bool rounded) {
  for (const auto& [key, value] : json.fields())
    if (is_field_of_shapes(key) && key != "pieces" && !value->is_null())
      report(path + "." + std::string(key), "no such field beside 'pieces'", "one");
  const JsonValue& pieces = *json.find("pieces");
  if (!pieces.is_array() || pieces.items().empty())
    report(path + ".pieces", "an array of convex pieces", found(pieces));
  std::vector<Body> read;
  for (std::size_t i = 0; fault.empty() && i < pieces.items().size(); ++i)
    read.push_back(piece(pieces.items()[i], path + ".pieces[" + std::to_string(i) + "]"));
  place_parts(read, json, path, rounded);
  return fault.empty() ? files::union_of(read) : Body();
}

// It is cut where it stands in the end.
Body Reader::solid_of(const JsonValue& json, const std::string& path, bool rounded) {
  for (const auto& [key, value] : json.fields())
    if (is_field_of_shapes(key) && key != "solid" && !value->is_null())
      report(path + "." + std::string(key), "no such field beside 'solid'", "one");
  std::vector<Body> mesh;
  if (fault.empty()) mesh.push_back(piece(*json.find("solid"), path + ".solid"));
  place_parts(mesh, json, path, rounded);
  if (!fault.empty()) return {};
  try {
    return solid_body(mesh.front());
  } catch (const std::invalid_argument& error) {
    refuse(path + ".solid: " + error.what());
    return {};
  }
}

bool Reader::is_rounded(const JsonValue& json, const std::string& path) {
  const JsonValue* const rounding = given(json, "pose_rounding");
  if (rounding && (!rounding->is_string() || rounding->text() != "binary64"))
    report(path + ".pose_rounding", "\"binary64\"", found(*rounding));
  return rounding != nullptr;
}

Body Reader::body(const JsonValue& json, const std::string& path, bool rounded) {
  if (given(json, "pieces")) return union_of(json, path, rounded);
  if (dimension == 3 && given(json, "solid")) return solid_of(json, path, rounded);
  NamedBody words;
  Shape shape = unplaced(json, path, words);
  shape = placed_shape(std::move(shape), json, path, words);
  rounded = is_rounded(json, path) || rounded;
  if (!fault.empty()) return {};
  if (rounded) round(shape, path);
  if (!fault.empty()) return {};
  if (rounded) {  // its points have other numbers now than those that were read
    words = named_hull(*points_of(shape));
    words.fields.numbers["margin"] = {shape.radius};
  }
  Body body = body_of(std::move(shape));
  if (dimension == 2 && !body.shape) body.points = points_as_given(std::move(body.points.edit()));
  const bool named = json.find("shape") && !rounded;
  if (dimension == 3 && (named || body.shape)) body.words = std::make_shared<const NamedBody>(std::move(words));
  return body;
}

}  // namespace

ShapesOfCase read_shapes(const JsonValue& document, bool a, bool b, bool rounded, unsigned dimension) {
  ShapesOfCase result;
  if (const std::string repeated = repeated_field(document); !repeated.empty()) {
    result.fault = "expected one field '" + repeated + "' in an object, found a second one";
    return result;
  }
  Reader reader;
  reader.dimension = dimension;
  if (a) (result.a = reader.body(*document.find("a"), "a", rounded))->dimension = dimension;
  if (b) (result.b = reader.body(*document.find("b"), "b", rounded))->dimension = dimension;
  result.fault = std::move(reader.fault);
  result.notes = std::move(reader.notes);
  return result;
}

std::string read_faces(const JsonValue& faces, const std::string& path, Body& body) {
  if (faces.is_null()) return "";
  if (!faces.is_array()) return path + ": expected an array of faces, found " + shown(faces);
  MeshFaces read;
  for (std::size_t i = 0; i < faces.items().size(); ++i) {
    const std::string place = path + "[" + std::to_string(i) + "]";
    const JsonValue& face = faces.items()[i];
    if (!face.is_array()) return place + ": expected an array of vertex indices, found " + shown(face);
    for (const JsonValue& index : face.items()) {
      if (!index.is_natural() || index.number() >= static_cast<double>(body.points.size()))
        return place + ": expected vertex indices below " + std::to_string(body.points.size()) + ", found " +
               shown(index);
      read.corners.push_back(static_cast<std::uint32_t>(index.number()));
    }
    read.ends.push_back(static_cast<std::uint32_t>(read.corners.size()));
  }
  body.faces = faces_of(std::move(read));
  return "";
}

RigidMotion motion_between(const std::optional<GivenPose>& from, const std::optional<GivenPose>& to,
                           std::string& fault) {
  if ((from && from->matrix) || (to && to->matrix))
    fault = "expected a quaternion or angles, and a translation, found a matrix: it tells no length of a quaternion";
  if ((from && from->plane) || (to && to->plane)) fault = "expected a pose in space, found one in the plane";
  const GivenPose start = from ? *from : to.value_or(GivenPose()), end = to ? *to : start;
  return shorter_way({start.turn, end.turn, start.place, end.place});
}

MotionsOfCase read_motions(std::string_view text, std::string& fault) {
  const text::JsonRead read = text::read_json(text);
  const JsonValue& document = read.value;
  MotionsOfCase motions;
  std::size_t count = 0;
  for (std::size_t i = 0; i < document.items().size(); ++i) count += document.key(i) == "motion";
  const JsonValue* const motion = given(document, "motion");
  if (!motion || count > 1 || !motion->is_object()) {
    fault = count > 1 ? "expected one field 'motion', found two"
                      : "motion: expected an object with 'a' or 'b', found " + (motion ? found(*motion) : "none");
    return motions;
  }
  const auto refuse_repeated = [&](const JsonValue& object, const std::string& path) {
    if (fault.empty() && object.is_object() && object.fields().size() < object.items().size())
      fault = path + ": expected each field once, found one twice";
  };
  refuse_repeated(*motion, "motion");
  const JsonValue *const of_a = given(*motion, "a"), *const of_b = given(*motion, "b");
  if (fault.empty() && !of_a && !of_b) fault = "motion: expected a field 'a' or 'b', found none";
  Reader reader;
  for (const auto& [ends, result] : {std::pair(of_a, &motions.a), std::pair(of_b, &motions.b)}) {
    const std::string path = ends == of_a ? "motion.a" : "motion.b";
    if (!ends || !fault.empty()) continue;
    refuse_repeated(*ends, path);
    const JsonValue *const from = given(*ends, "from"), *const to = given(*ends, "to");
    if (fault.empty() && (!from || !to)) fault = path + (from ? ".to" : ".from") + ": expected a pose, found none";
    if (!fault.empty()) continue;
    const std::optional<GivenPose> first = reader.pose(*from, path + ".from"), last = reader.pose(*to, path + ".to");
    if ((fault = reader.fault).empty()) *result = motion_between(first, last, fault);
    if (!fault.empty() && !fault.starts_with(path)) fault = path + ": " + fault;
  }
  return motions;
}

std::string read_motion(const JsonValue& twist, Motion& motion) {
  Reader reader;
  if (twist.fields().size() < twist.items().size()) return "twist: expected each field once, found one twice";
  const JsonValue *const of_a = given(twist, "a"), *const of_b = given(twist, "b");
  if (!of_a && !of_b) return "twist: expected a field 'a' or 'b', found none";
  if (of_a) motion.of_a = reader.twist(*of_a, "twist.a");
  if (of_b) motion.of_b = reader.twist(*of_b, "twist.b");
  return reader.fault;
}

}  // namespace fathom::files
