// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what a run could judge. A subject whose answers have no depth, or misspell it, passes everything: coverage shows that.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// How many answers held each field and were judged by it.
struct Coverage {
  std::size_t cases = 0;                              ///< outcomes of any kind
  std::size_t overlap = 0;                            ///< cases with an answer, whose classification was judged
  std::size_t overlapping = 0;                        ///< answers that say that the bodies overlap
  std::size_t depth = 0, direction = 0, witness = 0;  ///< answers with the field; without a depth the others are not judged
  std::size_t contacts = 0;                           ///< the same
  std::size_t distance = 0;                           ///< answers that say that they are apart, with a distance
  std::size_t without_depth = 0;                      ///< answers whose direction, witness points or contacts came without one

  void add(const Outcome& outcome);
  void add(const Coverage& other);
};

/// "overlap in 9 of 9 cases", "depth in 0 of the 9 said to overlap", "direction in 0", "witness in 0"; the first alone if none is.
std::vector<std::string> coverage_entries(const Coverage& coverage);

/// A sentence if answers say that bodies overlap and none has a depth; else empty.
std::string coverage_warning(const Coverage& coverage);

}  // namespace fathom::harness
