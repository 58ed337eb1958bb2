// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

#include <algorithm>

#include "reference/chart/height_order.hpp"
#include "reference/chart/locate.hpp"
#include "reference/chart/walls.hpp"

namespace fathom {
namespace {

constexpr std::array<Colour, 2> both_colours{Colour::a, Colour::b};

// Marks the nodes of this hemisphere with 0.
void find_nodes(const PerturbedKernel& kernel, Charts& charts, Colour c) {
  const GaussianDiagram& diagram = charts.diagram(c);
  std::vector<std::uint32_t>& wall_of = charts.wall_of[static_cast<std::size_t>(c)];
  wall_of.assign(diagram.nodes.size(), at_infinity);
  for (std::size_t i = 0; i < diagram.nodes.size(); ++i) {
    if (kernel.side_of_equator(diagram.nodes[i], charts.frame.z) == Sign::positive) wall_of[i] = 0;
  }
}

void find_arcs(const PerturbedKernel& kernel, Charts& charts, Colour c) {
  const GaussianDiagram& diagram = charts.diagram(c);
  const std::vector<std::uint32_t>& wall_of = charts.wall_of[static_cast<std::size_t>(c)];
  std::vector<bool>& flipped_of = charts.flipped_of[static_cast<std::size_t>(c)];
  flipped_of.assign(diagram.arcs.size(), false);
  const auto end = [&](std::uint32_t node) { return node != no_facet && wall_of[node] != at_infinity ? node : at_infinity; };
  for (std::uint32_t i = 0; i < diagram.arcs.size(); ++i) {
    const Arc& arc = diagram.arcs[i];
    const std::uint32_t from = end(arc.from), to = end(arc.to);
    // An arc of rank 2 or 3 with no end here lies in the other hemisphere: it is no longer than pi.
    if (diagram.rank > 1 && from == at_infinity && to == at_infinity) continue;
    const bool flipped = kernel.side_of_arc(charts.frame.v, arc.circle) == Sign::negative;
    charts.arcs[static_cast<std::size_t>(c)].push_back(flipped ? ChartArc{i, to, from, true, 0, 0} : ChartArc{i, from, to, false, 0, 0});
    flipped_of[i] = flipped;
  }
}

void draw_circles(Charts& charts, Colour c) {
  std::vector<Vec3<double>>& circles = charts.circles[static_cast<std::size_t>(c)];
  circles.reserve(charts.arcs_of(c).size());
  for (const ChartArc& arc : charts.arcs_of(c)) {
    const Vec3<double> d = image(charts.circle(c, arc));
    circles.push_back(arc.flipped ? -d : d);
  }
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

Frame chart_frame(bool lower) { return {Direction(Vector{0, 1, 0}, Role::vertical), Direction(Vector{0, 0, lower ? -1 : 1}, Role::pole)}; }

Charts make_charts(Context& context, const GaussianDiagram& minus_a, const GaussianDiagram& b, const Frame& frame,
                   const Perturbation& perturbation) {
  Charts charts{perturbation, frame, {&minus_a, &b}, {}, {}, {}, {}, {}, {}};
  const PerturbedKernel kernel(charts.perturbation, context.counters.predicates);
  for (const Colour c : both_colours) {
    find_nodes(kernel, charts, c);
    find_arcs(kernel, charts, c);
    sort_by_height(charts, c);
    draw_circles(charts, c);
  }
  raise_walls(kernel, charts);
  for (const Colour c : both_colours) locate_nodes(kernel, charts, c);
  locate_ends(kernel, charts);
  return charts;
}

namespace {

// At each face, the arcs below it come before those above it.
bool in_height_order(const Charts& charts, Colour c) {
  std::vector<std::uint32_t> last_below;  // of each face, one more than the greatest index
  const std::vector<ChartArc>& arcs = charts.arcs_of(c);
  for (std::uint32_t i = 0; i < arcs.size(); ++i) {
    const std::uint32_t face = charts.vertex_above(c, arcs[i]);
    if (face >= last_below.size()) last_below.resize(face + 1, 0);
    last_below[face] = i + 1;
  }
  for (std::uint32_t i = 0; i < arcs.size(); ++i) {
    const std::uint32_t face = charts.vertex_below(c, arcs[i]);
    if (face < last_below.size() && last_below[face] > i) return false;
  }
  return true;
}

}  // namespace

Report validate(const Charts& charts) {
  Report report;
  PredicateCounts uncounted;
  const PerturbedKernel kernel(charts.perturbation, uncounted);
  const auto direction = [&](const Charts::Wall& w) -> const Direction& { return charts.node(w.colour, w.node); };
  for (std::size_t i = 1; i < charts.walls.size(); ++i) {
    report.expect(kernel.x_order(direction(charts.walls[i - 1]), direction(charts.walls[i]), charts.frame.v) == Sign::positive,
                  "wall " + std::to_string(i) + " is not right of the one before");
  }
  for (const Colour c : both_colours) {
    const auto here = [&](std::uint32_t node) { return kernel.side_of_equator(charts.node(c, node), charts.frame.z) == Sign::positive; };
    report.expect(in_height_order(charts, c), "the arcs are not in height order");
    for (const ChartArc& part : charts.arcs_of(c)) {
      const std::string name = "arc " + std::to_string(part.arc) + ": ";
      const Arc& arc = charts.diagram(c).arcs[part.arc];
      const auto [left, right] = part.flipped ? std::pair(arc.to, arc.from) : std::pair(arc.from, arc.to);
      report.expect(
          (kernel.side_of_arc(charts.frame.v, arc.circle) == Sign::positive) != part.flipped && part.flipped == charts.flipped(c, part.arc),
          name + "flipped against its circle");
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
