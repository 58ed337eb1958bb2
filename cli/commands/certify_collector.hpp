// SPDX-License-Identifier: GPL-3.0-or-later
// Collects what a run of `fathom certify` finds: writes journal, standard output and progress, and keeps what the final reports need.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/io/progress.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/report/summary.hpp"

namespace fathom::cli {

/// A failing case as the subject saw it.
struct FailedCase {
  std::size_t outcome;  ///< index into outcomes()
  Case seen;
  Case original;  ///< of a variant, the case that it is a variant of
};

class Collector {
 public:
  /// Starts the report, or goes on with an existing one. `expected`: the number of cases, if it is known.
  Collector(const Request& request, const harness::SubjectInfo& info, std::optional<std::size_t> expected);

  /// Returns the outcome that an earlier run left in the report, or nullptr. Any thread.
  [[nodiscard]] const harness::Outcome* known(const std::string& id, const std::string& variant, const std::string& digest) const;

  /// Takes one outcome, and writes it to the report first of all. `known`: it is in the report already.
  void take(const Case& original, const Case& seen, const harness::Outcome& outcome, bool known);
  /// The same for a failure that no case caused; `known`: it is in the report already.
  void take(const harness::Unattributed& unattributed, bool known = false);
  /// Prints a sentence for the user, above the progress bar. Prints the first few of a kind, and counts the others.
  void tell(const std::string& kind, const std::string& sentence);
  /// Prints how many sentences were only counted; removes the bar.
  void close();
  /// Writes the last line of the report and of --json.
  void complete();

  [[nodiscard]] const std::vector<harness::Outcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] const std::vector<FailedCase>& failed() const { return failed_; }
  [[nodiscard]] const harness::Summary& summary() const { return summary_; }
  [[nodiscard]] Progress& progress() { return progress_; }

 private:
  void show_progress();

  const Request& request_;
  std::optional<std::size_t> expected_;
  std::optional<harness::Journal> journal_;
  std::map<std::tuple<std::string, std::string, std::string>, harness::Outcome> known_;
  std::vector<harness::Outcome> outcomes_;
  std::vector<FailedCase> failed_;
  harness::Summary summary_;
  std::map<std::string, std::size_t> told_;
  std::size_t cases_ = 0, cases_before_ = 0;  ///< of these: known from an earlier run
  double worst_ = 0;                          ///< relative error
  Progress progress_;
};

}  // namespace fathom::cli
