// SPDX-License-Identifier: GPL-3.0-or-later
// The order "above" of a colour's arcs, as one list. For make_charts alone.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom::chart {

/// Puts the arcs of a chart into height order: where two overlap in an x-interval, the higher one comes later. It asks no predicate: an
/// arc leads from the face below it to the face above it, and the faces are sorted topologically. Linear, not recursive. Throws
/// std::logic_error if the arcs lead around in a circle: then they are not a diagram.                     [proofs/chart.md, "Height order"]
void sort_by_height(ColourChart& chart);

}  // namespace fathom::chart
