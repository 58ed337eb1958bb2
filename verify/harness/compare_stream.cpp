// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are handed out in ascending order, and whoever has one finishes it. So once all are done, every case below the least number with
// a difference has been compared.
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "verify/harness/two_ways.hpp"

namespace fathom::harness {
namespace {

class Comparer {
 public:
  Comparer(const StreamPlan& plan, const Solver& x, const Solver& y) : plan_(&plan), x_(&x), y_(&y), next_(plan.from) {}

  void work() {
    try {
      while (const std::optional<std::uint64_t> number = take()) {
        Case pair = plan_->make(*number);
        std::optional<std::string> sentence = difference(pair, *x_, *y_);
        const std::lock_guard lock(mutex_);
        if (sentence && (!first_ || *number < first_->number)) first_ = {*number, std::move(pair), *std::move(sentence)};
        ++done_;
        if (plan_->report) plan_->report(done_);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  StreamResult result() {
    if (error_) std::rethrow_exception(error_);
    return {first_ ? first_->number : next_, std::move(first_)};
  }

 private:
  std::optional<std::uint64_t> take() {
    const std::lock_guard lock(mutex_);
    const bool ended = plan_->count && next_ - plan_->from >= *plan_->count;
    if (ended || first_ || error_ || (plan_->stop && plan_->stop())) return std::nullopt;
    return next_++;
  }

  const StreamPlan* plan_;
  const Solver *x_, *y_;
  std::mutex mutex_;
  std::uint64_t next_, done_ = 0;
  std::optional<StreamDifference> first_;
  std::exception_ptr error_;
};

}  // namespace

StreamResult compare_stream(const StreamPlan& plan, const Solver& x, const Solver& y) {
  Comparer comparer(plan, x, y);
  std::vector<std::thread> others;
  for (unsigned i = 1; i < plan.jobs; ++i) others.emplace_back([&comparer] { comparer.work(); });
  comparer.work();
  for (std::thread& other : others) other.join();
  return comparer.result();
}

}  // namespace fathom::harness
