// SPDX-License-Identifier: GPL-3.0-or-later
// Long work that Ctrl-C ends, and that leaves Python's lock to others.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "fathom/monitor.hpp"

namespace fathom::python {

namespace py = pybind11;

/// Asks Python now and then whether a signal came, and `stop`, unless it is None, whether the work is to end. For the thread that called
/// from Python, which has let the lock go.
class SignalMonitor final : public Monitor {
 public:
  explicit SignalMonitor(py::object stop) : stop_(std::move(stop)) {}
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override {
    if (ended_) return true;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + pause;
    const py::gil_scoped_acquire lock;
    return ended_ = PyErr_CheckSignals() != 0 || told();
  }

  static constexpr std::chrono::milliseconds pause{50};

 private:
  /// What `stop` raises is left to whoever asks Python for it.
  bool told() try { return !stop_.is_none() && py::bool_(stop_()); } catch (py::error_already_set& raised) {
    raised.restore();
    return true;
  }

  py::object stop_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + pause;
  bool ended_ = false;
};

/// Stops when it is told to. For the threads of a batch.
class FlagMonitor final : public Monitor {
 public:
  explicit FlagMonitor(const std::atomic<bool>& stop) : stop_(stop) {}
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override { return stop_; }

 private:
  const std::atomic<bool>& stop_;
};

/// Returns work(monitor), with Python's lock let go. After a signal it throws what Python's handler raised: KeyboardInterrupt. So it does
/// with what `stop` raises. Work that `stop` ended returns what it has, or throws std::runtime_error if that is nothing.
template <class Work>
auto watched(Work work, py::object stop = py::none()) {
  const bool asked = !stop.is_none();
  SignalMonitor monitor(std::move(stop));
  try {
    auto result = [&] {
      const py::gil_scoped_release unlocked;
      return work(monitor);
    }();
    if (PyErr_Occurred()) throw py::error_already_set();
    return result;
  } catch (const Interrupted&) {
    if (PyErr_Occurred()) throw py::error_already_set();
    if (asked) throw std::runtime_error("stopped before anything was known");
    throw;
  }
}

}  // namespace fathom::python
