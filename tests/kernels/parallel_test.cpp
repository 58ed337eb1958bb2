// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "kernels/predicates/filter.hpp"

namespace {
std::atomic<std::thread::id> fed;  // if set, no other thread gets memory that it asks for gently
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  const std::thread::id only = fed;
  return only == std::thread::id() || only == std::this_thread::get_id() ? ::operator new(size) : nullptr;
}

namespace fathom {
namespace {

const Direction x(Vector{1, 0, 0}), y(Vector{0, 1, 0}), diagonal(Vector{1, 1, 0});

void ask(int times) {
  for (int i = 0; i < times; ++i) side_of_arc(x, diagonal);
  side_of_arc(x, y);                                                          // zero
  perturbed_side_of_arc({}, Direction(Vector{1, 0, 0}, Role::node_of_a), y);  // decided by an infinitesimal
}

TEST(RunBoth, RunsBothAndSumsTheirCounts) {
  PredicateCounts counts[2];
  for (const bool worth_it : {false, true}) {
    const PredicateCounts before = predicate_counts();
    std::thread::id first, second;
    run_both(
        worth_it,
        [&] {
          first = std::this_thread::get_id();
          ask(5);
        },
        [&] {
          second = std::this_thread::get_id();
          ask(7);
        });
    EXPECT_EQ(first, std::this_thread::get_id());
    EXPECT_EQ(first != second, worth_it);
    counts[worth_it] = predicate_counts() - before;
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
  run_both(
      true, [] {},
      [&] {
        second = std::this_thread::get_id();
        ++calls;
      });
  fed = std::thread::id();
  EXPECT_EQ(second, std::this_thread::get_id());
  EXPECT_EQ(calls, 1);
}

TEST(RunBoth, MayBeNested) {
  const PredicateCounts before = predicate_counts();
  const auto both = [] {
    run_both(
        true, [] { ask(1); }, [] { ask(1); });
  };
  run_both(true, both, both);
  EXPECT_EQ((predicate_counts() - before)[static_cast<std::size_t>(Predicate::side_of_arc)].calls, 12U);
}

TEST(RunBoth, PassesExceptionsOnWhenBothHaveEnded) {
  const auto thrown = [](bool worth_it, bool by_first, bool by_second) {
    bool ended = false;
    const auto work = [](bool throws, const char* name) {
      if (throws) throw std::runtime_error(name);
    };
    std::string what;
    try {
      run_both(
          worth_it, [&] { work(by_first, "first"); },
          [&] {
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
}  // namespace fathom
