// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/context.hpp"

#include <array>
#include <exception>
#include <new>
#include <system_error>
#include <thread>

namespace fathom::kernels {
namespace {

/// A counter of a run by stage and name; those of a stage follow each other.
struct CounterOfStage {
  std::string_view stage, name;
  std::uint64_t Counters::*value;
};

constexpr std::array counters_of_stages = std::to_array<CounterOfStage>({
    {"hulls", "vertices_a", &Counters::vertices_a},
    {"hulls", "vertices_b", &Counters::vertices_b},
    {"hulls", "edges_a", &Counters::edges_a},
    {"hulls", "edges_b", &Counters::edges_b},
    {"hulls", "facets_a", &Counters::facets_a},
    {"hulls", "facets_b", &Counters::facets_b},
    {"position", "scans", &Counters::scans},
    {"expanding polytope", "expansions", &Counters::expansions},
    {"expanding polytope", "inner_facets", &Counters::inner_facets},
    {"supports", "support_calls", &Counters::support_calls},
    {"vertex-facet pairs", "vertex_facet_pairs", &Counters::vertex_facet_pairs},
    {"canonical subsets", "canonical_pairs", &Counters::canonical_pairs},
    {"canonical subsets", "sum_a", &Counters::sum_a},
    {"canonical subsets", "sum_b", &Counters::sum_b},
    {"canonical subsets", "crossings", &Counters::crossings},
    {"closest lines", "pairs_evaluated", &Counters::pairs_evaluated},
    {"closest lines", "pairs_exact", &Counters::pairs_exact},
    {"closest lines", "grids_cut", &Counters::grids_cut},
    {"closest lines", "cells", &Counters::cells},
    {"closest lines", "block_tests", &Counters::block_tests},
    {"closest lines", "vertex_clears", &Counters::vertex_clears},
    {"closest lines", "frame_tests", &Counters::frame_tests},
    {"closest lines", "frame_clears", &Counters::frame_clears},
    {"closest lines", "wide_tests", &Counters::wide_tests},
    {"closest lines", "wide_clears", &Counters::wide_clears},
    {"closest lines", "offset_blocks", &Counters::offset_blocks},
    {"closest lines", "offset_pairs", &Counters::offset_pairs},
    {"closest lines", "quota_checks", &Counters::quota_checks},
    {"closest lines", "quota_refinements", &Counters::quota_refinements},
    {"closest lines", "few_cells", &Counters::few_cells},
    {"closest lines", "seed", &Counters::seed},
    {"rays", "rays", &Counters::rays},
    {"rays", "facets_visited", &Counters::facets_visited},
});

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
}  // namespace fathom::kernels

namespace fathom {

PredicateCounts operator-(const PredicateCounts& now, const PredicateCounts& before) {
  PredicateCounts result;
  for (std::size_t i = 0; i < now.size(); ++i) {
    result[i] = {now[i].calls - before[i].calls, now[i].exact - before[i].exact, now[i].zero - before[i].zero, {}};
    for (const auto& [monomial, count] : now[i].decided) {
      const auto old = before[i].decided.find(monomial);
      const std::uint64_t since = count - (old == before[i].decided.end() ? 0 : old->second);
      if (since > 0) result[i].decided.emplace(monomial, since);
    }
  }
  return result;
}

PredicateCounts& operator+=(PredicateCounts& sum, const PredicateCounts& more) {
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i].calls += more[i].calls;
    sum[i].exact += more[i].exact;
    sum[i].zero += more[i].zero;
    for (const auto& [monomial, count] : more[i].decided) sum[i].decided[monomial] += count;
  }
  return sum;
}

Counters& operator+=(Counters& sum, const Counters& more) {
  for (const kernels::CounterOfStage& counter : kernels::counters_of_stages)
    if (counter.value != &Counters::seed) sum.*counter.value += more.*counter.value;
  sum.predicates += more.predicates;
  return sum;
}

}  // namespace fathom

namespace fathom::kernels {

std::vector<StageCounts> counts_by_stage(const Counters& counters) {
  std::vector<StageCounts> result;
  for (const CounterOfStage& counter : counters_of_stages) {
    if (result.empty() || result.back().stage != counter.stage) result.push_back({counter.stage, {}});
    result.back().counts.push_back({counter.name, counters.*counter.value});
  }
  return result;
}

void Context::report(std::string_view stage, double share) {
  if (monitor_ != nullptr) monitor_->report(stage, share);
  check();
}

void Context::check() {
  if (monitor_ != nullptr && monitor_->stopped()) *stopped_ = true;
  if (*stopped_) throw Interrupted();
}

Context Context::worker() const {
  Context worker;
  worker.stopped_ = stopped_;
  return worker;
}

void Context::join(const Context& worker) { counters += worker.counters; }

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
