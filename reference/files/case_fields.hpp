// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON of one case, taken apart but not yet placed. Not a door: the door is cases.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/files/pose.hpp"

namespace fathom {

/// One of the two bodies as it is written.
struct BodyFields {
  std::vector<Point> vertices;
  std::optional<Pose> pose;
  bool rounded = false;  ///< "pose_rounding": "binary64"
};

/// What a case says, or the first thing wrong with it.
struct CaseFields {
  std::optional<std::string> id;  ///< also if something is wrong, when it could be read
  BodyFields a, b;
  bool rounded = false;        ///< of both bodies
  std::string fault;           ///< empty: all is well; else what was expected where, and what was found
  std::size_t fault_line = 0;  ///< of a syntax error, lines of `text` before it
};

/// Reads the JSON text of one case. Never throws on bad input. Malformed is also whatever follows the object, other than white space, and
/// nesting of more than 64 objects and arrays, in fields that are passed over too.
CaseFields read_case_fields(std::string_view text);

}  // namespace fathom
