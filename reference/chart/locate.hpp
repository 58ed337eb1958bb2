// SPDX-License-Identifier: GPL-3.0-or-later
// The places of one colour's nodes, and of its arcs' ends, in the other colour's diagram. For make_charts alone.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom::chart {

/// Fills in place_of for the nodes of a colour, by a plane sweep over all walls and the other colour's arcs, which must be in height
/// order. O((m + n) log(m + n)) steps; each node asks at most about as many predicates as the logarithm of the arcs over its abscissa.
void locate_nodes(const kernels::PerturbedKernel& kernel, Charts& charts, gaussian::Colour colour);

/// Fills in the heights of all arcs' ends: from the places of the nodes, and at infinity by merging both colours' lists. Linear.
void locate_ends(const kernels::PerturbedKernel& kernel, Charts& charts);

}  // namespace fathom::chart
