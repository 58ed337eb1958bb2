// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/parallel.hpp"

#include <exception>
#include <system_error>
#include <thread>

#include "kernels/filter.hpp"

namespace fathom {
namespace {

// What became of work in another thread.
struct Outcome {
  PredicateCounts counts;
  std::exception_ptr error;
};

std::exception_ptr error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

void run_both(bool worth_it, const std::function<void()>& first, const std::function<void()>& second) {
  Outcome outcome;
  std::thread thread;
  if (worth_it) {
    try {
      thread = std::thread([&] {
        outcome.error = error_of(second);
        outcome.counts = predicate_counts();
      });
    } catch (const std::system_error&) {  // no thread to be had
    }
  }
  if (!thread.joinable()) {
    first();
    second();
    return;
  }
  const std::exception_ptr error = error_of(first);
  thread.join();
  predicate_counts() += outcome.counts;
  if (error) std::rethrow_exception(error);
  if (outcome.error) std::rethrow_exception(outcome.error);
}

}  // namespace fathom
