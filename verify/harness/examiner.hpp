// SPDX-License-Identifier: GPL-3.0-or-later
// One subject, alive or as it once replied, and many cases put to several of them at once.
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
  std::vector<Solver> second;         ///< ways to find every truth and judgement again
  std::function<bool()> stop;         ///< asked now and then: true ends the work with Interrupted
  /// is called with each failure that no case caused, from any thread; may be empty
  std::function<void(const Unattributed&)> unattributed;
};

/// The subject cannot be started, or its hello is missing or wrong. No case caused this.
struct SubjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Starts the subject's process, asks it, judges its answers, and starts it again after a crash, a
/// hang or a stray line. For the thread that made it. A failure counts as one of the case only if a
/// fresh process fails on the same case again; otherwise settings.unattributed is called with it.
class Examiner {
 public:
  /// Starts the subject and reads its hello. Throws SubjectError, Interrupted.
  Examiner(SubjectCommand command, Settings settings);
  ~Examiner();
  Examiner(const Examiner&) = delete;
  Examiner& operator=(const Examiner&) = delete;

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// What the subject wrote before its hello and was passed over, such as a greeting of a library
  /// that it loads: a sentence, or nothing.
  [[nodiscard]] const std::string& passed_over() const { return passed_over_; }
  /// How often the process was started; at least 1.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }

  /// Puts the case, brought to the size of the settings and rounded to the subject's precision, and
  /// judges the answer. Of unions it puts each pair of pieces, unless the subject takes them in
  /// pieces; each pair may take the time of a case. Throws Interrupted, Disagreement, and
  /// SubjectError if a subject that ended cannot be started again, ends each time before it reads
  /// the case, or sends a different hello.
  Outcome examine(const Case& pair);
  /// The same, with all lengths times 2^exponent, whatever the settings say.
  Outcome examine(const Case& pair, long exponent);

  /// What a process reads that is asked about this case alone: the lines of hello, of each run, and
  /// of stop, without their ends. Asks nothing. Throws InputError, with the reason, for a case that
  /// is not put to the subject.
  [[nodiscard]] std::vector<std::string> input_for(const Case& pair);

  /// Sends `stop` to the process; calls settings.unattributed if it does not exit with 0. A later
  /// case gets a fresh process.
  void finish();

 private:
  /// What the process did instead of answering.
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
  /// The case as it is put to the subject; nullopt, and the outcome, if it is not.
  std::optional<Case> put(const Case& pair, long exponent, Outcome& otherwise) const;
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
  std::string ticket_;                    // of the run at hand
  std::uint64_t starts_ = 0, asked_ = 0;  // asked: runs that this process was sent
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
  /// A sentence with file and line for each line that is not a reply.
  [[nodiscard]] const std::vector<InputError>& faults() const { return faults_; }

  /// Judges the reply to the case as a subject gave it that saw all lengths times 2^exponent;
  /// several replies to one case are garbage. Of unions without a reply of their own, the replies
  /// to their pairs of pieces are judged; see pair_id. Throws NoReply, Disagreement and
  /// Interrupted. Any thread may call it.
  [[nodiscard]] Outcome examine(const Case& pair, long exponent, const Judging& judging) const;

  /// The ids of replies to what was not asked, sorted.
  [[nodiscard]] std::vector<std::string> unasked(const std::function<bool(const std::string&)>& is_asked) const;

 private:
  Outcome ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer) const;
  void take(std::string_view line, const std::string& path, std::size_t number);

  SubjectInfo info_;
  std::map<std::string, std::vector<SubjectAnswer>> answers_;
  std::vector<InputError> faults_;
};

// ---- many cases through several examiners at once ----

/// What one thread works with.
struct Worker {
  ExamineInUnit examine;
  std::function<void()> finish;  ///< called in the same thread when there is no next case; may be empty
};

/// Where a run gets its work and where its results go. No two threads call these at once, except
/// `known`, and the workers, each of which stays in one thread.
struct RunPlan {
  unsigned jobs = 1;
  std::vector<std::string> variants;  ///< symmetries that each case is put through as well, by name
  NumberFormat format = {};
  std::optional<mpq_class> fit = {};  ///< the size that cases are brought to; see exponent_to_fit
  std::set<std::string> shapes = {};  ///< that the subject takes by name
  Tolerance tolerance = {};
  std::optional<ContactLimits> manifold = {};  ///< that the subject declares

  std::function<std::optional<Case>()> next;  ///< returns nullopt after the last one
  std::function<Worker()> worker;             ///< called once in each thread
  /// The outcome that an earlier run found, or null.
  std::function<const Outcome*(const std::string& id, const std::string& variant, const std::string& digest)> known;
  /// One outcome; `seen` is the case, or its variant, as the subject saw it, and `original` the
  /// case.
  std::function<void(const Case& original, const Case& seen, const Outcome& outcome, bool known)> found;
  /// Is called with a case without an outcome, and what its examiner threw. Rethrows it to end the
  /// run.
  std::function<void(const Case& pair, const std::exception_ptr& error)> fault;
  /// A variant that has no exact form.
  std::function<void(const Case& pair, const std::string& sentence)> left_out;
};

/// Works until there is no next case; the calling thread is one of the workers. The first exception
/// of any callback ends all workers once they have finished their cases, and is rethrown.
void run(const RunPlan& plan);

}  // namespace fathom::harness
