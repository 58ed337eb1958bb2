// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a good case, read in a fraction of the time. For cases.cpp alone.
#pragma once

#include <optional>
#include <string_view>

#include "reference/files/case_fields.hpp"

namespace fathom::files {

/// Returns what read_case_fields, its naive twin, returns for the text; or nullopt, and read_case_fields has to read it. It does so for
/// every text with a fault, and for a few good ones. Call it while rounding is to nearest.
std::optional<CaseFields> quick_case_fields(std::string_view text);

}  // namespace fathom::files
