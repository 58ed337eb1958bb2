// SPDX-License-Identifier: GPL-3.0-or-later
// What every stage is handed beside its input: whom to tell how far it is, whether to go on, and where to count.
#pragma once

#include <atomic>
#include <memory>
#include <string_view>

#include "fathom/monitor.hpp"
#include "kernels/counters.hpp"

namespace fathom {

/// One for each thread that works. The context of the calling thread speaks to the monitor; those of its workers only hear from it whether
/// to go on.
class Context {
 public:
  /// Without a monitor nothing is told and nothing stops the work. The monitor must outlive the context and its workers.
  explicit Context(Monitor* monitor = nullptr) : monitor_(monitor), stopped_(std::make_shared<std::atomic<bool>>(false)) {}

  Counters counters;

  /// Tells the monitor that `share` of the stage is done, in [0, 1]. Throws Interrupted if the work is to stop.
  void report(std::string_view stage, double share = 0);
  /// Throws Interrupted if the work is to stop. For loops inside a stage, which have nothing to tell.
  void check();

  /// The context of another thread that works for this one: counters of its own, the same stop, and nobody to tell.
  [[nodiscard]] Context worker() const;
  /// Adds what a worker has counted.
  void join(const Context& worker);

 private:
  Monitor* monitor_;
  std::shared_ptr<std::atomic<bool>> stopped_;
};

}  // namespace fathom
