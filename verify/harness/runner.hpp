// SPDX-License-Identifier: GPL-3.0-or-later
// Many cases through several examiners at once.                                                        [docs/certify.md]
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// What one thread works with.
struct Worker {
  ExamineInUnit examine;
  std::function<void()> finish;  ///< called in the same thread when there is no next case; may be empty
};

/// Where a run gets its work and where its results go. No two threads call these at once, except `known`, and the workers, each of which
/// stays in one thread.
struct RunPlan {
  unsigned jobs = 1;
  std::vector<std::string> variants;  ///< symmetries that each case is put through as well, by name
  NumberFormat format = {};
  std::optional<mpq_class> fit = {};  ///< the size that cases are brought to; see exponent_to_fit
  std::set<std::string> shapes = {};  ///< that the subject takes by name
  Tolerance tolerance = {};

  std::function<std::optional<Case>()> next;  ///< returns nullopt after the last one
  std::function<Worker()> worker;             ///< called once in each thread
  /// The outcome that an earlier run found, or null.
  std::function<const Outcome*(const std::string& id, const std::string& variant, const std::string& digest)> known;
  /// One outcome; `seen` is the case, or its variant, as the subject saw it, and `original` the case.
  std::function<void(const Case& original, const Case& seen, const Outcome& outcome, bool known)> found;
  /// Hears of a case without an outcome, and of what its examiner threw. Rethrows that to end the run.
  std::function<void(const Case& pair, const std::exception_ptr& error)> fault;
  /// A variant that has no exact form.
  std::function<void(const Case& pair, const std::string& sentence)> left_out;
};

/// Works until there is no next case; the calling thread is one of the workers. The first exception of any callback ends all workers
/// once they have finished their cases, and is rethrown.
void run(const RunPlan& plan);

}  // namespace fathom::harness
