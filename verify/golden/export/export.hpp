// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a release of polytopes, and which of its records are wanted.
// Output  one file with these, for the tests of other projects. The same release and request give the same bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/monitor.hpp"
#include "verify/golden/export/formats.hpp"

namespace fathom::golden {

/// Which cases, and how they are written.
struct ExportRequest {
  ExportFormat format = ExportFormat::json;
  std::vector<std::string> excluded;   ///< words of `excludes`
  std::size_t most_points = SIZE_MAX;  ///< of each body
  std::size_t count = SIZE_MAX;        ///< so many at most, spread evenly over the families
};

/// Returns the words of which the request excludes some: the flags, their first words ("flat"), and every status.
std::vector<std::string> excludable();

/// Returns whether the word is the status, one of the flags, or the first word of one: "flat" is that of flat_a.
bool excludes(std::string_view word, const ExportCase& entry);

/// The command line that makes the export again, without the folder.
std::string command_of(const ExportRequest& request);

struct Exported {
  std::string text;
  std::size_t chosen = 0, fitting = 0, records = 0;          ///< of the records in the release
  std::size_t not_doubles = 0, excluded = 0, too_large = 0;  ///< why others do not fit; each is counted once, in this order
};

/// Reads the folder twice, so that memory is bounded by the export. Throws FolderError if the release is not one of polytopes or no record
/// fits, FileError, also for what is no record or not what the release's pages say, Interrupted.
Exported export_release(const std::filesystem::path& folder, const ExportRequest& request, Monitor* monitor = nullptr);

}  // namespace fathom::golden
