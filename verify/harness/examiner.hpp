// SPDX-License-Identifier: GPL-3.0-or-later
// One subject: starts its process, asks it, judges its answers, and starts it again after a crash, a hang or a stray line.
//                                                                                                     [verify/PROTOCOL.md]
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

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
  double time_out = 10;                                   ///< seconds that a case may take
  double hello_time_out = 10;                             ///< seconds until the hello; never less than time_out
  Tolerance tolerance = {};                               ///< of the verdicts
  std::optional<mpq_class> fit = {};                      ///< the size that cases are brought to; see exponent_to_fit
  std::vector<Solver> second;                             ///< ways to find every truth and judgement again
  std::function<bool()> stop;                             ///< asked now and then: true ends the work with Interrupted
  std::function<void(const Unattributed&)> unattributed;  ///< hears of failures that no case caused; called from any thread
};

/// The subject cannot be started, or its hello is missing or wrong. No case caused this.
struct SubjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// For the thread that made it. A failure is blamed on a case only if a fresh process fails on the same case again; otherwise
/// settings.unattributed hears of it.
class Examiner {
 public:
  /// Starts the subject and hears its hello. Throws SubjectError, Interrupted.
  Examiner(SubjectCommand command, Settings settings);
  ~Examiner();
  Examiner(const Examiner&) = delete;
  Examiner& operator=(const Examiner&) = delete;

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// What the subject wrote before its hello and was passed over, such as a greeting of a library that it loads: a sentence, or nothing.
  [[nodiscard]] const std::string& passed_over() const { return passed_over_; }
  /// How often the process was started; at least 1.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }

  /// Puts the case, brought to the size of the settings and rounded to the subject's precision, and judges the answer. Of unions it puts
  /// each pair of pieces, unless the subject takes them in pieces; each pair may take the time of a case. Throws Interrupted, Disagreement,
  /// and SubjectError if a subject that ended cannot be started again, ends each time before it reads the case, or sends a different hello.
  Outcome examine(const Case& pair);
  /// The same, with all lengths times 2^exponent, whatever the settings say.
  Outcome examine(const Case& pair, long exponent);

  /// What a process reads that is asked about this case alone: the lines of hello, of each run, and of stop, without their ends. Asks
  /// nothing. Throws InputError, with the reason, for a case that is not put to the subject.
  [[nodiscard]] std::vector<std::string> input_for(const Case& pair);

  /// Tells the process to stop; settings.unattributed hears if it does not exit with 0. A case that follows gets a fresh process.
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
  void tell(const Fault& fault, const char* when = "");
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

}  // namespace fathom::harness
