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
struct Command {
  std::string shell;
};

struct Settings {
  double time_out = 10;                          ///< seconds that a case may take
  double hello_time_out = 10;                    ///< seconds until the hello; never less than time_out
  Tolerance tolerance = {};                      ///< of the verdicts
  std::function<bool()> stop;                    ///< asked now and then: true ends the work with Interrupted
  std::function<void(const std::string&)> note;  ///< told in a sentence what the subject does that is no case's fault; any thread
};

/// The subject cannot be started, or does not say who it is. Nothing can be blamed on a case.
struct SubjectError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// For one thread, which must be the one that made it. Whatever the subject does, exactly the case at hand is blamed for it.
class Examiner {
 public:
  /// Starts the subject and hears its hello. Throws SubjectError, Interrupted.
  Examiner(Command command, Settings settings);
  ~Examiner();
  Examiner(const Examiner&) = delete;
  Examiner& operator=(const Examiner&) = delete;

  [[nodiscard]] const SubjectInfo& info() const { return info_; }
  /// How often the process was started; at least 1.
  [[nodiscard]] std::uint64_t starts() const { return starts_; }

  /// Puts the case, rounded to the subject's precision, and judges the answer. Throws SubjectError when a subject that ended cannot be
  /// started again, or says something else of itself then; Interrupted.
  Outcome examine(const Case& pair);

 private:
  void start();
  void start_again(const std::string& why);
  Outcome ask(const Case& seen);
  bool ask_once(const Case& seen, Outcome& outcome);
  bool understand(const std::string& line, const std::string& ticket, const Case& seen, Outcome& outcome);
  void blame(Outcome& outcome, Verdict verdict, std::string detail);
  void blame_the_end(Outcome& outcome, const std::string& rest);
  std::string with_last_words(std::string sentence);

  Command command_;
  Settings settings_;
  SubjectInfo info_;
  std::unique_ptr<Process> process_;
  std::uint64_t starts_ = 0, tickets_ = 0, first_ticket_ = 0;  // of this process
};

}  // namespace fathom::harness
