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

/// The failures of each verdict by index, worst first, of equals in order.
std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes);

}  // namespace fathom::harness
