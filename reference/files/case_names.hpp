// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of cases: where a value may stand, what belongs there, and names that look like one of them ("poze").
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::files {

struct ShapeName;

enum class CasePlace {
  whole,
  schema,
  id,
  rounding,
  body,
  body_rounding,
  vertices,
  vertex,
  coordinate,
  pose,
  pose_row,
  pose_entry,
  faces,  ///< body_fields.cpp reads them
  shape,  ///< a shape's name, or what only some shapes have: of a body that body_fields.cpp reads, or refuses
  other   ///< no field of ours: skipped
};

/// Returns what belongs there, for messages.
std::string expected_at(CasePlace place);

/// Returns the place of `key` in the object of a case, or of a body.
CasePlace field_of_case(std::string_view key);
CasePlace field_of_body(std::string_view key);

/// Returns whether some body has a field called `key` that tells what it is: a number field, or "shape", "axis", "vertices", "faces",
/// "terms", "pieces".
bool is_field_of_shapes(std::string_view key);

/// Returns whether this shape has that field. Each has a name and a margin; none has pieces.
bool has_field(const ShapeName& shape, std::string_view key);

/// Returns whether null there means the same as no field.
bool may_be_null(CasePlace place);

/// Returns whether an unknown field of a case, or of a body, has a name near that of a known one. Quick: most names differ in length.
bool looks_misspelt(std::string_view key, bool of_body);

/// A sentence on the unknown fields of a pose, of all whose keys are given; or "".
std::string misspelt_in_pose(std::span<const std::string> keys);

/// Returns a note on the case, and on each body, with such fields, if the field that may be meant is missing.
std::vector<CaseNote> misspelt_fields(const text::JsonValue& document);

}  // namespace fathom::files
