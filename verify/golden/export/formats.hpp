// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of exports: one file that needs nothing beside it, with decimals that every language reads back to the same doubles.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/golden/export/export_case.hpp"

namespace fathom::golden {

enum class ExportFormat { c, csv, json, rust };

inline constexpr std::array export_formats = {ExportFormat::c, ExportFormat::csv, ExportFormat::json, ExportFormat::rust};

/// "c", "csv", "json", "rust".
std::string_view name_of(ExportFormat format);
std::optional<ExportFormat> find_export_format(std::string_view name);

/// Where the cases come from.
struct ExportSource {
  std::string level, version, seed;  ///< of the release; empty of one's own cases
  std::string file;                  ///< of one's own cases, without its folder; else empty
  std::string command;               ///< that made the export: "fathom golden export --format c --count 50"
};

/// Returns the file, with its last line feed, of at least one case. C: kit/fathom_golden.h, then flat arrays. Rust: kit/fathom_golden.rs,
/// then an array. JSON: schemas/golden-export.schema.json. CSV: a line of names, then one for each case; it has no room for the source.
std::string export_text(ExportFormat format, const ExportSource& source, const std::vector<ExportCase>& cases);

/// Returns the shortest decimal that is read back as this finite double, with a point or an exponent: "0.1", "-0.0", "1e+300".
std::string decimal_text(double value);

}  // namespace fathom::golden
