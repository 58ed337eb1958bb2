// SPDX-License-Identifier: GPL-3.0-or-later
// Sums and differences of counts.
#pragma once

#include "fathom/counters.hpp"

namespace fathom {

/// What was counted since `before` was read.
PredicateCounts operator-(const PredicateCounts& now, const PredicateCounts& before);
PredicateCounts& operator+=(PredicateCounts& sum, const PredicateCounts& more);

/// Adds what was counted elsewhere; the seed stays.
Counters& operator+=(Counters& sum, const Counters& more);

}  // namespace fathom
