// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/parallel.hpp"

#include <exception>
#include <new>
#include <system_error>
#include <thread>

namespace fathom::kernels {
namespace {

// An allocator may want a large block for a new thread: ask first.
bool has_memory() {
  void* const block = ::operator new(1, std::nothrow);
  ::operator delete(block);
  return block != nullptr;
}

std::exception_ptr error_of(const std::function<void(Context&)>& work, Context& context) {
  try {
    work(context);
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace

void run_both(bool worth_it, Context& context, const std::function<void(Context&)>& first,
              const std::function<void(Context&)>& second) {
  Context worker = context.worker();
  std::exception_ptr error_of_second;
  bool done = false;
  std::thread thread;
  if (worth_it) {
    try {
      thread = std::thread([&] {
        if (!has_memory()) return;
        done = true;
        error_of_second = error_of(second, worker);
      });
    } catch (const std::system_error&) {  // no thread is available
    }
  }
  if (!thread.joinable()) {
    first(context);
    second(context);
    return;
  }
  const std::exception_ptr error = error_of(first, context);
  thread.join();
  context.join(worker);
  if (error) std::rethrow_exception(error);
  if (!done) return second(context);
  if (error_of_second) std::rethrow_exception(error_of_second);
}

}  // namespace fathom::kernels
