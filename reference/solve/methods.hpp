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

}  // namespace fathom::solve
