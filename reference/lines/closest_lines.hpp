// SPDX-License-Identifier: GPL-3.0-or-later
// Input   canonical pairs (A_i, B_i), and the lines through the bodies' edges.
// Output  the nearest of all planes aff(e (+) (-e')): the closest pairs of lines in L_i x L'_i, all ties kept.        [AGHRS, Lemma 2.2]
// Engines cutting, sampled, naive: one answer. The naive one looks at every pair, through a double filter that leaves near ties to exact
//         arithmetic; the others look at small pairs so, and ask of each large one whether it can beat the best at all.
#pragma once

#include <functional>

#include "kernels/counters.hpp"
#include "kernels/nearest.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/lines/edge_lines.hpp"
#include "reference/lines/engines.hpp"

namespace fathom {

struct ClosestLinesOptions {
  ClosestLines engine = ClosestLines::cutting;
  /// Of the random order of subproblems. Only the work depends on it.
  std::uint64_t seed = 1;
  /// Called now and then with the share done, in [0, 1]; false stops early.
  std::function<bool(double)> keep_going = {};
  /// Canonical pairs of so few crossings are scanned, unless they are cleared as a whole.
  std::uint64_t scanned = 2048;
  CuttingSize cutting_size = {};
  SampledSize sampled_size = {};
};

/// Offers the nearest planes of all canonical pairs to `nearest`, which holds one global best; what it already holds helps. Returns false if
/// it was stopped.
bool closest_lines(const CanonicalSubsets& subsets, const Charts& charts, const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest,
                   Counters& counters, const ClosestLinesOptions& options = {});

/// C4 as a sign: for each pair of each canonical pair of the hemisphere with pole z, <p_e - p_e', w> > 0 for the normal w of both edges
/// with <w,z> > 0. Parallel edges, and crossings on the equator, have no such w and are passed over. O(sum |A_i| |B_i|).       [AGHRS, Lemma 2.3]
[[nodiscard]] Report validate_separation(const CanonicalSubsets& subsets, const EdgeLines& a, const EdgeLines& b, const Vector& z);

}  // namespace fathom
