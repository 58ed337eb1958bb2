// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/src/batch.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "python/src/watching.hpp"

namespace fathom::python {

std::vector<PairAnswer> answer_all(std::vector<std::pair<Body, Body>> pairs, const Question& question, unsigned threads, Monitor& monitor) {
  std::vector<std::optional<PairAnswer>> answers(pairs.size());
  std::atomic<std::size_t> next = 0, running = threads;
  std::atomic<bool> stop = false;
  std::mutex fault_lock;
  std::size_t first_fault = pairs.size();
  std::exception_ptr fault;
  const auto work = [&] {
    FlagMonitor flag(stop);
    for (std::size_t i = next++; i < pairs.size() && !stop; i = next++) {
      try {
        answers[i] = answer(std::move(pairs[i].first), std::move(pairs[i].second), question, flag);
      } catch (...) {
        const std::lock_guard lock(fault_lock);
        if (!stop || i < first_fault) {
          fault = std::current_exception();
          first_fault = i;
        }
        stop = true;
      }
    }
    --running;
  };
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < threads; ++i) workers.emplace_back(work);
  bool interrupted = false;
  while (running > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (!interrupted && monitor.stopped()) interrupted = stop = true;
  }
  for (std::thread& worker : workers) worker.join();
  if (interrupted) throw Interrupted();
  if (fault) std::rethrow_exception(fault);
  std::vector<PairAnswer> result;
  result.reserve(answers.size());
  for (std::optional<PairAnswer>& one : answers) result.push_back(*std::move(one));
  return result;
}

}  // namespace fathom::python
