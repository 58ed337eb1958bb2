// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of tests/data/real_cases.jsonl, compiled into the program.
#pragma once

#include <span>
#include <string_view>

#include "fathom/files.hpp"

namespace fathom::golden {

/// Pairs that made libraries fail, from their issue trackers and test suites, as binary64. Ids
/// without their common prefix "real::".
std::span<const Case> real_cases();

/// Returns nullptr if none has that name.
const Case* find_real_case(std::string_view name);

/// The text of the file.
std::string_view real_cases_text();

}  // namespace fathom::golden
