// SPDX-License-Identifier: GPL-3.0-or-later
// What searches ask about the nodes and arcs of a chart: the predicates of kernels/ with the arcs oriented from left to right. No answer is
// zero.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom {

/// Positive: the node lies above the line of the arc. Not for an end of the arc.
Sign node_above_arc(const PerturbedKernel& kernel, const Charts& charts, Colour of_node, NodeId node, Colour of_arc, const ChartArc& arc);
/// Positive: arc e lies above arc f on the wall.
Sign above_on_wall(const PerturbedKernel& kernel, const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f,
                   const Wall& wall);
/// Positive: arc e lies above arc f far to the left.
Sign above_far_left(const PerturbedKernel& kernel, const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f);
/// Positive: e lies above f over their common x-range. Both are arcs of one colour whose x-ranges overlap in more than a point: they do not
/// cross, so the later of the left ends decides; if they share it, the earlier of the right ends.        [degree 3, no wall needed]
Sign above_same_colour(const PerturbedKernel& kernel, const Charts& charts, Colour colour, const ChartArc& e, const ChartArc& f);

}  // namespace fathom
