// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/case_places.hpp"

#include <algorithm>
#include <array>

#include "reference/files/shape_names.hpp"

namespace fathom::files {

std::string expected_at(CasePlace place) {
  switch (place) {
    case CasePlace::whole: return "a case (a JSON object)";
    case CasePlace::schema: return "\"fathom/case/1\"";
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

}  // namespace fathom::files
