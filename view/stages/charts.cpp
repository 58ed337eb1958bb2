// SPDX-License-Identifier: GPL-3.0-or-later
// Both hemispheres as charts, in longitude and latitude about v: walls stay vertical, and the hemisphere fits a square.
#include <cmath>

#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

double dot(const Place& p, const Place& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

Place cross(const Place& p, const Place& q) { return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}; }

std::optional<Index> end_of(gaussian::NodeId node) { return node == chart::at_infinity ? std::nullopt : std::optional(node.value); }

StagedDiagram diagram_in(const chart::ColourChart& chart, const std::vector<Place>& nodes, const Place& v, const Place& z) {
  StagedDiagram result;
  for (const chart::ChartArc& arc : chart.arcs) result.arcs.push_back({arc.arc.value, end_of(arc.left), end_of(arc.right)});
  const Place right = cross(v, z);
  for (const gaussian::NodeId i : chart.wall_of.ids()) {
    if (chart.wall_of[i].is_none()) continue;
    const Place& n = nodes[i.value];
    // Not asin, which loses half of the digits near v. Adding 0 turns -0 into 0.
    const double along = dot(n, right) + 0.0, ahead = dot(n, z) + 0.0;
    result.nodes.push_back({i.value, std::atan2(along, ahead), std::atan2(dot(n, v), std::hypot(along, ahead))});
  }
  return result;
}

}  // namespace

void add_charts(const StagesSource& subject, Stages& stages) {
  for (const chart::Hemisphere hemisphere : chart::both_hemispheres) {
    const chart::Charts& charts = subject.exact.charts[stages.charts.size()];
    StagedChart staged;
    staged.upper = hemisphere == chart::Hemisphere::upper;
    staged.v = unit(charts.frame.v.exact());
    staged.z = unit(charts.frame.z.exact());
    staged.a = diagram_in(charts.of.a, stages.a.nodes, staged.v, staged.z);
    staged.b = diagram_in(charts.of.b, stages.b.nodes, staged.v, staged.z);
    for (const chart::Wall& wall : charts.walls) staged.walls.push_back({wall.colour == gaussian::Colour::a, wall.node.value});
    stages.charts.push_back(std::move(staged));
  }
}

}  // namespace fathom::stages
