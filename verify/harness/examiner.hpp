// SPDX-License-Identifier: GPL-3.0-or-later
// One subject: its process is started, asked, judged, and started again when it has crashed, hung or babbled. [verify/PROTOCOL.md]
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "verify/harness/outcome.hpp"
#include "verify/harness/process.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {

/// What is handed to /bin/sh -c.
struct SubjectCommand {
  std::string shell;
};

struct Settings {
  double time_out = 10;                                   ///< seconds that a case may take
  double hello_time_out = 10;                             ///< seconds until the hello; never less than time_out
  Tolerance tolerance = {};                               ///< of the verdicts
  std::function<bool()> stop;                             ///< asked now and then: true ends the work with Interrupted
  std::function<void(const Unattributed&)> unattributed;  ///< told what the subject does that is no case's fault; any thread
};

/// The subject cannot be started, or does not say who it is. Nothing can be blamed on a case.
struct SubjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// For one thread, which must be the one that made it. What goes wrong is a case's fault if it goes wrong again when a fresh process gets
/// the case, and else nobody's: settings.unattributed hears of it.
class Examiner {
 public:
  /// Starts the subject and hears its hello. Throws SubjectError, Interrupted.
  Examiner(SubjectCommand command, Settings settings);
  ~Examiner();
  Examiner(const Examiner&) = delete;
  Examiner& operator=(const Examiner&) = delete;

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// How often the process was started; at least 1.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }

  /// Puts the case, rounded to the subject's precision, and judges the answer. Throws SubjectError when a subject that ended cannot be
  /// started again, ends each time before it reads the case, or says something else of itself then; Interrupted.
  Outcome examine(const Case& pair);

  /// Tells the process to stop, and settings.unattributed if it does not end in good order. A case may still follow: it gets a fresh one.
  void finish();

 private:
  /// What came in place of an answer.
  struct Fault {
    Verdict verdict;
    std::string seen;    ///< "killed by signal 11 (Segmentation fault)", "wrote 'oops'"
    std::string reason;  ///< why that is no answer; empty where that is plain
    std::string words;   ///< the last ones of the process
    std::optional<std::string> after;
    bool unread;  ///< whether nothing of the case was read
  };

  void start();
  void start_again();
  Outcome ask(const Case& seen);
  std::optional<Fault> ask_once(const Case& seen, Outcome& outcome);
  std::optional<Fault> understand(const std::string& line, const Case& seen, Outcome& outcome);
  Fault fault(Verdict verdict, std::string seen, std::string reason = "");
  Fault fault_of_end(const std::string& rest);
  bool is_nobodys(const Fault& fault);
  void tell(const Fault& fault, const char* when = "");
  std::string last_words();
  std::string unfinished_line();

  SubjectCommand command_;
  Settings settings_;
  SubjectInfo info_;
  std::unique_ptr<Process> process_;
  std::optional<std::string> answered_;     // the last case that this process answered
  std::uint64_t starts_ = 0, tickets_ = 0;  // tickets: of this process
  int unread_ = 0;                          // so many processes in a row ended before they read anything
};

}  // namespace fathom::harness
