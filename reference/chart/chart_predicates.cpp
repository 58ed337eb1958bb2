// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart_predicates.hpp"

namespace fathom {
namespace {

Sign orientation(const ChartArc& arc) { return arc.flipped ? Sign::negative : Sign::positive; }

}  // namespace

Sign node_above_arc(const PerturbedKernel& kernel, const Charts& charts, Colour of_node, NodeId node, Colour of_arc, const ChartArc& arc) {
  return orientation(arc) * kernel.side_of_arc(charts.of[of_node].node(node), charts.of[of_arc].circle(arc));
}

Sign above_on_wall(const PerturbedKernel& kernel, const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f,
                   const Wall& wall) {
  return orientation(e) * orientation(f) *
         kernel.order_on_vertical(charts.of[of_e].circle(e), charts.of[of_f].circle(f), charts.node(wall), charts.frame.v);
}

Sign above_far_left(const PerturbedKernel& kernel, const Charts& charts, Colour of_e, const ChartArc& e, Colour of_f, const ChartArc& f) {
  return orientation(e) * orientation(f) * kernel.order_at_infinity(charts.of[of_e].circle(e), charts.of[of_f].circle(f), charts.frame.z);
}

Sign above_same_colour(const PerturbedKernel& kernel, const Charts& charts, Colour colour, const ChartArc& e, const ChartArc& f) {
  const auto wall = [&](NodeId node) { return charts.of[colour].wall_of[node]; };
  // An end that only one of them has lies off the other, since arcs of one diagram meet in common ends only.
  if (e.left != f.left) {
    const bool later = f.left == at_infinity || (e.left != at_infinity && wall(e.left) > wall(f.left));
    return later ? node_above_arc(kernel, charts, colour, e.left, colour, f) : -node_above_arc(kernel, charts, colour, f.left, colour, e);
  }
  if (e.right != f.right) {
    const bool earlier = f.right == at_infinity || (e.right != at_infinity && wall(e.right) < wall(f.right));
    return earlier ? node_above_arc(kernel, charts, colour, e.right, colour, f)
                   : -node_above_arc(kernel, charts, colour, f.right, colour, e);
  }
  // Both run from one node to the same infinity, or from it to one node: the order there is that of their slopes.
  const Sign far_left = above_far_left(kernel, charts, colour, e, colour, f);
  return e.left == at_infinity ? far_left : -far_left;
}

}  // namespace fathom
