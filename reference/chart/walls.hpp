// SPDX-License-Identifier: GPL-3.0-or-later
// The walls through the nodes of both colours, sorted. For make_charts alone.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom::chart {

/// Fills in the walls, and in wall_of their ids, for the nodes whose wall_of is not none. Sorts exactly, in O(N log N); where abscissae
/// are well apart, with one predicate a wall.
void raise_walls(const kernels::PerturbedKernel& kernel, Charts& charts);

}  // namespace fathom::chart
