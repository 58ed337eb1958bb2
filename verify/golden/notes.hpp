// SPDX-License-Identifier: GPL-3.0-or-later
// The page that goes with every release: NOTES.md of this folder, part of the program.
#pragma once

#include <string_view>

namespace fathom::golden {

/// Fields and flags explained, and the policy on versions. Markdown, ends with a line feed.
std::string_view notes();

/// schemas/golden.schema.json: of one record.
std::string_view record_schema();

}  // namespace fathom::golden
