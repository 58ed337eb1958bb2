// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a case that are not read, but look like one that is: "poze".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"

namespace fathom::files {

/// Returns whether an unknown field of a case, or of a body, has a name near that of a known one. Quick: most names differ in length.
bool looks_misspelt(std::string_view key, bool of_body);

/// A sentence on the unknown fields of a pose, of all whose keys are given; or "".
std::string misspelt_in_pose(std::span<const std::string> keys);

/// Returns a note on the case, and on each body, with such fields, if the field that may be meant is missing. `text` is JSON;
/// of other texts there is nothing to say.
std::vector<CaseNote> misspelt_fields(std::string_view text);

}  // namespace fathom::files
