// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to many pairs of bodies, computed by several threads.
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/python/src/answers.hpp"

namespace fathom::python {
namespace {

/// The answer about a pair, or the exception in its place.
using MaybeAnswer = std::variant<std::exception_ptr, PairAnswer>;

/// The treatment of wrong pairs. returned: the exception of a pair is its result. thrown: the first
/// wrong pair, by its index, ends the work and its exception is thrown.
enum class Faults { returned, thrown };

/// The bodies of a pair, or the exception in their place.
using MaybeAsked = std::variant<std::exception_ptr, Asked>;

/// The state that the threads of a batch share. They take pairs in order, so that all pairs before
/// the first wrong one are finished.
class Batch {
 public:
  Batch(std::vector<MaybeAsked> pairs, const Question& question, Faults faults, std::atomic<std::size_t>& done)
      : pairs_(std::move(pairs)),
        question_(question),
        faults_(faults),
        done_(done),
        outcomes_(pairs_.size()),
        end_(pairs_.size()) {}

  std::atomic<bool> stop = false;

  /// Answers pairs until none is left.
  void work(Monitor* signals) {
    for (std::size_t i = next_++; i < end_ && !stop; i = next_++) {
      PlaceMonitor monitor(*this, i, signals);
      try {
        outcomes_[i] = answered(i, monitor);
      } catch (const Interrupted&) {
        continue;  // the pair comes after a wrong one, or the whole work is to stop
      } catch (...) {
        outcomes_[i] = std::current_exception();
        if (faults_ == Faults::thrown) end_before(i);
      }
      ++done_;
    }
  }

  std::vector<MaybeAnswer> outcomes() {
    if (end_ < outcomes_.size()) std::rethrow_exception(std::get<std::exception_ptr>(outcomes_[end_]));
    return std::move(outcomes_);
  }

 private:
  /// Stops the computation of a pair whose answer is no longer needed.
  class PlaceMonitor final : public Monitor {
   public:
    PlaceMonitor(Batch& batch, std::size_t place, Monitor* signals) : batch_(batch), place_(place), signals_(signals) {}
    void report(std::string_view, double) override {}
    [[nodiscard]] bool stopped() override {
      if (signals_ && signals_->stopped()) batch_.stop = true;
      return batch_.stop || place_ > batch_.end_;
    }

   private:
    Batch& batch_;
    std::size_t place_;
    Monitor* signals_;
  };

  PairAnswer answered(std::size_t i, Monitor& monitor) {
    if (const auto* const wrong = std::get_if<std::exception_ptr>(&pairs_[i])) std::rethrow_exception(*wrong);
    return named("pair " + std::to_string(i),
                 [&] { return answer_to(std::get<Asked>(std::move(pairs_[i])), question_, monitor); });
  }

  void end_before(std::size_t place) {
    std::size_t end = end_;
    while (place < end && !end_.compare_exchange_weak(end, place)) {
    }
  }

  std::vector<MaybeAsked> pairs_;
  const Question& question_;
  Faults faults_;
  std::atomic<std::size_t>& done_;
  std::vector<MaybeAnswer> outcomes_;
  std::atomic<std::size_t> next_ = 0, end_;  // pairs from index end_ on are not needed
};

/// Returns the answers to all pairs, computed by `threads` threads, or by as many as the system can
/// start, without the GIL. Increments `done` with each answer. Throws Interrupted if and only if
/// the monitor stopped the work.
std::vector<MaybeAnswer> answer_all(std::vector<MaybeAsked> pairs, const Question& question, unsigned threads,
                                    Faults faults, std::atomic<std::size_t>& done, Monitor& monitor) {
  const std::size_t useful = std::min<std::size_t>(threads, pairs.size());
  Batch batch(std::move(pairs), question, faults, done);
  std::atomic<unsigned> running = 0;
  std::vector<std::jthread> workers;
  workers.reserve(useful);
  try {
    while (workers.size() < useful) {
      ++running;
      workers.emplace_back([&] {
        batch.work(nullptr);
        --running;
      });
    }
  } catch (const std::exception&) {  // the system cannot start another thread, or has no memory for it
    --running;
    if (workers.empty()) batch.work(&monitor);
  }
  while (running > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (monitor.stopped()) batch.stop = true;
  }
  workers.clear();
  if (batch.stop) throw Interrupted();
  return batch.outcomes();
}

/// Returns what `make` returns; with Faults::returned, also the exception that it throws. Ctrl-C is
/// always thrown.
template <class Make>
MaybeAsked asked_or_fault(Faults faults, Make make) {
  try {
    return make();
  } catch (const py::error_already_set& raised) {
    if (faults == Faults::thrown || !raised.matches(PyExc_Exception)) throw;
    return std::current_exception();
  } catch (const std::exception&) {
    if (faults == Faults::thrown) throw;
    return std::current_exception();
  }
}

std::vector<MaybeAsked> asked_pairs(const py::iterable& pairs, Faults faults) {
  std::vector<MaybeAsked> result;
  for (const py::handle pair : pairs) {
    const std::string place = "pair " + std::to_string(result.size()) + ": ";
    result.push_back(asked_or_fault(faults, [&] {
      if (!PySequence_Check(pair.ptr()) || py::len(pair) != 2) throw py::value_error(place + "expected two bodies");
      const auto two = py::reinterpret_borrow<py::sequence>(pair);
      return Asked{body_from(two[0], py::none(), (place + "a").c_str()),
                   body_from(two[1], py::none(), (place + "b").c_str())};
    }));
  }
  return result;
}

/// Returns the number of poses; nullopt for None.
std::optional<std::size_t> count_of(const py::object& poses, const char* name) {
  if (poses.is_none()) return std::nullopt;
  if (!PySequence_Check(poses.ptr()) || py::isinstance<py::str>(poses))
    throw py::type_error(std::string(name) + ": expected a sequence of poses, found " + shown(poses));
  return py::len(poses);
}

/// One of the two bodies of all pairs: the same body for all, or one body of a stack for each;
/// perhaps each with a pose.
class Side {
 public:
  Side(const py::object& body, const py::object& poses, const char* name)
      : name_(name), stack_(named(name, [&] { return stacked_points(body); })), poses_(poses) {
    if (!stack_) body_ = body_from(body, py::none(), name);
    if (stack_) count(stack_->size(), "bodies");
    if (const std::optional<std::size_t> of_poses = count_of(poses, (std::string("poses_") + name).c_str()))
      count(*of_poses, "poses");
  }

  /// The number of bodies or poses, with the noun for messages; nullopt if all pairs share them.
  struct Count {
    std::size_t count;
    std::string what, of;
  };
  [[nodiscard]] const std::optional<Count>& count() const { return count_; }

  [[nodiscard]] Body body(std::size_t i, const std::string& place) const {
    if (!stack_) return body_;
    if (const auto* const fault = std::get_if<std::string>(&(*stack_)[i]))
      throw py::value_error(place + name_ + ": " + *fault);
    return std::get<Body>((*stack_)[i]);
  }
  [[nodiscard]] std::optional<files::GivenPose> pose(std::size_t i, const std::string& place) const {
    if (poses_.is_none()) return std::nullopt;
    return pose_from(py::object(poses_[py::int_(i)]), (place + name_).c_str(), body(i, place).dimension);
  }

  static void require_same(const Count& x, const Count& y) {
    if (x.count != y.count)
      throw py::value_error("expected as many " + x.what + " of " + x.of + " as " +
                            (x.what == y.what ? "" : y.what + " ") + "of " + y.of + ", found " +
                            std::to_string(x.count) + " and " + std::to_string(y.count));
  }

 private:
  void count(std::size_t count, const char* what) {
    const Count found{count, what, name_};
    if (count_) require_same(*count_, found);
    count_ = found;
  }

  std::string name_;
  std::optional<std::vector<MaybeBody>> stack_;
  Body body_;
  py::object poses_;
  std::optional<Count> count_;
};

/// Returns the pairs of two bodies, one for each body of a stack or each pose on either side.
std::vector<MaybeAsked> asked_sides(const py::object& body_a, const py::object& body_b, const py::object& poses_a,
                                    const py::object& poses_b, Faults faults) {
  const Side a(body_a, poses_a, "a"), b(body_b, poses_b, "b");
  if (a.count() && b.count()) Side::require_same(*a.count(), *b.count());
  const std::size_t count = a.count() ? a.count()->count : b.count() ? b.count()->count : 1;
  std::vector<MaybeAsked> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string place = "pair " + std::to_string(i) + ": ";
    result.push_back(asked_or_fault(faults, [&] {
      return Asked{a.body(i, place), b.body(i, place), a.pose(i, place), b.pose(i, place)};
    }));
  }
  return result;
}

/// Returns the exception object of Python that pybind11 makes of the C++ exception.
py::object exception_of(const std::exception_ptr& fault) try {
  return py::cpp_function([&fault] { std::rethrow_exception(fault); })();
} catch (const py::error_already_set& raised) {
  return raised.value();
}

/// Returns a function for the place of `stop`: it reports to `progress`, and never ends the work.
py::object told_by(const py::object& progress, const std::atomic<std::size_t>& done, std::size_t total) {
  if (progress.is_none()) return py::none();
  return py::cpp_function([&progress, &done, total] {
    progress(done.load(), total);
    return false;
  });
}

py::list depths(const py::object& a, const py::object& b, const py::object& poses_a, const py::object& poses_b,
                const Question& how, unsigned threads, Faults faults, const py::object& progress) {
  std::vector<MaybeAsked> pairs = b.is_none() ? asked_pairs(a, faults) : asked_sides(a, b, poses_a, poses_b, faults);
  const std::size_t total = pairs.size();
  std::atomic<std::size_t> done = 0;
  std::vector<MaybeAnswer> outcomes =
      watched([&](Monitor& monitor) { return answer_all(std::move(pairs), how, threads, faults, done, monitor); },
              told_by(progress, done, total));
  if (!progress.is_none()) progress(total, total);
  py::list result;
  for (MaybeAnswer& outcome : outcomes) {
    if (auto* const answer = std::get_if<PairAnswer>(&outcome)) result.append(py::cast(std::move(*answer)));
    else result.append(exception_of(std::get<std::exception_ptr>(outcome)));
  }
  return result;
}

}  // namespace

void bind_batches(py::module_& module) {
  using py::arg;
  module.def(
      "depths",
      [](const py::object& a, const py::object& b, const py::object& poses_a, const py::object& poses_b,
         const std::string& method, const std::optional<std::size_t>& optima, unsigned bits, unsigned threads,
         bool faults_returned, const py::object& progress) {
        if (threads == 0) threads = std::max(std::thread::hardware_concurrency(), 1U);
        return depths(a, b, poses_a, poses_b, question(method, optima, bits), threads,
                      faults_returned ? Faults::returned : Faults::thrown, progress);
      },
      arg("a"), arg("b"), arg("poses_a"), arg("poses_b"), arg("method"), arg("optima"), arg("bits"), arg("threads"),
      arg("faults_returned"), arg("progress"));
}

}  // namespace fathom::python
