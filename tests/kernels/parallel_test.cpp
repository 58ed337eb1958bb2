// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "kernels/predicates/perturbed_kernel.hpp"

namespace {
std::atomic<std::thread::id> fed;  // if set, no other thread gets memory that it asks for gently
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  const std::thread::id only = fed;
  return only == std::thread::id() || only == std::this_thread::get_id() ? ::operator new(size) : nullptr;
}

namespace fathom::kernels {
namespace {

const Direction x(Vector{1, 0, 0}), y(Vector{0, 1, 0}), diagonal(Vector{1, 1, 0});

void ask(Context& context, int times) {
  const Perturbation perturbation;
  const PerturbedKernel kernel(perturbation, context.counters.predicates);
  for (int i = 0; i < times; ++i) std::ignore = kernel.side_of_arc(x, diagonal);
  std::ignore = kernel.unperturbed().side_of_arc(x, y);                        // zero
  std::ignore = kernel.side_of_arc(Direction(x.exact(), Role::node_of_a), y);  // decided by an infinitesimal
}

TEST(RunBoth, RunsBothAndSumsTheirCounts) {
  PredicateCounts counts[2];
  for (const bool worth_it : {false, true}) {
    Context context;
    std::thread::id first, second;
    run_both(
        worth_it, context,
        [&](Context& own) {
          first = std::this_thread::get_id();
          EXPECT_EQ(&own, &context);
          ask(own, 5);
        },
        [&](Context& own) {
          second = std::this_thread::get_id();
          EXPECT_EQ(&own != &context, worth_it);
          ask(own, 7);
        });
    EXPECT_EQ(first, std::this_thread::get_id());
    EXPECT_EQ(first != second, worth_it);
    counts[worth_it] = context.counters.predicates;
  }
  const auto id = static_cast<std::size_t>(Predicate::side_of_arc);
  for (const PredicateCounts& c : counts) {
    EXPECT_EQ(c[id].calls, 16U);
    EXPECT_EQ(c[id].zero, 4U);
    ASSERT_EQ(c[id].decided.size(), 1U);
    EXPECT_EQ(c[id].decided.begin()->second, 2U);
  }
}

TEST(RunBoth, AThreadWithoutMemoryLeavesItsWorkToTheCaller) {
  std::thread::id second;
  int calls = 0;
  fed = std::this_thread::get_id();
  Context context;
  run_both(
      true, context, [](Context&) {},
      [&](Context&) {
        second = std::this_thread::get_id();
        ++calls;
      });
  fed = std::thread::id();
  EXPECT_EQ(second, std::this_thread::get_id());
  EXPECT_EQ(calls, 1);
}

TEST(RunBoth, MayBeNested) {
  Context context;
  const auto once = [](Context& own) { ask(own, 1); };
  const auto both = [&](Context& own) { run_both(true, own, once, once); };
  run_both(true, context, both, both);
  EXPECT_EQ(context.counters.predicates[static_cast<std::size_t>(Predicate::side_of_arc)].calls, 12U);
}

TEST(RunBoth, PassesExceptionsOnWhenBothHaveEnded) {
  const auto thrown = [](bool worth_it, bool by_first, bool by_second) {
    bool ended = false;
    const auto work = [](bool throws, const char* name) {
      if (throws) throw std::runtime_error(name);
    };
    std::string what;
    try {
      Context context;
      run_both(
          worth_it, context, [&](Context&) { work(by_first, "first"); },
          [&](Context&) {
            ended = true;
            work(by_second, "second");
          });
    } catch (const std::runtime_error& e) {
      what = e.what();
    }
    EXPECT_TRUE(ended || (!worth_it && by_first));
    return what;
  };
  for (const bool worth_it : {false, true}) {
    EXPECT_EQ(thrown(worth_it, false, false), "");
    EXPECT_EQ(thrown(worth_it, true, false), "first");
    EXPECT_EQ(thrown(worth_it, false, true), "second");
    EXPECT_EQ(thrown(worth_it, true, true), "first");
  }
}

}  // namespace
}  // namespace fathom::kernels
