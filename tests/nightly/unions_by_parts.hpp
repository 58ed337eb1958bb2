// SPDX-License-Identifier: GPL-3.0-or-later
// A second way to find the answer about unions, which shares as little as possible with the search
// for it: pairs of pieces by AGHRS's pipeline, and of unions that penetrate the whole, if pieces
// fill a convex body, or every point where planes meet.
#pragma once

#include "verify/harness/two_ways.hpp"

namespace fathom::nightly {

/// How the depth of unions that penetrate is found.
enum class Part {
  none,      ///< they do not: the pairs of pieces say all
  whole,     ///< both are convex, as pieces that do not overlap fill their hulls: the depth is that of the hulls
  planes,    ///< by the naive twin: every point where planes meet
  mirrored,  ///< for want of a better one by the search itself, with the bodies exchanged, moved and scaled: its proof
             ///< is checked elsewhere
};

/// `part`, if not null, becomes the way that was taken.
harness::UnionsFound unions_by_parts(const Case& pair, Monitor* monitor, Part* part = nullptr);

/// AGHRS's pipeline; of unions the answer by parts.
harness::Solver second_solver();

}  // namespace fathom::nightly
