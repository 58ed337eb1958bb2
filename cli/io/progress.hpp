// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C ends the run with exit code 130, at once while waiting for input and at the next good
// moment while working.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "fathom/monitor.hpp"

namespace fathom::cli {

/// Handles SIGINT as described above. SIGPIPE gets its default action back, so a reader that has
/// enough (`| head`) ends the run quietly.
void install_signal_handlers();

/// Returns whether SIGINT arrived while an `InterruptGuard` existed.
bool interrupt_requested();

/// Stops a computation after SIGINT. May be called by any thread.
class StopOnInterrupt : public Monitor {
 public:
  void report(std::string_view /*stage*/, double /*share*/) override {}
  [[nodiscard]] bool stopped() override { return interrupt_requested(); }
};

/// While one exists, SIGINT is noted instead of ending the process, so that no line is cut in two
/// and a computation can stop by itself. If it has not stopped after `patience` seconds, or on a
/// second SIGINT, the process ends all the same.
class InterruptGuard {
 public:
  explicit InterruptGuard(unsigned patience = 1);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// Call it when the work has stopped and its results are being written: from then on only a second
/// SIGINT ends the process early.
void take_time_to_write();

// One line on standard error, for work over a second and only on a terminal: how many items of how
// many are done, how long the rest will take, and the current item. It never scrolls, and is erased
// at the end. It also stops a computation after Ctrl-C.

/// The number of items that are done.
struct ProgressCount {
  std::size_t done = 0;
  std::optional<std::size_t> of;  ///< if known
  std::size_t before = 0;         ///< the number of these that an earlier run has done
};

class Progress : public StopOnInterrupt {
 public:
  /// `units`: the name of the items.
  explicit Progress(std::string units = "cases");
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Returns whether anything is shown: on a terminal.
  [[nodiscard]] bool is_seen() const { return painter_.joinable(); }
  /// Names the item of the next reports: "line 12". Restarts its clock, not that of the run.
  void about(std::string what);
  /// Shows the stage of the current item. A share of 0 or less means that it is not known yet, and
  /// has no bar.
  void report(std::string_view stage, double share) override;
  /// Makes the bar show the progress of the whole run. `more`: a further text.
  void count(const ProgressCount& count, std::string more = "");
  /// Makes the line show the current item again.
  void end_count();
  /// Removes the line from the screen until the next report or count, so that other text can be
  /// printed.
  void clear();
  /// Does the same before text for standard output. If that is not a terminal the line is kept,
  /// because otherwise it would not be seen during many short cases.
  void answered();

 private:
  using Clock = std::chrono::steady_clock;
  void keep_drawing();
  void draw();
  void erase();
  [[nodiscard]] std::vector<std::string> counted_parts(double seconds) const;
  [[nodiscard]] std::string stage_text() const;

  Clock::time_point begin_ = Clock::now(), begin_of_case_ = begin_;
  std::string units_, what_, stage_, more_;
  double share_ = -1;
  std::optional<ProgressCount> count_;
  bool answers_are_seen_ = true, active_ = false, drawn_ = false, stop_ = false;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread painter_;  // shows the time during a stage without reports
};

}  // namespace fathom::cli
