// SPDX-License-Identifier: GPL-3.0-or-later
// How long each stage of a run takes: a monitor that looks at the clock when a stage begins, and passes everything on.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "fathom/monitor.hpp"

namespace fathom::stages {

class StageTimes : public Monitor {
 public:
  /// `next`, which may be null, hears everything too.
  explicit StageTimes(Monitor* next) : next_(next) {}

  void report(std::string_view stage, double share) override {
    if (running_.empty() || running_.back().first != stage) {
      end();
      running_.emplace_back(stage, 0);
      begin_ = Clock::now();
    }
    if (next_) next_->report(stage, share);
  }
  [[nodiscard]] bool stopped() override { return next_ && next_->stopped(); }

  /// The stage that runs ends here.
  void end() {
    if (!running_.empty() && begin_ != Clock::time_point{})
      running_.back().second = std::chrono::duration<double>(Clock::now() - begin_).count();
    begin_ = {};
  }
  /// In the order in which they ran. Before the first: not measured.
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& seconds() const { return running_; }

 private:
  using Clock = std::chrono::steady_clock;

  Monitor* next_;
  std::vector<std::pair<std::string, double>> running_;
  Clock::time_point begin_{};
};

}  // namespace fathom::stages
