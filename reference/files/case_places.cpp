// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/case_places.hpp"

namespace fathom {

std::string expected_at(Place place) {
  switch (place) {
    case Place::whole: return "a case (a JSON object)";
    case Place::schema: return "\"fathom/case/1\"";
    case Place::id: return "text or a number";
    case Place::rounding:
    case Place::body_rounding: return "\"binary64\"";
    case Place::body: return "an object with 'vertices'";
    case Place::vertices: return "an array of points";
    case Place::vertex: return "three coordinates";
    case Place::pose: return "three rows of four numbers";
    case Place::pose_row: return "four numbers";
    default: return "a number, or an exact number in quotes";
  }
}

Place field_of_case(std::string_view key) {
  if (key == "schema") return Place::schema;
  if (key == "id") return Place::id;
  if (key == "pose_rounding") return Place::rounding;
  return key == "a" || key == "b" ? Place::body : Place::other;
}

Place field_of_body(std::string_view key) {
  if (key == "vertices") return Place::vertices;
  if (key == "pose") return Place::pose;
  return key == "pose_rounding" ? Place::body_rounding : Place::other;
}

bool may_be_null(Place place) {
  return place == Place::other || place == Place::id || place == Place::pose || place == Place::rounding || place == Place::body_rounding;
}

}  // namespace fathom
