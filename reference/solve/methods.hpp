// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on one lattice, and the options of penetration_depth.
// Output  the answer by the method that they ask for.
#pragma once

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/placed_pair.hpp"

namespace fathom::solve {

/// Resets the counters of `context` first.
Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options);

/// Whether an expanding polytope is to be tried first; and how many points it may take then, for this number of input points.
bool expands_first(const Options& options);
std::size_t expansion_budget(const Options& options, std::size_t input_points);

/// The exact method's answer.
Depth exact_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options);

}  // namespace fathom::solve
