// SPDX-License-Identifier: GPL-3.0-or-later
// Long work that Ctrl-C ends, and that leaves Python's lock to others.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>

#include "fathom/monitor.hpp"

namespace fathom::python {

namespace py = pybind11;

/// Asks Python now and then whether a signal came. For the thread that called from Python, which has let the lock go.
class SignalMonitor final : public Monitor {
 public:
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override {
    if (signalled_) return true;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + pause;
    const py::gil_scoped_acquire lock;
    return signalled_ = PyErr_CheckSignals() != 0;
  }

  static constexpr std::chrono::milliseconds pause{50};

 private:
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + pause;
  bool signalled_ = false;
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

/// Returns work(monitor), with Python's lock let go. After a signal it throws what Python's handler raised: KeyboardInterrupt.
template <class Work>
auto watched(Work work) {
  try {
    const py::gil_scoped_release unlocked;
    SignalMonitor monitor;
    return work(monitor);
  } catch (const Interrupted&) {
    if (!PyErr_Occurred()) PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
}

}  // namespace fathom::python
