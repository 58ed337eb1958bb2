// SPDX-License-Identifier: GPL-3.0-or-later
// The answer about two bodies of any kinds as objects of Python; and long computations, which
// release Python's global interpreter lock (GIL) and which Ctrl-C ends.
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

/// Every `pause`, checks for Python's signals, and calls `stop`, unless it is None, to ask whether
/// the computation is to end. Used by the thread that Python called, which has released the GIL.
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
  /// Returns whether `stop` returned true. An exception that it raises counts as true, and is kept
  /// as Python's current error.
  bool told() try { return !stop_.is_none() && py::bool_(stop_()); } catch (py::error_already_set& raised) {
    raised.restore();
    return true;
  }

  py::object stop_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + pause;
  bool ended_ = false;
};

/// Stops a computation when the flag `stop` is set. Used by the threads of a batch.
class FlagMonitor final : public Monitor {
 public:
  explicit FlagMonitor(const std::atomic<bool>& stop) : stop_(stop) {}
  void report(std::string_view, double) override {}
  [[nodiscard]] bool stopped() override { return stop_; }

 private:
  const std::atomic<bool>& stop_;
};

/// Returns work(monitor), computed without the GIL. Throws the exception that Python's signal
/// handler raised (KeyboardInterrupt), or the one that `stop` raised. If `stop` ended the work,
/// returns the partial result, or throws std::runtime_error if there is none.
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

/// Two bodies in their poses.
struct Asked {
  Body a, b;
  std::optional<files::GivenPose> pose_a = std::nullopt, pose_b = std::nullopt;
};

/// A contact manifold. `of_shapes`: its points are those of an answer about shapes.
struct ToldManifold {
  output::Manifold manifold;
  bool of_shapes = false;
};

/// An answer about a pair of bodies; the objects of Python for its numbers are made when they are
/// read.
struct PairAnswer {
  Body a, b;  ///< in their poses
  Question question;
  Answer answer;
  std::vector<std::string> notes = {};          ///< warnings about the poses
  std::string dents = {};                       ///< the warning about meshes that are not convex; else empty
  std::shared_ptr<ToldManifold> manifold = {};  ///< computed when it is first read

  /// Returns the depth of two polytopes; of shapes if one is another shape; of unions if one is a
  /// union. Null if the answer is of another kind.
  [[nodiscard]] const Depth* depth() const { return std::get_if<Depth>(&answer.found); }
  [[nodiscard]] const SignedDepth* of_shapes() const { return std::get_if<SignedDepth>(&answer.found); }
  [[nodiscard]] const UnionDepth* of_unions() const { return std::get_if<UnionDepth>(&answer.found); }
};

/// Returns the question of these arguments, which Python has checked. Throws py::value_error for an
/// unknown method.
Question question(const std::string& method, const std::optional<std::size_t>& optima, unsigned bits);

/// Returns the answer about convex bodies. May be called without the GIL.
PairAnswer answer_to(Asked asked, const Question& question, Monitor& monitor);

/// Returns the number of calls of each predicate, by name.
py::dict predicates(const PredicateCounts& counts);
/// Returns a dict of kind, a, b; None for nullptr.
py::object contact(const Contact* contact);
/// Returns a dict of weights by the indices of the points.
py::dict weights(const std::vector<Weight>& of_points);
/// Returns dicts of kind, ids.
py::list features(const std::vector<MeshFeature>& of_mesh);
// With dimension 2, of the plane, these leave out z, as those of numbers.hpp do.

/// Returns a pair of points, as floats or fractions; None for nullopt.
py::object witness(const std::optional<Witness>& witness, bool exact, unsigned dimension = 3);
/// Each component of n / |n|, correctly rounded.
py::array_t<double> unit(const Vector& n, unsigned dimension = 3);
/// Returns a velocity; in the plane of two numbers and an angular speed. Three zeros, the usual
/// value of either argument, are rest there too.
Twist twist_from(py::handle v, py::handle w, const char* v_name, const char* w_name, unsigned dimension);
/// Returns floats, or (p, n, r) for p + r n/|n| if `exact`.
py::object rounded_point(const RoundedPoint& p, bool exact, unsigned dimension = 3);

/// Returns the contact manifold of an answer, computed at the first call; null if the search was
/// stopped.
std::shared_ptr<ToldManifold> manifold_told(PairAnswer& asked);

/// Defines Manifold and impact. Call it before bind_answers.
void bind_manifolds(py::module_& module);
/// Defines Answer, depth, width, union_depth, check.
void bind_answers(py::module_& module);
/// Defines depths.
void bind_batches(py::module_& module);
/// Defines Prepared, overlap, closer_than, ray, metric, approx, study, judge.
void bind_questions(py::module_& module);

}  // namespace fathom::python

template <>
struct pybind11::detail::type_caster<fathom::python::PairAnswer>
    : fathom::python::MadeCaster<fathom::python::PairAnswer> {};

template <>
struct pybind11::detail::type_caster<fathom::python::ToldManifold>
    : fathom::python::MadeCaster<fathom::python::ToldManifold> {};
