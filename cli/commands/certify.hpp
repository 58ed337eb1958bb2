// SPDX-License-Identifier: GPL-3.0-or-later
// The request of a run of `fathom certify`; the run itself, within one process or shared by many;
// and its results: collected while it runs, written at the end, with failing cases reduced.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "fathom/judge.hpp"
#include "verify/harness/examiner.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/report/reports.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::cli {

/// The options of a run.
struct CertifyRequest {
  explicit CertifyRequest(const Given& given);

  bool worst = false;                    ///< the cases that are part of the program, in the place of a stream
  std::string cases;                     ///< the stream, or what messages call these
  std::string command_line;              ///< quoted for a shell
  std::string subject, adapter, replay;  ///< exactly one of these is set
  bool json = false;
  std::optional<unsigned> jobs;  ///< if not set, as many as there are processors
  double time_out = 10;          ///< seconds
  Tolerance tolerance;
  std::optional<mpq_class> fit;  ///< the size that each case is brought to
  std::optional<Motion> motion;  ///< of cases that have none
  std::vector<Method> methods;   ///< by which every truth and judgement is found again
  std::string report;
  bool resume = false, overwrite = false;  ///< of an existing report
  bool all_rows = false;                   ///< in the table
  std::string print_input;                 ///< the id of the case to print as the subject reads it; empty: none
  std::string write_requests;              ///< the path of a file of all that the subject reads; empty: none
  std::string harness;                     ///< the user's own program for --shrink; empty: none
  std::vector<std::string> variants;       ///< of each case, put too
  std::string expect_fail, write_expect_fail, junit, html, certificates, shrink;  ///< paths; empty: not wanted
  std::optional<std::size_t> max_errors;
};

/// Other processes that examine the cases, in place of threads.
struct ExaminersElsewhere {
  unsigned count = 0;  ///< cases examined at once; 0: this process examines them
  /// Examines a case, with all lengths times 2^exponent, by a subject whose hello must be `hello`.
  /// May be called by `count` threads at once. Throws as Examiner::examine.
  std::function<harness::Outcome(const Case&, long exponent, const std::string& hello)> examine = {};
};

/// Makes a run, from the subject's hello to the exit code. Throws as run_certify.
ExitCode certify(const CertifyRequest& request, const ExaminersElsewhere& elsewhere);

/// Returns the shell command of the request's subject. Throws InputError if its adapter is unknown
/// or not built.
harness::SubjectCommand subject_of(const CertifyRequest& certify);

/// Returns the examiner's settings for this request; failures that no case caused are not reported.
harness::Settings examiner_settings(const CertifyRequest& certify);

// The results of a run: collected while it runs, written at the end, with failing cases reduced.

/// A failing case after rounding to the subject's number format.
struct FailedCase {
  std::size_t outcome;  ///< index into outcomes()
  Case seen;
  Case original;  ///< the case whose variant it is, or the same case
};

class Collector {
 public:
  /// Starts the report, or continues an existing one. `expected`: the number of cases, if it is
  /// known.
  Collector(const CertifyRequest& request, const harness::SubjectInfo& info, std::optional<std::size_t> expected);

  /// Returns the outcome of an earlier run in the report, or nullptr. May be called by any thread.
  [[nodiscard]] const harness::Outcome* known(const std::string& id, const std::string& variant,
                                              const std::string& digest) const;

  /// Takes one outcome, and first appends it to the report, unless it is `known`, that is in the
  /// report already.
  void take(const Case& original, const Case& seen, const harness::Outcome& outcome, bool known);
  /// The same for a failure that no case caused; `known`: it is in the report already.
  void take(const harness::Unattributed& unattributed, bool known = false);
  /// Prints a sentence for the user, above the progress bar. Prints the first few of a kind, and
  /// counts the others.
  void tell(const std::string& kind, const std::string& sentence);
  /// Prints the number of sentences that were counted but not printed; removes the bar.
  void close();
  /// Writes the last line of the report and of --json.
  void complete();

  [[nodiscard]] const std::vector<harness::Outcome>& outcomes() const { return outcomes_; }
  [[nodiscard]] const std::vector<FailedCase>& failed() const { return failed_; }
  [[nodiscard]] const harness::Summary& summary() const { return summary_; }
  [[nodiscard]] Progress& progress() { return progress_; }

 private:
  void show_progress();

  const CertifyRequest& request_;
  std::optional<std::size_t> expected_;
  std::optional<harness::Journal> journal_;
  std::map<std::tuple<std::string, std::string, std::string>, harness::Outcome> known_;
  std::vector<harness::Outcome> outcomes_;
  std::vector<FailedCase> failed_;
  harness::Summary summary_;
  std::map<std::string, std::size_t> told_;
  std::size_t cases_ = 0, cases_before_ = 0;  ///< cases_before_: those of them known from an earlier run
  double worst_ = 0;                          ///< the largest relative error
  Progress progress_;
};

// The files that are written at the end of a run, and its exit code.

/// Throws InputError if one of the requested files and folders cannot be written. Makes folders.
void probe_reports(const CertifyRequest& certify);

/// Returns the list that --write-expect-fail replaces, to keep its comments; an empty one if there
/// is none. Throws InputError.
harness::ExpectedFailures earlier_list(const CertifyRequest& certify);

/// Names of files, by index of the outcome.
using CertificateNames = std::map<std::size_t, std::string>;
/// Writes a certificate for each failing case, if requested. Prints the ids of cases whose
/// certificate would exceed the limits of the checkers, and writes none for them. Throws
/// OutputError, InputError, Interrupted.
CertificateNames write_certificates(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found);

/// Writes JUnit and the page, if requested. `cut_short`: why cases are missing; empty if none is.
/// Throws OutputError, InputError.
void write_reports(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found,
                   const std::optional<harness::ExpectedFailures::Check>& known, const CertificateNames& certificates,
                   const std::string& cut_short);

/// Writes the list of known failures, if requested. Throws OutputError, InputError.
void write_list(const CertifyRequest& certify, const harness::SubjectInfo& info, const Collector& found,
                const harness::ExpectedFailures& earlier);

/// Returns sentences on where to find more than in the table: the reports that were written, and
/// the options for the others.
std::vector<std::string> where_to_look(const CertifyRequest& certify);

/// Returns the exit code by the verdicts alone: fine, judged_wrong, or incomplete if nothing was
/// judged. Prints where run and list disagree.
ExitCode code_of(const CertifyRequest& certify, Collector& found,
                 const std::optional<harness::ExpectedFailures::Check>& known);

// `fathom certify --shrink`: reduces one failing case of each verdict, and one on which two methods
// of fathom disagree.

/// Reduces, for each verdict and variant that failed, the smallest failing case; writes it to disk
/// at each step. Prints the names of the files, one a line; with --json on standard error. Throws
/// Interrupted, SubjectError, InputError.
void shrink_failures(const CertifyRequest& request, harness::Examiner& examiner, Collector& found);

/// Reduces a case on which two methods of fathom disagree, and writes it to the folder at each
/// step. Prints the names of the files on standard error. Throws Interrupted, InputError.
void shrink_disagreement(const std::string& folder, const harness::Disagreement& found, Progress& progress);

}  // namespace fathom::cli
