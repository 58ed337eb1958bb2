// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a body of a case, or of a piece. For cases.cpp and shape_fields.cpp.
#pragma once

#include <string>
#include <string_view>

#include "fathom/files.hpp"

namespace fathom::files {

/// Reads the field "faces" of body "a" or "b" into `body`, whose points were read: arrays of indices of points. `text` is the JSON object
/// of a case. Returns a sentence on what went wrong, or "".
std::string read_faces(std::string_view text, const char* name, Body& body);

/// The same of the text of the field itself; `path` names it.
std::string read_array_of_faces(std::string_view text, const std::string& path, Body& body);

}  // namespace fathom::files
