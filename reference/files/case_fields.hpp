// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of one case, read from JSON; poses are not applied yet. For cases.cpp alone.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "fathom/body.hpp"
#include "reference/files/pose.hpp"

namespace fathom::files {

/// One of the two bodies as it is written.
struct BodyFields {
  GivenPoints vertices;
  std::optional<Pose> pose;
  bool rounded = false;    ///< "pose_rounding": "binary64"
  bool has_faces = false;  ///< case_faces.hpp reads them
  bool is_shape = false;   ///< it has a shape's name, a margin, or a pose that is no 3 x 4 matrix: shape_fields.hpp reads it
};

/// The fields of a case, or the first error in it.
struct CaseFields {
  std::optional<std::string> id;  ///< also of a bad case, if it could be read
  BodyFields a, b;
  bool rounded = false;        ///< of both bodies
  bool misspelt = false;       ///< perhaps: see looks_misspelt
  std::string fault;           ///< empty if the case is good; else what was expected where, and what was found
  std::size_t fault_line = 0;  ///< the number of lines of `text` before a syntax error
};

/// Reads the JSON text of one case. Never throws on bad input. White space alone may follow the object, and at most 64 objects and arrays
/// may be nested, in skipped fields too.
CaseFields read_case_fields(std::string_view text);

}  // namespace fathom::files
