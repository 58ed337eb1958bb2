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

/// A case of both reports that is answered differently.
struct Change {
  std::string id, variant;
  Verdict old_verdict, new_verdict;
  /// The claimed depth less the true one in parts of R, the largest coordinate; nullopt without a
  /// claimed depth.
  std::optional<double> old_error, new_error;
  /// the two subjects saw different points: another precision, or the case itself was changed
  bool other_points = false;

  /// Returns by how much one error is larger than the other, signs apart; an error that is missing,
  /// or no number, counts as 0.
  [[nodiscard]] double error_change() const;
};

/// A field of the headers that differs; empty where it is missing.
struct HeaderDifference {
  std::string field, old_value, new_value;
};

struct ReportDiff {
  std::vector<HeaderDifference> header;
  TallyRow old_row, new_row;  ///< of the cases of both
  std::size_t only_old = 0, only_new = 0, other_points = 0;
  // Each by error_change(), largest first, then by id:
  std::vector<Change> newly_failing;  ///< fails now, and did not: it passed, or was declined
  std::vector<Change> newly_passing;  ///< passes now, and did not
  std::vector<Change> otherwise;      ///< has another verdict for all that
  std::vector<Change> errors;         ///< has the same verdict and another error; of these `most_errors`
};

ReportDiff diff(const ReportFile& before, const ReportFile& after);

/// The cases of the three lists by name and by how many: "2 newly failing, 0 newly passing, 1 with
/// another verdict; 63 in both".
std::string totals_text(const ReportDiff& diff);

/// Lines for people, each list up to `most` long. They are pure ASCII, whatever ids hold.
std::vector<std::string> diff_text(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                                   std::size_t most = 20);

/// One line of schema fathom/diff/1, without the newline.
std::string diff_json(const ReportFile& before, const ReportFile& after, const ReportDiff& diff);

/// A page that needs nothing else.
std::string diff_page(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                      const std::string& version, const std::string& command);

}  // namespace fathom::harness
