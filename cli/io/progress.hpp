// SPDX-License-Identifier: GPL-3.0-or-later
// A bar on standard error, for work over a second and only on a terminal, in one line of it. It also carries Ctrl-C into a computation.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "cli/io/interrupt.hpp"

namespace fathom::cli {

class Progress : public StopOnInterrupt {
 public:
  Progress();
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Names what the next reports are about: "line 12". Does not restart the clock.
  void about(std::string what);
  /// A share below 0 is unknown, and has no bar.
  void report(std::string_view stage, double share) override;
  /// Takes the bar off the screen until the next report, so that other text can be printed.
  void clear();
  /// The same before text for standard output: if that is not a terminal the bar stays, or many short cases would show none.
  void answered();

 private:
  using Clock = std::chrono::steady_clock;
  void keep_drawing();
  void draw();
  void erase();

  Clock::time_point begin_ = Clock::now();
  std::string what_, stage_;
  double share_ = 0;
  bool answers_are_seen_ = true, active_ = false, drawn_ = false, stop_ = false;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread painter_;  // a stage may take long without a report; the clock on the bar shows that it lives
};

}  // namespace fathom::cli
