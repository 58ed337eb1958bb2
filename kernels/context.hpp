// SPDX-License-Identifier: GPL-3.0-or-later
// What every stage gets beside its input: the monitor to report to, the request to stop, and the
// counters; and work in two threads, each with a context of its own.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "fathom/counters.hpp"
#include "fathom/monitor.hpp"

namespace fathom {

// In the namespace of their operands, where argument-dependent lookup finds them.

/// Returns what was counted since `before` was copied.
PredicateCounts operator-(const PredicateCounts& now, const PredicateCounts& before);
PredicateCounts& operator+=(PredicateCounts& sum, const PredicateCounts& more);

/// Adds the counts of `more`; the seed stays.
Counters& operator+=(Counters& sum, const Counters& more);

}  // namespace fathom

namespace fathom::kernels {

struct Count {
  std::string_view name;
  std::uint64_t value;
};

/// The counters of one stage of a run, but those of the predicates. It has run if any of them is
/// not 0.
struct StageCounts {
  std::string_view stage;
  std::vector<Count> counts;
  [[nodiscard]] bool ran() const {
    return std::ranges::any_of(counts, [](const Count& count) { return count.value != 0; });
  }
};

/// The counters by name and stage, in the order in which results list them.
std::vector<StageCounts> counts_by_stage(const Counters& counters);

/// Each thread that works has one. That of the calling thread reports to the monitor; those of its
/// workers only share the request to stop.
class Context {
 public:
  /// Without a monitor nothing is reported and nothing stops the work. The monitor must outlive the
  /// context and its workers.
  explicit Context(Monitor* monitor = nullptr)
      : monitor_(monitor), stopped_(std::make_shared<std::atomic<bool>>(false)) {}

  Counters counters;

  /// Reports that `share` of the stage is done, in [0, 1]. Throws Interrupted if the work is to
  /// stop.
  void report(std::string_view stage, double share = 0);
  /// Throws Interrupted if the work is to stop. For loops inside a stage, which have no share to
  /// report.
  void check();

  /// Returns the context for a thread that works for this one: with its own counters, the same
  /// request to stop, and no monitor.
  [[nodiscard]] Context worker() const;
  /// Adds what a worker has counted.
  void join(const Context& worker);

 private:
  Monitor* monitor_;
  std::shared_ptr<std::atomic<bool>> stopped_;
};

/// Calls both, in two threads if `worth_it`, else one after the other. `first` gets `context`; so
/// does `second`, unless it runs in its own thread: then it gets a worker of `context`, which is
/// joined. When this returns or throws, neither runs any more. If `first` throws, that exception is
/// rethrown, else that of `second`.
void run_both(bool worth_it, Context& context, const std::function<void(Context&)>& first,
              const std::function<void(Context&)>& second);

}  // namespace fathom::kernels
