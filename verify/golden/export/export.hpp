// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a release of polytopes, or a file of one's own cases, and which of them are wanted.
// Output  one file with these, for the tests of other projects, and their certificates. The same input and request give the same bytes.
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
  std::vector<std::string> excluded;   ///< words of `has_word`: leave out what has one
  std::vector<std::string> only;       ///< likewise: take only what has one; empty: all, here and below
  std::vector<std::string> families;   ///< names of groups, or patterns as of a shell: touching_*
  std::vector<std::string> contacts;   ///< names of kinds of contact: take only what has an optimum of one
  std::string exact_in;                ///< "binary32": take only points that this format holds
  bool certificates = false;           ///< whether the certificates are wanted too
  std::size_t most_points = SIZE_MAX;  ///< of each body
  std::size_t count = SIZE_MAX;        ///< so many at most, spread evenly over the families
};

/// Returns the words that say which cases are wanted: the flags, their first words ("flat"), and every status.
std::vector<std::string> words_of_cases();

/// Returns whether the word is the status, one of the flags, or the first word of one: "flat" is that of flat_a.
bool has_word(std::string_view word, const ExportCase& entry);

/// The names of the groups of a release: its families, "catalogue" and "real".
std::vector<std::string> groups_of_releases();

/// The command line that makes the export again, without the folder or file.
std::string command_of(const ExportRequest& request);

struct Exported {
  std::string text, certificates;                            ///< the certificates of the chosen ones, one after another
  std::size_t chosen = 0, fitting = 0, records = 0;          ///< of the records in the release, or of the cases in the file
  std::size_t not_doubles = 0, excluded = 0, too_large = 0;  ///< why others do not fit; each is counted once, in this order
};

/// Reads the folder twice, so that memory is bounded by the export. Throws FolderError if the release is not one of polytopes or no record
/// fits, FileError, also for what is no record or not what the release's pages say, Interrupted.
Exported export_release(const std::filesystem::path& folder, const ExportRequest& request, Monitor* monitor = nullptr);

/// Answers the cases of a file, which are polytopes, each once, and proves the answers; `path` may be "-". Throws InputError if a case
/// cannot be read, has a name that another one has or that is not of letters, digits and . _ - alone, or is not about polytopes;
/// FolderError if none fits; Interrupted.
Exported export_own_cases(const std::string& path, const ExportRequest& request, Monitor* monitor = nullptr);

}  // namespace fathom::golden
