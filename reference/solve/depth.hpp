// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies as points, wherever these stand.
// Output  what penetration_depth says of them, and the lattice on which it found the answer.
#pragma once

#include <optional>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/positions.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::solve {

struct PlacedDepth {
  Depth depth;
  /// Both bodies on one lattice. Not set if it was a narrow one, as happens to bodies that penetrate; nor if the bodies' denominators share
  /// so little that deciding points gave the answer.
  std::optional<polytope::PlacedPair> pair;
};

/// Throws as penetration_depth does.
PlacedDepth placed_depth(kernels::Context& context, kernels::Positions a, kernels::Positions b, const Options& options);

}  // namespace fathom::solve
