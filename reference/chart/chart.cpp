// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

#include <algorithm>

#include "kernels/filter.hpp"

namespace fathom {
namespace {

constexpr std::array<Colour, 2> both_colours{Colour::a, Colour::b};

// Marks the nodes of this hemisphere with 0. False when a node lies on the equator.
bool find_nodes(const GaussianDiagram& diagram, const Frame& frame, std::vector<std::uint32_t>& wall_of) {
  wall_of.assign(diagram.nodes.size(), at_infinity);
  for (std::size_t i = 0; i < diagram.nodes.size(); ++i) {
    const int side = side_of_equator(diagram.nodes[i], frame.z);
    if (side == 0) return false;
    if (side > 0) wall_of[i] = 0;
  }
  return true;
}

// False when an arc's circle passes through v.
bool find_arcs(const GaussianDiagram& diagram, const Frame& frame, const std::vector<std::uint32_t>& wall_of, std::vector<ChartArc>& arcs) {
  const auto end = [&](std::uint32_t node) { return node != no_facet && wall_of[node] != at_infinity ? node : at_infinity; };
  for (std::uint32_t i = 0; i < diagram.arcs.size(); ++i) {
    const Arc& arc = diagram.arcs[i];
    const int rightward = side_of_arc(frame.v, arc.circle);
    if (rightward == 0) return false;
    const ChartArc part = rightward > 0 ? ChartArc{i, end(arc.from), end(arc.to), false} : ChartArc{i, end(arc.to), end(arc.from), true};
    // An arc of rank 2 or 3 with no end here lies in the other hemisphere: it is no longer than pi.
    if (diagram.rank == 1 || part.left != at_infinity || part.right != at_infinity) arcs.push_back(part);
  }
  return true;
}

// False when two different directions share an x-coordinate.
bool raise_walls(Charts& charts) {
  for (const Colour c : both_colours) {
    const std::vector<std::uint32_t>& wall_of = charts.wall_of[static_cast<std::size_t>(c)];
    for (std::uint32_t i = 0; i < wall_of.size(); ++i) {
      if (wall_of[i] != at_infinity) charts.walls.push_back({c, i});
    }
  }
  const auto direction = [&](const Charts::Wall& w) -> const Direction& { return charts.node(w.colour, w.node); };
  std::ranges::sort(charts.walls, [&](const Charts::Wall& s, const Charts::Wall& t) {
    return x_order(direction(s), direction(t), charts.frame.v) > 0;
  });
  std::size_t count = 0;
  for (std::size_t i = 0; i < charts.walls.size(); ++i) {
    const Charts::Wall wall = charts.walls[i];
    if (count > 0 && x_order(direction(charts.walls[count - 1]), direction(wall), charts.frame.v) == 0) {
      if (!same_direction(direction(charts.walls[count - 1]).exact(), direction(wall).exact())) return false;
    } else {
      charts.walls[count++] = wall;
    }
    charts.wall_of[static_cast<std::size_t>(wall.colour)][wall.node] = static_cast<std::uint32_t>(count - 1);
  }
  charts.walls.resize(count);
  return true;
}

}  // namespace

std::uint32_t Charts::vertex_above(Colour c, const ChartArc& arc) const {
  const Arc& whole = diagram(c).arcs[arc.arc];
  return arc.flipped ? whole.below : whole.above;
}

std::uint32_t Charts::vertex_below(Colour c, const ChartArc& arc) const {
  const Arc& whole = diagram(c).arcs[arc.arc];
  return arc.flipped ? whole.above : whole.below;
}

std::optional<Charts> make_charts(const GaussianDiagram& minus_a, const GaussianDiagram& b, const Frame& frame) {
  Charts charts{frame, {&minus_a, &b}, {}, {}, {}};
  for (std::size_t c = 0; c < 2; ++c) {
    if (!find_nodes(*charts.diagrams[c], frame, charts.wall_of[c])) return std::nullopt;
    if (!find_arcs(*charts.diagrams[c], frame, charts.wall_of[c], charts.arcs[c])) return std::nullopt;
  }
  if (!raise_walls(charts)) return std::nullopt;
  return charts;
}

Report validate(const Charts& charts) {
  Report report;
  const auto direction = [&](const Charts::Wall& w) -> const Direction& { return charts.node(w.colour, w.node); };
  for (std::size_t i = 1; i < charts.walls.size(); ++i) {
    report.expect(x_order(direction(charts.walls[i - 1]), direction(charts.walls[i]), charts.frame.v) > 0,
                  "wall " + std::to_string(i) + " is not right of the one before");
  }
  for (const Colour c : both_colours) {
    const auto here = [&](std::uint32_t node) { return side_of_equator(charts.node(c, node), charts.frame.z) > 0; };
    for (const ChartArc& part : charts.arcs_of(c)) {
      const std::string name = "arc " + std::to_string(part.arc) + ": ";
      const Arc& arc = charts.diagram(c).arcs[part.arc];
      const auto [left, right] = part.flipped ? std::pair(arc.to, arc.from) : std::pair(arc.from, arc.to);
      report.expect((side_of_arc(charts.frame.v, arc.circle) > 0) != part.flipped, name + "flipped against its circle");
      report.expect(part.left == at_infinity ? left == no_facet || !here(left) : part.left == left && here(left), name + "left end");
      report.expect(part.right == at_infinity ? right == no_facet || !here(right) : part.right == right && here(right), name + "right end");
      if (part.left != at_infinity && part.right != at_infinity) {
        report.expect(charts.wall(c, part.left) < charts.wall(c, part.right), name + "does not run from left to right");
      }
    }
  }
  return report;
}

}  // namespace fathom
