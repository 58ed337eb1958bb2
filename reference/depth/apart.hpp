// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on a lattice.
// Output  where O lies; for bodies that do not penetrate this is the answer.                [AGHRS, section 2.2, step before the algorithm]
#pragma once

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom {

/// Returns whether the bodies are flat; does not count extreme points.
BodyFacts facts_of(const PlacedPair& pair);

/// Sets `depth.outcome` to the touch or the distance. Returns false if the bodies penetrate. If `checked`, validates what it finds.
[[nodiscard]] bool answer_apart(Context& context, const PlacedPair& pair, bool checked, Depth& depth);

/// The hulls of both bodies.
struct Hulls {
  Polytope a, b;
};
/// Computes the hulls; sets the counts of extreme points in `facts`, and the counters. If `checked`, validates the hulls.
Hulls hulls_of(Context& context, const PlacedPair& pair, bool checked, BodyFacts& facts);

}  // namespace fathom
