// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/case_names.hpp"

#include <algorithm>
#include <array>

#include "kernels/messages.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {
namespace {

using Names = std::vector<std::string_view>;

constexpr std::array<std::string_view, 8> of_cases = {"schema", "id", "a", "b", "pose_rounding", "flags", "source", "comment"};
constexpr std::array<std::string_view, 7> of_bodies = {"vertices", "faces", "pose", "shape", "margin", "pose_rounding", "pieces"};
constexpr std::array<std::string_view, 7> of_poses = {"translation", "quaternion", "xyz", "quat", "xyzw", "rpy", "unit"};

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

void note(const text::JsonValue& object, const std::string& path, std::span<const std::string_view> known, std::vector<CaseNote>& notes) {
  std::vector<std::string> there;
  for (const auto& [key, value] : object.fields()) there.emplace_back(key);
  const std::string sentence = kernels::near_misses(there, known);
  if (!sentence.empty()) notes.push_back({CaseNote::field, (path.empty() ? "" : path + ": ") + sentence});
}

}  // namespace

std::string expected_at(CasePlace place) {
  switch (place) {
    case CasePlace::whole: return "a case (a JSON object)";
    case CasePlace::schema: return '"' + std::string(case_schema) + '"';
    case CasePlace::id: return "text or a number";
    case CasePlace::rounding:
    case CasePlace::body_rounding: return "\"binary64\"";
    case CasePlace::body: return "an object with 'vertices', 'shape' or 'pieces'";
    case CasePlace::vertices: return "an array of points";
    case CasePlace::vertex: return "three coordinates";
    case CasePlace::faces: return "an array of faces";
    case CasePlace::pose: return "three rows of four numbers";
    case CasePlace::pose_row: return "four numbers";
    default: return "a number, or an exact number in quotes";
  }
}

CasePlace field_of_case(std::string_view key) {
  if (key == "schema") return CasePlace::schema;
  if (key == "id") return CasePlace::id;
  if (key == "pose_rounding") return CasePlace::rounding;
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
  constexpr std::array<std::string_view, 6> others = {"shape", "axis", "vertices", "faces", "terms", "pieces"};
  return std::ranges::find(others, key) != others.end() || number_field(key) != nullptr;
}

bool has_field(const ShapeName& shape, std::string_view key) {
  if (key == "axis") return shape.part == ShapePart::axis;
  if (key == "vertices") return shape.part == ShapePart::vertices;
  if (key == "faces") return shape.name == "hull";
  if (key == "terms") return shape.part == ShapePart::terms;
  return key == "shape" || has_number(shape, key);
}

bool may_be_null(CasePlace place) {
  return place == CasePlace::other || place == CasePlace::shape || place == CasePlace::id || place == CasePlace::pose ||
         place == CasePlace::faces || place == CasePlace::rounding || place == CasePlace::body_rounding;
}

bool looks_misspelt(std::string_view key, bool of_body) { return of_body ? is_near_one(key, of_any_body()) : is_near_one(key, of_cases); }

std::string misspelt_in_pose(std::span<const std::string> keys) { return kernels::near_misses(keys, of_poses); }

std::vector<CaseNote> misspelt_fields(const text::JsonValue& document) {
  std::vector<CaseNote> notes;
  note(document, "", of_cases, notes);
  for (const char* name : {"a", "b"}) {
    const text::JsonValue* const body = document.find(name);
    if (!body || !body->is_object()) continue;
    Names known(of_bodies.begin(), of_bodies.end());
    const text::JsonValue* const shape = body->find("shape");
    if (shape && shape->is_string())
      if (const ShapeName* const named = named_shape(shape->text()).shape) add_fields(*named, known);
    note(*body, name, known, notes);
  }
  return notes;
}

}  // namespace fathom::files
