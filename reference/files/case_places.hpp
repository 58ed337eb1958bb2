// SPDX-License-Identifier: GPL-3.0-or-later
// The places in the JSON of a case where a value may stand, and what belongs there. Not a door.
#pragma once

#include <string>
#include <string_view>

namespace fathom {

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
  other  ///< nothing of ours: passed over
};

/// What belongs there, for messages.
std::string expected_at(CasePlace place);

/// What stands under `key` in the object of a case, or of a body.
CasePlace field_of_case(std::string_view key);
CasePlace field_of_body(std::string_view key);

/// Whether null there means the same as no field.
bool may_be_null(CasePlace place);

}  // namespace fathom
