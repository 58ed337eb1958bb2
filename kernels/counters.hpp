// SPDX-License-Identifier: GPL-3.0-or-later
// Sums and differences of counts. They are in the namespace of their operands, where argument-dependent lookup finds them.
#pragma once

#include "fathom/counters.hpp"

namespace fathom {

/// Returns what was counted since `before` was copied.
PredicateCounts operator-(const PredicateCounts& now, const PredicateCounts& before);
PredicateCounts& operator+=(PredicateCounts& sum, const PredicateCounts& more);

/// Adds the counts of `more`; the seed stays.
Counters& operator+=(Counters& sum, const Counters& more);

}  // namespace fathom
