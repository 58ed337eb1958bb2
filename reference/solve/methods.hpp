// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on one lattice, and the options of penetration_depth.
// Output  the answer by the method that they ask for.
#pragma once

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/placed_pair.hpp"

namespace fathom {

/// Resets the counters of `context` first.
Depth depth_by_method(Context& context, const PlacedPair& pair, const Options& options);

}  // namespace fathom
