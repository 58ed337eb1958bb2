// SPDX-License-Identifier: GPL-3.0-or-later
// What searches ask about the nodes and arcs of a chart: the predicates of kernels/ with the arcs oriented from left to right. Each answer
// is 1 or -1, never 0.
#pragma once

#include "reference/chart/chart.hpp"

namespace fathom {

/// 1: the node lies above the line of the arc. Not for an end of the arc.
int node_above_arc(const Charts& charts, Colour of_node, NodeId node, Colour of_arc, const ChartArc& arc);
/// 1: arc e lies above arc f on the wall.
int above_on_wall(const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f, const Wall& wall);
/// 1: arc e lies above arc f far to the left.
int above_far_left(const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f);
/// 1: e lies above f over their common x-range. Both are arcs of one colour whose x-ranges overlap in more than a point: they do not
/// cross, so the later of the left ends decides; if they share it, the earlier of the right ends.        [degree 3, no wall needed]
int above_same_colour(const Charts& charts, Colour colour, const ChartArc& e, const ChartArc& f);

}  // namespace fathom
