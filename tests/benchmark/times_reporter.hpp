// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks named instance/contender: what was printed is remembered, so that ratios can be
// printed at the end.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace fathom::benchmarks {

/// Times by instance and contender. Finalize of a derived class prints what it makes of them.
class TimesReporter : public benchmark::ConsoleReporter {
 public:
  enum class Time { real, processor };
  using Times = std::map<std::string, std::map<std::string, double>>;

  explicit TimesReporter(Time time) : time_(time) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.error_occurred) continue;
      const std::string name = run.run_name.function_name;
      const std::size_t slash = name.rfind('/');
      times_[name.substr(0, slash)][name.substr(slash + 1)] =
          time_ == Time::real ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
    }
  }

 protected:
  [[nodiscard]] const Times& times() const { return times_; }

 private:
  Time time_;
  Times times_;
};

}  // namespace fathom::benchmarks
