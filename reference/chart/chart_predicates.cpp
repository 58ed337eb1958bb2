// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

namespace fathom::chart {
namespace {

kernels::Sign orientation(const ChartArc& arc) { return arc.flipped ? kernels::Sign::negative : kernels::Sign::positive; }

}  // namespace

kernels::Sign node_above_arc(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_node, gaussian::NodeId node,
                             gaussian::Colour of_arc, const ChartArc& arc) {
  return orientation(arc) * kernel.side_of_arc(charts.of[of_node].node(node), charts.of[of_arc].circle(arc));
}

kernels::Sign above_on_wall(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e, const ChartArc& e,
                            gaussian::Colour of_f, const ChartArc& f, const Wall& wall) {
  return orientation(e) * orientation(f) *
         kernel.order_on_vertical(charts.of[of_e].circle(e), charts.of[of_f].circle(f), charts.node(wall), charts.frame.v);
}

kernels::Sign above_far_left(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour of_e, const ChartArc& e,
                             gaussian::Colour of_f, const ChartArc& f) {
  return orientation(e) * orientation(f) * kernel.order_at_infinity(charts.of[of_e].circle(e), charts.of[of_f].circle(f), charts.frame.z);
}

kernels::Sign above_same_colour(const kernels::PerturbedKernel& kernel, const Charts& charts, gaussian::Colour colour, const ChartArc& e,
                                const ChartArc& f) {
  const auto wall = [&](gaussian::NodeId node) { return charts.of[colour].wall_of[node]; };
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
  const kernels::Sign far_left = above_far_left(kernel, charts, colour, e, colour, f);
  return e.left == at_infinity ? far_left : -far_left;
}

}  // namespace fathom::chart
