// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of a case that are more than vertices and a matrix: shapes, margins, quaternions. For cases.cpp alone.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"

namespace fathom::files {

/// Those bodies of a case that were asked for, or the first fault.
struct ShapesOfCase {
  std::optional<Body> a, b;
  std::string fault;  ///< "a.radius: expected a number, found null"; empty if all is good
  std::vector<CaseNote> notes;
};

/// Reads body a, or b, or both. `text` is the JSON object of a case. `rounded`: the case says that points are rounded once to the nearest
/// binary64, which bodies with discs, balls, terms or planes refuse.
ShapesOfCase read_shapes(std::string_view text, bool a, bool b, bool rounded);

}  // namespace fathom::files
