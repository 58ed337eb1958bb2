// SPDX-License-Identifier: GPL-3.0-or-later
// Failures in the order in which they deserve attention.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// Larger is worse. Answers without a depth, and with one where there is none, have no relative error: they come first.
double badness(const Outcome& outcome);

/// The indices of the failures, worst first. Equals follow by id and variant, so that the order does not depend on which answer of a
/// parallel run came first.
std::vector<std::size_t> worst_first(std::span<const Outcome> outcomes);

/// The same of each verdict.
std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes);

}  // namespace fathom::harness
