// SPDX-License-Identifier: GPL-3.0-or-later
// Runs one subject, or replays replies that it gave earlier; and puts many cases to several
// subjects at once.
//                                                             [verify/PROTOCOL.md; docs/certify.md]
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/process.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {

/// A command line for /bin/sh -c.
struct SubjectCommand {
  std::string shell;
};

struct Settings {
  double time_out = 10;               ///< seconds that a case may take
  double hello_time_out = 10;         ///< seconds until the hello; never less than time_out
  Tolerance tolerance = {};           ///< of the verdicts
  std::optional<mpq_class> fit = {};  ///< the size that cases are brought to; see exponent_to_fit
  std::vector<Solver> second;         ///< second solvers for every truth and judgement
  std::function<bool()> stop;         ///< asked now and then: true ends the work with Interrupted
  /// is called with each failure that no case caused, from any thread; may be empty
  std::function<void(const Unattributed&)> unattributed;
};

/// The subject cannot be started, or its hello is missing or wrong. No case caused this.
struct SubjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Starts the subject's process, puts cases to it, judges its answers, and starts it again after a
/// crash, a time-out or a stray line. Use it in the thread that made it. A failure counts as one of
/// the case only if a fresh process fails on the same case again; otherwise it is passed to
/// settings.unattributed.
class Examiner {
 public:
  /// Starts the subject and reads its hello. Throws SubjectError, Interrupted.
  Examiner(SubjectCommand command, Settings settings);
  ~Examiner();
  Examiner(const Examiner&) = delete;
  Examiner& operator=(const Examiner&) = delete;

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// Returns a sentence on what the subject wrote before its hello and was skipped, such as a
  /// greeting of a library that it loads; or "".
  [[nodiscard]] const std::string& passed_over() const { return passed_over_; }
  /// Returns how often the process was started; at least 1.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }

  /// Puts the case, brought to the size of the settings and rounded to the subject's precision, and
  /// judges the answer. For unions it puts each pair of pieces, unless the subject takes unions as
  /// pieces; each pair may take the time of a case. Throws Interrupted, Disagreement, and
  /// SubjectError if a subject that ended cannot be started again, ends each time before it reads
  /// the case, or sends a different hello.
  Outcome examine(const Case& pair);
  /// Does the same with all lengths times 2^exponent, whatever the settings say.
  Outcome examine(const Case& pair, long exponent);

  /// Returns the lines that a process reads if this case alone is put to it: hello, each run, and
  /// stop, without line ends. Puts nothing. Throws InputError with the reason for a case that would
  /// not be put to the subject.
  [[nodiscard]] std::vector<std::string> input_for(const Case& pair);

  /// Returns each run of the case as a line of a file of requests [PROTOCOL.md]. Puts nothing, and
  /// throws as input_for.
  [[nodiscard]] std::vector<std::string> requests_for(const Case& pair);

  /// Sends `stop` to the process; calls settings.unattributed if it does not exit with 0. A later
  /// case gets a fresh process.
  void finish();

 private:
  /// How the process failed to answer.
  struct Fault {
    Verdict verdict;
    std::string seen;    ///< "killed by signal 11 (Segmentation fault)", "wrote 'oops'"
    std::string reason;  ///< why that is not an answer; empty if it is obvious
    std::string words;   ///< the last words on its standard error
    std::optional<std::string> after;
    bool unread;  ///< whether the process read no byte of the case
  };

  void start();
  Process::Got read_message(std::string& line, Process::Clock::time_point deadline);
  void start_again();
  /// Returns the case as it is put to the subject; or nullopt, and the outcome of a case that is
  /// not put.
  std::optional<Case> put(const Case& pair, long exponent, Outcome& otherwise) const;
  /// Calls `take` with each case that would be put, its exponent and its message. Throws InputError
  /// for a case that would not be put.
  void note_runs(const Case& pair, const std::function<void(const Case&, long, const std::string&)>& take);
  [[nodiscard]] Judging judging();
  Outcome ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer);
  std::optional<Fault> ask_once(const Case& seen, Outcome& outcome, std::optional<SubjectAnswer>& answer);
  std::optional<Fault> understand(const std::string& line, const Case& seen, std::optional<SubjectAnswer>& answer);
  Fault fault(Verdict verdict, std::string seen, std::string reason = "");
  Fault fault_of_end(const std::string& rest);
  bool is_nobodys(const Fault& fault);
  void report_unattributed(const Fault& fault, const char* when = "");
  std::string last_words();
  std::string unfinished_line();

  SubjectCommand command_;
  Settings settings_;
  SubjectInfo info_;
  std::string passed_over_;
  Workspace workspace_;
  std::unique_ptr<Process> process_;
  std::optional<std::string> answered_;   // the last case that this process answered
  std::string ticket_;                    // of the current run
  std::uint64_t starts_ = 0, asked_ = 0;  // asked_: runs sent to this process
  int unread_ = 0;                        // number of processes in a row that ended before they read anything
};

// ---- replies that a subject gave earlier ----

/// The file has no reply to a case.
struct NoReply : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Replies by the ids of their cases, from a file: an optional hello, then replies in any order.
///                                                                             [verify/PROTOCOL.md]
class Replay {
 public:
  /// Reads a file; "-" is standard input. Without a hello the subject is "replay" in binary64, with
  /// the default conventions. Throws InputError if the file cannot be read, its hello is wrong, or
  /// it holds no reply.
  static Replay read(const std::string& given);

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// Returns a sentence with file and line for each line that is not a reply.
  [[nodiscard]] const std::vector<InputError>& faults() const { return faults_; }

  /// Judges the reply to the case. The subject got all lengths times 2^exponent. Several replies to
  /// one case are garbage. For unions without a reply of their own, judges the replies to their
  /// pairs of pieces; see pair_id. Throws NoReply, Disagreement and Interrupted. May be called by
  /// any thread.
  [[nodiscard]] Outcome examine(const Case& pair, long exponent, const Judging& judging) const;

  /// Returns the ids of replies to cases that were not put, sorted.
  [[nodiscard]] std::vector<std::string> unasked(const std::function<bool(const std::string&)>& is_asked) const;

 private:
  Outcome ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer) const;
  void take(std::string_view line, const std::string& path, std::size_t number);

  SubjectInfo info_;
  std::map<std::string, std::vector<SubjectAnswer>> answers_;
  std::vector<InputError> faults_;
};

// ---- many cases through several examiners at once ----

/// The functions of one thread.
struct Worker {
  ExamineInUnit examine;
  std::function<void()> finish;  ///< called by the same thread after the last case; may be empty
};

/// The callbacks of a run: they return its cases and receive its results. No two threads call them
/// at once, except `known`, and the workers, each of which stays in one thread.
struct RunPlan {
  unsigned jobs = 1;
  std::vector<std::string> variants;  ///< symmetries that each case is put through as well, by name
  NumberFormat format = {};
  std::optional<mpq_class> fit = {};  ///< the size that cases are brought to; see exponent_to_fit
  std::set<std::string> shapes = {};  ///< the shapes that the subject takes by name
  unsigned dimension = 3;             ///< of the bodies that it takes
  Tolerance tolerance = {};
  std::optional<ContactLimits> manifold = {};  ///< declared by the subject

  std::function<std::optional<Case>()> next;  ///< returns nullopt after the last one
  std::function<Worker()> worker;             ///< called once in each thread
  /// Returns the outcome of an earlier run, or null.
  std::function<const Outcome*(const std::string& id, const std::string& variant, const std::string& digest)> known;
  /// Receives an outcome. `original` is the case; `seen` is the case, or its variant, as it was
  /// put.
  std::function<void(const Case& original, const Case& seen, const Outcome& outcome, bool known)> found;
  /// Receives a case without an outcome, and the exception of its examiner. To end the run, rethrow
  /// it.
  std::function<void(const Case& pair, const std::exception_ptr& error)> fault;
  /// Receives a sentence on a variant that has no exact form.
  std::function<void(const Case& pair, const std::string& sentence)> left_out;
};

/// Works until there is no next case; the calling thread is one of the workers. The first exception
/// of any callback ends all workers once they have finished their cases, and is rethrown.
void run(const RunPlan& plan);

/// The files of verify/worst, a case a line, in the order of their names; defined in
/// shrink/templates/embedded.cpp.in.
extern const std::string_view worst_cases;

}  // namespace fathom::harness
