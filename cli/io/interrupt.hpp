// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C ends the run with exit code 130, at once while waiting for input and at the next good moment while working.
#pragma once

#include "fathom/monitor.hpp"

namespace fathom::cli {

/// Handles SIGINT as described above. SIGPIPE gets its default action back, so a reader that has enough (`| head`) ends the run quietly.
void install_signal_handlers();

/// Whether SIGINT arrived while a `Working` existed.
bool interrupt_requested();

/// Stops a computation once SIGINT was noted. Any thread may ask it.
class StopOnInterrupt : public Monitor {
 public:
  void report(std::string_view /*stage*/, double /*share*/) override {}
  [[nodiscard]] bool stopped() override { return interrupt_requested(); }
};

/// While one exists, SIGINT is noted instead of ending the process, so that no line is cut in two and a computation can stop by
/// itself. If it has not stopped after `patience` seconds, or on a second SIGINT, the process ends all the same.
class Working {
 public:
  explicit Working(unsigned patience = 1);
  ~Working();
  Working(const Working&) = delete;
  Working& operator=(const Working&) = delete;
};

/// Call it when the work has stopped and its results are being written: from then on only a second SIGINT ends the process early.
void take_time_to_write();

/// Sets whether an unfinished line stands on the terminal, which is erased before a last message.
void line_is_open(bool open);

}  // namespace fathom::cli
