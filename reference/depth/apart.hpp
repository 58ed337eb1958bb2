// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on a lattice.
// Output  where O lies; for bodies that do not penetrate that is the answer.                [AGHRS, section 2.2, step before the algorithm]
#pragma once

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom {

/// Whether the bodies are flat; extreme points are not counted.
BodyFacts facts_of(const PlacedPair& pair);

/// The touch or the distance into `depth.outcome`. Returns false if the bodies penetrate. `checked`: validates what it finds.
[[nodiscard]] bool answer_apart(Context& context, const PlacedPair& pair, bool checked, Depth& depth);

/// The hulls of both bodies, which become part of the facts and the counters.
struct Hulls {
  Polytope a, b;
};
Hulls hulls_of(Context& context, const PlacedPair& pair, bool checked, BodyFacts& facts);

}  // namespace fathom
