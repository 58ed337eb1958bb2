// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two reports, of two versions of one subject or of two subjects.
// Output  which cases changed their verdict, and whose error changed most.        [docs/certify.md]
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "verify/harness/journal.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {

/// A case of both reports whose answers differ.
struct Change {
  std::string id, variant;
  Verdict old_verdict, new_verdict;
  /// The claimed depth less the true one in parts of R, the largest coordinate; nullopt without a
  /// claimed depth.
  std::optional<double> old_error, new_error;
  /// Whether the two subjects got different points: in another precision, or because the case was
  /// changed.
  bool other_points = false;

  /// Returns by how much the magnitude of one error exceeds that of the other; a missing or
  /// non-finite error counts as 0.
  [[nodiscard]] double error_change() const;
};

/// A field whose values in the two headers differ; empty if it is missing.
struct HeaderDifference {
  std::string field, old_value, new_value;
};

struct ReportDiff {
  std::vector<HeaderDifference> header;
  TallyRow old_row, new_row;  ///< of the cases of both
  std::size_t only_old = 0, only_new = 0, other_points = 0;
  // Each by error_change(), largest first, then by id:
  std::vector<Change> newly_failing;  ///< fails in the new report, passed or was declined in the old one
  std::vector<Change> newly_passing;  ///< passes in the new report, and did not in the old one
  std::vector<Change> otherwise;      ///< has another verdict, with neither change
  std::vector<Change> errors;         ///< has the same verdict and another error; at most `most_errors`
};

ReportDiff diff(const ReportFile& before, const ReportFile& after);

/// Returns the sizes of the three lists with their names: "2 newly failing, 0 newly passing, 1 with
/// another verdict; 63 in both".
std::string totals_text(const ReportDiff& diff);

/// Returns lines of text, each list of at most `most` entries. Pure ASCII for any ids.
std::vector<std::string> diff_text(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                                   std::size_t most = 20);

/// Returns one line of schema fathom/diff/1, without the newline.
std::string diff_json(const ReportFile& before, const ReportFile& after, const ReportDiff& diff);

/// Returns a self-contained page.
std::string diff_page(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                      const std::string& version, const std::string& command);

}  // namespace fathom::harness
