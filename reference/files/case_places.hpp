// SPDX-License-Identifier: GPL-3.0-or-later
// The places in the JSON of a case where a value may stand, and what belongs there: one vocabulary for all readers of cases.
#pragma once

#include <string>
#include <string_view>

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
  faces,  ///< case_faces.cpp reads them
  shape,  ///< a shape's name, or what only some shapes have: of a body that shape_fields.cpp reads, or refuses
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

}  // namespace fathom::files
