// SPDX-License-Identifier: GPL-3.0-or-later
// How long work is watched and stopped.
#pragma once

#include <stdexcept>
#include <string_view>

namespace fathom {

/// Thrown when a Monitor stopped the work.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Receives the progress of a computation, and may stop it. All calls come from the thread that
/// called the library, one at a time.
class Monitor {
 public:
  virtual ~Monitor() = default;
  /// Called now and then with the name of the stage that runs and the share of it that is done, in
  /// [0, 1].
  virtual void report(std::string_view stage, double share) = 0;
  /// Asked now and then. Once it has returned true, the computation ends with Interrupted.
  [[nodiscard]] virtual bool stopped() = 0;
};

}  // namespace fathom
