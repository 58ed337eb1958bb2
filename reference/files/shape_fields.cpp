// SPDX-License-Identifier: GPL-3.0-or-later
// Unlike cases of vertices, which come by millions, shapes are read from a document: their objects are small, and some hold others.
#include "reference/files/shape_fields.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/printable.hpp"
#include "reference/files/case_faces.hpp"
#include "reference/files/case_places.hpp"
#include "reference/files/misspelt_fields.hpp"
#include "reference/files/named_body.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/pose_text.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

using Json = nlohmann::json;

constexpr std::size_t readable = 40;  // what a message shows of a text
constexpr const char* expected_pose =
    "three rows of four numbers, or an object with 'quaternion', or text such as \"xyz=0,0,1 rpy=0,0,90deg\"";

std::string found(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  return kernels::printable(value.dump(-1, ' ', true, Json::error_handler_t::replace), readable);
}

/// Returns whether the field means something in a body: such a field must not be repeated, since readers differ in which one they take.
bool is_ours(std::string_view key) {
  return is_field_of_shapes(key) || key == "pose" || key == "pose_rounding" || key == "unit" || pose_word(key);
}

/// Finds repeated fields, which a document does not show.
struct Repetitions {
  std::vector<std::vector<std::string>> open;  // the keys of ours in the objects that are being read
  std::string repeated;

  bool note(Json::parse_event_t event, const Json& value) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && is_ours(value.get_ref<const std::string&>())) {
      const std::string& key = value.get_ref<const std::string&>();
      if (std::ranges::find(open.back(), key) != open.back().end() && repeated.empty()) repeated = key;
      open.back().push_back(key);
    }
    return true;
  }
};

/// Reads one object, and those in it. After the first fault what is returned means nothing.
class Reader {
 public:
  std::string fault;
  std::vector<CaseNote> notes;

  Body body(const Json& json, const std::string& path, bool rounded);

 private:
  void report(const std::string& path, const std::string& expected, const std::string& instead) {
    refuse(path + ": expected " + expected + ", found " + instead);
  }
  void refuse(const std::string& sentence) {  // "" if there is nothing to refuse
    if (fault.empty()) fault = sentence;
  }

  mpq_class number(const Json& value, const std::string& path);
  std::vector<mpq_class> numbers(const Json& value, std::size_t count, const std::string& path);
  std::vector<Point> points(const Json& value, const std::string& path);
  Axis axis(const Json& value, const std::string& path);
  std::optional<GivenPose> pose(const Json& value, const std::string& path);
  GivenPose pose_of_words(const Json& value, const std::string& path, std::string& wrong);
  ShapeFields fields(const Json& json, const NamedShape& named, const std::string& path, NamedBody& words);
  Shape unplaced(const Json& json, const std::string& path, NamedBody& words);
  Shape placed_shape(Shape shape, const Json& json, const std::string& path, NamedBody& words);
  void round(Shape& shape, const std::string& path);
  Body piece(const Json& json, const std::string& path);
  Body union_of(const Json& json, const std::string& path, bool rounded);
  bool is_rounded(const Json& json, const std::string& path);
};

// A JSON number means the nearest binary64, an integer too.
mpq_class Reader::number(const Json& value, const std::string& path) {
  if (value.is_string()) {
    ParsedNumber parsed = parse_number(value.get_ref<const std::string&>(), Decimals::exact);
    if (parsed.value) return *std::move(parsed.value);
    refuse(path + ": " + parsed.error);
    return 1;
  }
  if (value.is_number_float()) return exact_value(value.get<double>());
  if (value.is_number_unsigned()) return exact_value(static_cast<double>(value.get<std::uint64_t>()));
  if (value.is_number_integer()) return exact_value(static_cast<double>(value.get<std::int64_t>()));
  report(path, "a number, or an exact number in quotes", found(value));
  return 1;
}

std::vector<mpq_class> Reader::numbers(const Json& value, std::size_t count, const std::string& path) {
  if (count == 1) return {number(value, path)};
  std::vector<mpq_class> result;
  if (!value.is_array() || value.size() != count) {
    report(path, count == 3 ? "three numbers" : "four numbers", found(value));
    result.resize(count, 1);
    return result;
  }
  for (std::size_t i = 0; i < count; ++i) result.push_back(number(value[i], path + "[" + std::to_string(i) + "]"));
  return result;
}

std::vector<Point> Reader::points(const Json& value, const std::string& path) {
  if (!value.is_array() || value.empty()) {
    report(path, "an array of points", found(value));
    return {{}};
  }
  std::vector<Point> result;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::vector<mpq_class> p = numbers(value[i], 3, path + "[" + std::to_string(i) + "]");
    result.push_back({p[0], p[1], p[2]});
  }
  return result;
}

Axis Reader::axis(const Json& value, const std::string& path) {
  for (const auto& [name, axis] : {std::pair("x", Axis::x), std::pair("y", Axis::y), std::pair("z", Axis::z)})
    if (value == name) return axis;
  report(path, R"("x", "y" or "z")", found(value));
  return Axis::z;
}

std::optional<GivenPose> Reader::pose(const Json& value, const std::string& path) {
  std::string wrong;
  GivenPose result;
  if (value.is_string()) {
    result = parse_pose(value.get_ref<const std::string&>(), Decimals::exact, wrong);
  } else if (value.is_array() && (value.size() == 3 || value.size() == 4)) {
    std::vector<std::array<mpq_class, 4>> rows(value.size());
    for (std::size_t row = 0; row < rows.size(); ++row)
      std::ranges::copy(numbers(value[row], 4, path + "[" + std::to_string(row) + "]"), rows[row].begin());
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

GivenPose Reader::pose_of_words(const Json& value, const std::string& path, std::string& wrong) {
  PoseWords words;
  std::vector<std::string> keys;
  for (const auto& [key, numbers_of_it] : value.items()) {
    const std::optional<PoseWord> word = pose_word(key);
    keys.push_back(key);
    if (!word || numbers_of_it.is_null()) continue;
    std::vector<mpq_class> read = numbers(numbers_of_it, numbers_of(*word), path + "." + key);
    if (!words.emplace(*word, std::move(read)).second) wrong = "expected one " + std::string(name(*word)) + ", found two";
  }
  if (const std::string sentence = misspelt_in_pose(keys); !sentence.empty()) notes.push_back({CaseNote::field, path + ": " + sentence});
  if (words.empty()) report(path, expected_pose, found(value));
  const std::string unit = words.contains(PoseWord::rpy) ? value.value("unit", Json()).dump() : R"("deg")";
  if (unit != R"("deg")" && unit != R"("rad")") report(path + ".unit", R"("deg" or "rad", of rpy)", kernels::printable(unit, readable));
  return fault.empty() && wrong.empty() ? pose_of(words, unit == R"("deg")" ? AngleUnit::degrees : AngleUnit::radians, wrong) : GivenPose{};
}

ShapeFields Reader::fields(const Json& json, const NamedShape& named, const std::string& path, NamedBody& words) {
  const ShapeName& shape = *named.shape;
  ShapeFields result;
  const auto require = [&](std::string_view name) {
    const bool there = json.contains(name);
    if (!there) report(path, "a field '" + std::string(name) + "'", "none");
    return there;
  };
  for (const auto& [key, value] : json.items()) {
    if (!is_field_of_shapes(key) || value.is_null()) continue;
    if (!has_field(shape, key)) report(path + "." + key, "no such field of a " + std::string(shape.name), "one");
    else if (const NumberField* const field = number_field(key)) result.numbers[key] = numbers(value, field->count, path + "." + key);
  }
  for (const NumberField& field : shape.numbers)
    if (!result.numbers.contains(field.name)) report(path, "a field '" + std::string(field.name) + "'", "none");
  if (named.rounded && !result.numbers.contains("margin")) report(path, "a field 'margin'", "none");
  if (shape.part == ShapePart::axis && json.contains("axis")) result.axis = axis(json["axis"], path + ".axis");
  if (shape.part == ShapePart::vertices && require("vertices")) result.vertices = points(json["vertices"], path + ".vertices");
  if (shape.part == ShapePart::terms && require("terms")) {
    const Json& terms = json["terms"];
    if (!terms.is_array()) report(path + ".terms", "an array of shapes", found(terms));
    else
      for (std::size_t i = 0; i < terms.size(); ++i) {
        const std::string place = path + ".terms[" + std::to_string(i) + "]";
        NamedBody& of_term = words.terms.emplace_back();
        Shape term = unplaced(terms[i], place, of_term);
        if (!fault.empty()) break;
        if (terms[i].contains("pose_rounding")) report(place + ".pose_rounding", "no such field of a term", "one");
        result.terms.push_back(placed_shape(std::move(term), terms[i], place, of_term));
      }
  }
  return result;
}

Shape Reader::unplaced(const Json& json, const std::string& path, NamedBody& words) {
  if (!json.is_object()) {
    report(path, "a shape", found(json));
    return {};
  }
  NamedShape named = named_shape("hull");
  if (json.contains("shape")) {
    const Json& name = json["shape"];
    named = name.is_string() ? named_shape(name.get_ref<const std::string&>()) : NamedShape{};
    if (!named.shape) {
      report(path + ".shape", list_of_shapes() + ", or one of them after 'rounded_'", found(name));
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
Shape Reader::placed_shape(Shape shape, const Json& json, const std::string& path, NamedBody& words) {
  if (!fault.empty() || !json.contains("pose") || json["pose"].is_null()) return shape;
  const std::optional<GivenPose> placing = pose(json["pose"], path + ".pose");
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
    refuse(path + ".pose_rounding: expected a body of points, found one with discs, balls, terms or a plane, which are not rounded");
    return;
  }
  for (Atom& atom : std::get<std::vector<Term>>(shape.core).front().atoms)
    if (!round_to_binary64(atom.center)) refuse(path + ": expected points within binary64 once placed, found a larger one");
}

// A piece, where its own pose puts it.
Body Reader::piece(const Json& json, const std::string& path) {
  NamedBody words;
  const Shape shape = placed_shape(unplaced(json, path, words), json, path, words);
  if (!fault.empty()) return {};
  if (json.contains("pose_rounding")) report(path + ".pose_rounding", "no such field of a piece", "one");
  std::optional<std::vector<Point>> points = points_of(shape);
  if (!points) refuse(path + ": expected a hull, a box or a triangle, found another shape");
  else if (shape.radius != 0) refuse(path + ": expected a piece without a radius: to add the radii of unions to a depth would be wrong");
  Body body{std::move(points).value_or(std::vector<Point>())};
  if (fault.empty() && json.contains("faces")) refuse(read_array_of_faces(json["faces"].dump(), path + ".faces", body));
  return body;
}

// Its pieces, each where its own pose puts it, all of them where the body's does.
Body Reader::union_of(const Json& json, const std::string& path, bool rounded) {
  for (const auto& [key, value] : json.items())
    if (is_field_of_shapes(key) && key != "pieces" && !value.is_null()) report(path + "." + key, "no such field beside 'pieces'", "one");
  const Json& pieces = json["pieces"];
  if (!pieces.is_array() || pieces.empty()) report(path + ".pieces", "an array of convex pieces", found(pieces));
  rounded = is_rounded(json, path) || rounded;
  std::optional<GivenPose> placing;
  if (fault.empty() && json.contains("pose") && !json["pose"].is_null()) placing = pose(json["pose"], path + ".pose");
  std::vector<Body> read;
  for (std::size_t i = 0; fault.empty() && i < pieces.size(); ++i) {
    const std::string place = path + ".pieces[" + std::to_string(i) + "]";
    read.push_back(piece(pieces[i], place));
    for (Point& p : read.back().points.edit()) {
      if (placing) p = placed(p, exact_pose(*placing));
      if (rounded && !round_to_binary64(p)) report(place, "points within binary64 once placed", "a larger one");
    }
  }
  if (!fault.empty()) return {};
  if (placing)
    if (const std::string note = pose_note(*placing, false); !note.empty()) notes.push_back({CaseNote::pose, path + ".pose: " + note});
  return files::union_of(read);
}

bool Reader::is_rounded(const Json& json, const std::string& path) {
  if (!json.contains("pose_rounding") || json["pose_rounding"].is_null()) return false;
  if (json["pose_rounding"] != "binary64") report(path + ".pose_rounding", "\"binary64\"", found(json["pose_rounding"]));
  return true;
}

Body Reader::body(const Json& json, const std::string& path, bool rounded) {
  if (json.contains("pieces") && !json["pieces"].is_null()) return union_of(json, path, rounded);
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
  const bool named = json.contains("shape") && !rounded;
  if (named || body.shape) body.words = std::make_shared<const NamedBody>(std::move(words));
  return body;
}

}  // namespace

ShapesOfCase read_shapes(std::string_view text, bool a, bool b, bool rounded) {
  Repetitions repetitions;
  const Json document = Json::parse(text, [&](int, Json::parse_event_t event, Json& value) { return repetitions.note(event, value); });
  ShapesOfCase result;
  if (!repetitions.repeated.empty()) {
    result.fault = "expected one field '" + repetitions.repeated + "' in an object, found a second one";
    return result;
  }
  Reader reader;
  if (a) result.a = reader.body(document["a"], "a", rounded);
  if (b) result.b = reader.body(document["b"], "b", rounded);
  result.fault = std::move(reader.fault);
  result.notes = std::move(reader.notes);
  return result;
}

}  // namespace fathom::files
