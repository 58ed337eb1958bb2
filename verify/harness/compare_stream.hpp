// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two ways, and a stream of cases by numbers.
// Output  the first case on which they differ, or up to where they agree.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "verify/harness/two_ways.hpp"

namespace fathom::harness {

struct StreamPlan {
  std::function<Case(std::uint64_t)> make;         ///< called from all threads
  std::uint64_t from = 0;                          ///< the first number
  std::optional<std::uint64_t> count;              ///< of cases; without end unless given
  unsigned jobs = 1;                               ///< threads; the caller's is one of them
  std::function<bool()> stop;                      ///< asked before each case: true ends the stream; from one thread at a time
  std::function<void(std::uint64_t done)> report;  ///< called after each case, from one thread at a time; may be empty
};

struct StreamDifference {
  std::uint64_t number;
  Case pair;
  std::string sentence;
};

struct StreamResult {
  std::uint64_t end = 0;                  ///< on the cases from `from` to before `end` the ways agree
  std::optional<StreamDifference> first;  ///< on case `end` they differ
};

/// Compares case after case until the stream ends, is stopped, or a difference is found. The result does not depend on the number of
/// threads, except on how far a stopped stream came. Throws what the ways throw that is no answer, as std::bad_alloc.
StreamResult compare_stream(const StreamPlan& plan, const Solver& x, const Solver& y);

}  // namespace fathom::harness
