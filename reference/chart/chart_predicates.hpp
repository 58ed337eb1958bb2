// SPDX-License-Identifier: GPL-3.0-or-later
// What searches ask about the nodes and arcs of a chart: the predicates of kernels/ with the arcs oriented from left to right. No answer is
// zero.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom::chart {

/// Positive: the node lies above the line of the arc. Not for an end of the arc.
kernels::Sign node_above_arc(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_node, gaussian::NodeId node,
                             gaussian::Colour of_arc, const ChartArc& arc);
/// Positive: arc e lies above arc f on the wall.
kernels::Sign above_on_wall(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e, const ChartArc& e,
                            gaussian::Colour of_f, const ChartArc& f, const Wall& wall);
/// Positive: arc e lies above arc f far to the left.
kernels::Sign above_far_left(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e, const ChartArc& e,
                             gaussian::Colour of_f, const ChartArc& f);
/// Positive: e lies above f over their common x-range. Both are arcs of one colour whose x-ranges overlap in more than a point: they do not
/// cross, so the later of the left ends decides; if they share it, the earlier of the right ends.        [degree 3, no wall needed]
kernels::Sign above_same_colour(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour colour, const ChartArc& e,
                                const ChartArc& f);

}  // namespace fathom::chart
