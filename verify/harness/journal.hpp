// SPDX-License-Identifier: GPL-3.0-or-later
// Outcomes on disk: each is written as one whole line as soon as it is known, so that an
// interrupted run can be continued.
//                                                 [verdict.schema.json; verify/PROTOCOL.md]
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::harness {

inline constexpr std::string_view report_schema = "fathom/verdict/1";

/// Returns whether a text begins as a line of this type does in a report.
bool begins_line(std::string_view text, const char* type);

/// An outcome as one line of schema fathom/verdict/1, without the newline. read_outcome is its
/// inverse, and returns nullopt for other text.
std::string outcome_line(const Outcome& outcome);
std::optional<Outcome> read_outcome(std::string_view line);
/// Returns the first field of which a report would show different values, with both values, as
/// "judgement.error: 0.5 and 0.25"; nullopt if there is none.
std::optional<std::string> difference(const Judgement& x, const Judgement& y);
std::string unattributed_line(const Unattributed& unattributed);
std::optional<Unattributed> read_unattributed(std::string_view line);

/// A request of a file of them: what the subject reads, the truth, and which claims pass.
std::string request_line(const std::string& id, const std::string& run, const Judgement& truth,
                         const judging::Accepted& accepted);

/// Returns the first line: the subject, the tolerance, the version of fathom and its command, and
/// the methods that computed every truth again.
std::string header_line(const SubjectInfo& info, const Tolerance& tolerance, const RunInfo& from = {});
/// Returns whether two headers are equal except for the command.
bool same_run(std::string_view header, std::string_view other);
/// The last line of a complete run.
struct Totals {
  std::size_t cases = 0, passed = 0, failed = 0, unsupported = 0, unattributed = 0;
  Coverage judged = {};
  const Times* times = nullptr;        ///< may be null
  const HullCount* hulls = nullptr;    ///< may be null
  const UnionCount* unions = nullptr;  ///< may be null
  const TallyRow* all = nullptr;       ///< may be null
  std::vector<Tally::Line> parts{};    ///< by name, such as "solid"
};
std::string summary_line(const Totals& totals);

/// A journal could not be written, for example because the disk is full.
struct JournalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A journal on disk. Each line is one write(2) to the end of the file, so lines stay whole even if
/// the process is killed. Throws an InputError if another process has it open.
class Journal {
 public:
  /// Starts a new journal; with `overwrite` it replaces an existing one. Throws InputError if the
  /// file cannot be made, or is neither empty nor a journal to be replaced.
  static Journal create(const std::string& path, const std::string& header, bool overwrite = false);
  /// Continues an existing journal, or starts one: calls `known` for each outcome in it and
  /// `unattributed` for each failure that no case caused, then cuts off a summary and an incomplete
  /// last line. Throws InputError, naming the line, if the header is that of another run or a line
  /// cannot be read.
  static Journal resume(const std::string& path, const std::string& header, const std::function<void(Outcome)>& known,
                        const std::function<void(Unattributed)>& unattributed);

  ~Journal();
  Journal(Journal&& other) noexcept;
  Journal& operator=(Journal&&) = delete;

  /// Throws JournalError.
  void add(const std::string& line);

 private:
  explicit Journal(std::string path);
  std::string path_;
  int file_ = -1;
};

// ---- a whole report, read back from a file ----

struct ReportFile {
  std::string path;
  /// every field but the command, by its path: "subject.settings.margin", "tolerance.relative"
  std::map<std::string, std::string> header;
  double unit_roundoff = 0;       ///< of the subject's numbers
  std::vector<Outcome> outcomes;  ///< in the order of the file; of an id with several lines, the last
  std::size_t repeated = 0;       ///< lines with an id that a later line has too
  std::size_t unattributed = 0;
  bool whole = false;  ///< whether it ends with a summary

  /// Returns "libccd-epa 2.1-2, fathom 0.1.0".
  [[nodiscard]] std::string title() const;
};

/// Throws InputError, naming the line and what was expected, if the file cannot be read or is no
/// report. A last line that was cut off by a kill is passed over.
ReportFile read_report(const std::string& path);

}  // namespace fathom::harness
