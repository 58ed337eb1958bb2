// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the canonical pairs (A_i, B_i) of one hemisphere, and its scene.
// Output  the nearest of all planes aff(e (+) (-e')): the closest pairs of lines in L_i x L'_i, all ties kept.        [AGHRS, Lemma 2.2]
// Engines cutting, sampled, naive: one answer. The naive one looks at every pair, through a double filter that leaves near ties to exact
//         arithmetic. The others scan small canonical pairs in this way, and ask of each large one whether it can beat the best at all.
#pragma once

#include "kernels/context.hpp"
#include "kernels/nearest.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/lines/line_scene.hpp"

namespace fathom::lines {

struct ClosestLinesOptions {
  ClosestLines engine = ClosestLines::cutting;
  /// Of the random order of subproblems. Only the work depends on it.
  std::uint64_t seed = 1;
  /// The part of the stage "closest lines" that this call is, for reports.
  double first_share = 0, last_share = 1;
  /// Canonical pairs with at most this many crossings are scanned, unless they are cleared as a whole.
  std::uint64_t scanned = 2048;
  CuttingSize cutting_size = {};
  SampledSize sampled_size = {};
  /// Gets what the search does; may be null.
  SearchTrace* trace = nullptr;
};

/// Offers the nearest planes of all canonical pairs to `nearest`, which holds one global best; what it already holds helps. Reports the
/// stage "closest lines".
void closest_lines(kernels::Context& context, const canonical::CanonicalSubsets& subsets, const LineScene& scene,
                   kernels::NearestPlanes& nearest, const ClosestLinesOptions& options = {});

/// C4 as a sign: for each pair of each canonical pair, <p_e - p_e', w> > 0 for the normal w of both edges with <w,z> > 0, z the pole.
/// Skips parallel edges, and crossings on the equator, which have no such w. O(sum |A_i| |B_i|).                    [AGHRS, Lemma 2.3]
[[nodiscard]] kernels::Report validate_separation(const canonical::CanonicalSubsets& subsets, const LineScene& scene);

}  // namespace fathom::lines
