// SPDX-License-Identifier: GPL-3.0-or-later
// The order "above" of a colour's arcs, as one list. For make_charts alone.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom {

/// Puts the arcs of a colour into height order: where two overlap in an x-interval, the higher one comes later. No predicate is asked:
/// an arc leads from the face below it to the face above it, and faces are sorted topologically. Linear, not recursive.
/// Throws std::logic_error when arcs lead around in a circle: then the diagram is none.             [proofs/chart.md, "Height order"]
void sort_by_height(Charts& charts, Colour colour);

}  // namespace fathom
