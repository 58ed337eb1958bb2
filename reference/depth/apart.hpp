// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on a lattice.
// Output  where O lies; for bodies that do not penetrate this is the answer.                [AGHRS, section 2.2, step before the algorithm]
#pragma once

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {

/// Returns whether the bodies are flat; does not count extreme points.
BodyFacts facts_of(const polytope::PlacedPair& pair);

/// Sets `depth.outcome` to the touch or the distance. Returns false if the bodies penetrate. If `checked`, validates what it finds.
[[nodiscard]] bool answer_apart(kernels::Context& context, const polytope::PlacedPair& pair, bool checked, Depth& depth);

/// The hulls of both bodies.
struct Hulls {
  polytope::Polytope a, b;
};
/// Computes the hulls; sets the counts of extreme points in `facts`, and the counters. If `checked`, validates the hulls.
Hulls hulls_of(kernels::Context& context, const polytope::PlacedPair& pair, bool checked, BodyFacts& facts);

}  // namespace fathom::depth
