// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/parallel.hpp"

#include <exception>
#include <new>
#include <system_error>
#include <thread>

#include "kernels/predicates/filter.hpp"

namespace fathom {
namespace {

// What became of work in another thread.
struct Outcome {
  PredicateCounts counts;
  std::exception_ptr error;
  bool done = false;
};

// An allocator may want a large block for a new thread, and glibc ends the process where a thread's counts get no memory: ask first.
bool has_memory() {
  void* const block = ::operator new(1, std::nothrow);
  ::operator delete(block);
  return block != nullptr;
}

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
        if (!has_memory()) return;
        outcome.done = true;
        outcome.error = error_of(second);
        const std::exception_ptr uncounted = error_of([&] { outcome.counts = predicate_counts(); });
        if (!outcome.error) outcome.error = uncounted;
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
  if (!outcome.done) return second();
  if (outcome.error) std::rethrow_exception(outcome.error);
}

}  // namespace fathom
