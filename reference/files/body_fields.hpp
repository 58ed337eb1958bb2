// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of a case that are more than vertices and a matrix: shapes, margins, quaternions, pieces; and the faces of meshes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::files {

/// Those bodies of a case that were asked for, or the first fault.
struct ShapesOfCase {
  std::optional<Body> a, b;
  std::string fault;  ///< "a.radius: expected a number, found null"; empty if all is good
  std::vector<CaseNote> notes;
};

/// Reads body a, or b, or both, of the object of a case. `rounded`: the case says that points are rounded once to the nearest binary64,
/// which bodies with discs, balls, terms or planes refuse.
ShapesOfCase read_shapes(const text::JsonValue& document, bool a, bool b, bool rounded);

/// Reads faces, arrays of indices of points, into `body`, whose points were read. `path` names the field. Returns a sentence on what went
/// wrong, or "".
std::string read_faces(const text::JsonValue& faces, const std::string& path, Body& body);

}  // namespace fathom::files
