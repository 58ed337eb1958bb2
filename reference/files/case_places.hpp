// SPDX-License-Identifier: GPL-3.0-or-later
// The places in the JSON of a case where a value may stand, and what belongs there. For case_fields.cpp alone.
#pragma once

#include <string>
#include <string_view>

namespace fathom::files {

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
  shape,  ///< a shape's name, or a margin: of a body that shape_fields.cpp reads
  other   ///< no field of ours: skipped
};

/// Returns what belongs there, for messages.
std::string expected_at(CasePlace place);

/// Returns the place of `key` in the object of a case, or of a body.
CasePlace field_of_case(std::string_view key);
CasePlace field_of_body(std::string_view key);

/// Returns whether null there means the same as no field.
bool may_be_null(CasePlace place);

}  // namespace fathom::files
