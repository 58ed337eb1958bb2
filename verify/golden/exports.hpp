// SPDX-License-Identifier: GPL-3.0-or-later
// Records in other forms, for programs that read neither JSON nor rationals: CSV and a C++ include file, both with hex floats.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fathom::golden {

/// The names of the columns, with a line feed. NOTES.md explains them.
std::string csv_header();

/// The row of a record, with a line feed; nothing when its points are not all binary64. Throws std::invalid_argument when `line` is no
/// record.
std::optional<std::string> csv_row(std::string_view line);

/// The part of the C++ include file before the first entry, and after the last one.
std::string include_head();
std::string include_tail();

/// The entry of a record, with a line feed; nothing when its points are not all binary64. Throws as csv_row does.
std::optional<std::string> include_entry(std::string_view line);

}  // namespace fathom::golden
