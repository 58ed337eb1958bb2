// SPDX-License-Identifier: GPL-3.0-or-later
// The answer about two bodies of any kinds, in the words of Python; and long work, which Ctrl-C
// ends, and which leaves Python's lock to others.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/src/bodies.hpp"
#include "fathom/answer.hpp"
#include "fathom/monitor.hpp"
#include "reference/output/answer_json.hpp"

namespace fathom::python {

namespace py = pybind11;

/// Asks Python now and then whether a signal came, and `stop`, unless it is None, whether the work
/// is to end. For the thread that called from Python, which has let the lock go.
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

/// Returns work(monitor), with Python's lock let go. After a signal it throws what Python's handler
/// raised: KeyboardInterrupt. So it does with what `stop` raises. Work that `stop` ended returns
/// what it has, or throws std::runtime_error if that is nothing.
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

/// Two bodies, and where they are.
struct Asked {
  Body a, b;
  std::optional<files::GivenPose> pose_a = std::nullopt, pose_b = std::nullopt;
};

/// A manifold, and whether its places are those of an answer about shapes.
struct ToldManifold {
  output::Manifold manifold;
  bool of_shapes = false;
};

/// Its numbers are computed when they are asked for.
struct PairAnswer {
  Body a, b;  ///< where they are
  Question question;
  Answer answer;
  std::vector<std::string> notes = {};          ///< on the poses
  std::string dents = {};                       ///< what is said of meshes that are not convex; else empty
  std::shared_ptr<ToldManifold> manifold = {};  ///< where the bodies touch, once somebody has asked

  /// Returns the depth of two polytopes; of shapes if one is another shape; of unions if one is a
  /// union. Null if the answer is of another kind.
  [[nodiscard]] const Depth* depth() const { return std::get_if<Depth>(&answer.found); }
  [[nodiscard]] const SignedDepth* of_shapes() const { return std::get_if<SignedDepth>(&answer.found); }
  [[nodiscard]] const UnionDepth* of_unions() const { return std::get_if<UnionDepth>(&answer.found); }
};

/// Returns the question by arguments that Python has checked. Throws py::value_error for an unknown
/// method.
Question question(const std::string& method, const std::optional<std::size_t>& optima, unsigned bits);

/// Returns the answer about convex bodies. May be called without Python's lock.
PairAnswer answer_to(Asked asked, const Question& question, Monitor& monitor);

/// Returns how often each predicate was asked, by name.
py::dict predicates(const PredicateCounts& counts);
/// A dict of kind, a, b; None if there is none.
py::object contact(const Contact* contact);
/// A pair of points, as floats or fractions; None if there is none.
py::object witness(const std::optional<Witness>& witness, bool exact);
/// By the indices of points.
py::dict weights(const std::vector<Weight>& of_points);
/// Each component of n / |n|, correctly rounded.
py::array_t<double> unit(const Vector& n);
/// Floats, or (p, n, r) for p + r n/|n|.
py::object rounded_point(const RoundedPoint& p, bool exact);

/// Where the bodies of an answer touch, found the first time; null if the search was stopped.
std::shared_ptr<ToldManifold> manifold_told(PairAnswer& asked);

/// Manifold. To be called before bind_answers.
void bind_manifolds(py::module_& module);
/// Answer, depth, width, union_depth, check.
void bind_answers(py::module_& module);
/// depths.
void bind_batches(py::module_& module);
/// Prepared, overlap, closer_than, ray, metric, approx, study, judge.
void bind_questions(py::module_& module);

}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::python::PairAnswer>
    : fathom::python::MadeCaster<fathom::python::PairAnswer> {};

template <>
struct pybind11::detail::type_caster<fathom::python::ToldManifold>
    : fathom::python::MadeCaster<fathom::python::ToldManifold> {};
