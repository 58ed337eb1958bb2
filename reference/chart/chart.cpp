// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/chart.hpp"

#include <algorithm>
#include <string>

#include "reference/chart/height_order.hpp"
#include "reference/chart/locate.hpp"
#include "reference/chart/walls.hpp"

namespace fathom::chart {
namespace {

// Tells the nodes of this hemisphere from the others, before their walls are known.
constexpr WallId some_wall{0};

void find_nodes(const kernels::PerturbedKernel& kernel, const Charts& charts, ColourChart& chart) {
  chart.wall_of.assign(chart.diagram->nodes.size(), WallId::none());
  for (const gaussian::NodeId i : chart.wall_of.ids()) {
    if (kernel.side_of_equator(chart.node(i), charts.frame.z) == kernels::Sign::positive) chart.wall_of[i] = some_wall;
  }
}

void find_arcs(const kernels::PerturbedKernel& kernel, const Charts& charts, ColourChart& chart) {
  const gaussian::GaussianDiagram& diagram = *chart.diagram;
  const auto end = [&](gaussian::NodeId node) { return node.is_none() || chart.wall_of[node].is_none() ? at_infinity : node; };
  for (const gaussian::ArcId i : diagram.arcs.ids()) {
    const gaussian::Arc& arc = diagram.arcs[i];
    const gaussian::NodeId from = end(arc.from), to = end(arc.to);
    // An arc of rank 2 or 3 with no end here lies in the other hemisphere: it is no longer than pi.
    if (diagram.rank > 1 && from == at_infinity && to == at_infinity) continue;
    const bool flipped = kernel.side_of_arc(charts.frame.v, arc.circle) == kernels::Sign::negative;
    chart.arcs.push_back({i, flipped ? to : from, flipped ? from : to, flipped, {}, {}});
  }
}

void draw_circles(ColourChart& chart) {
  chart.circles.reserve(chart.arcs.size());
  for (const ChartArc& arc : chart.arcs) {
    const Vec3<double> d = kernels::image(chart.circle(arc));
    chart.circles.push_back(arc.flipped ? -d : d);
  }
}

}  // namespace

gaussian::VertexId ColourChart::vertex_above(const ChartArc& arc) const {
  const gaussian::Arc& whole = diagram->arcs[arc.arc];
  return arc.flipped ? whole.below : whole.above;
}

gaussian::VertexId ColourChart::vertex_below(const ChartArc& arc) const {
  const gaussian::Arc& whole = diagram->arcs[arc.arc];
  return arc.flipped ? whole.above : whole.below;
}

Frame chart_frame(Hemisphere hemisphere) {
  return {kernels::Direction(Vector{0, 1, 0}, kernels::Role::vertical),
          kernels::Direction(Vector{0, 0, hemisphere == Hemisphere::upper ? 1 : -1}, kernels::Role::pole)};
}

Charts make_charts(kernels::Context& context, const gaussian::GaussianDiagram& minus_a, const gaussian::GaussianDiagram& b,
                   const Frame& frame, const kernels::Perturbation& perturbation) {
  Charts charts{perturbation, frame, {}, {}};
  charts.of.a.diagram = &minus_a;
  charts.of.b.diagram = &b;
  const kernels::PerturbedKernel kernel(charts.perturbation, context.counters.predicates);
  for (const gaussian::Colour c : gaussian::both_colours) {
    ColourChart& chart = charts.of[c];
    find_nodes(kernel, charts, chart);
    find_arcs(kernel, charts, chart);
    sort_by_height(chart);
    draw_circles(chart);
  }
  raise_walls(kernel, charts);
  for (const gaussian::Colour c : gaussian::both_colours) locate_nodes(kernel, charts, c);
  locate_ends(kernel, charts);
  return charts;
}

namespace {

// At each face, the arcs below it come before those above it.
bool in_height_order(const ColourChart& chart) {
  kernels::IdVector<gaussian::VertexId, ChartArcId> after_below;  // for each face, the id after the last arc below it
  for (const ChartArcId i : chart.arcs.ids()) {
    const gaussian::VertexId face = chart.vertex_above(chart.arcs[i]);
    if (face.value >= after_below.size()) after_below.resize(face.value + 1);
    after_below[face] = i.next();
  }
  return std::ranges::all_of(chart.arcs.ids(), [&](ChartArcId i) {
    const gaussian::VertexId face = chart.vertex_below(chart.arcs[i]);
    return face.value >= after_below.size() || after_below[face] <= i;
  });
}

}  // namespace

kernels::Report validate(const Charts& charts) {
  kernels::Report report;
  PredicateCounts uncounted;
  const kernels::PerturbedKernel kernel(charts.perturbation, uncounted);
  for (std::uint32_t i = 1; i < charts.walls.size(); ++i) {
    const kernels::Direction &left = charts.node(charts.walls[WallId(i - 1)]), &right = charts.node(charts.walls[WallId(i)]);
    report.expect(kernel.x_order(left, right, charts.frame.v) == kernels::Sign::positive,
                  "wall " + std::to_string(i) + " is not right of the one before");
  }
  for (const gaussian::Colour c : gaussian::both_colours) {
    const ColourChart& chart = charts.of[c];
    const auto here = [&](gaussian::NodeId node) {
      return kernel.side_of_equator(chart.node(node), charts.frame.z) == kernels::Sign::positive;
    };
    const auto is_end = [&](gaussian::NodeId end, gaussian::NodeId node) {
      return end == at_infinity ? node.is_none() || !here(node) : end == node && here(node);
    };
    report.expect(in_height_order(chart), "the arcs are not in height order");
    for (const ChartArc& part : chart.arcs) {
      const std::string name = "arc " + std::to_string(part.arc.value) + ": ";
      const gaussian::Arc& arc = chart.diagram->arcs[part.arc];
      report.expect((kernel.side_of_arc(charts.frame.v, arc.circle) == kernels::Sign::positive) != part.flipped,
                    name + "flipped against its circle");
      report.expect(is_end(part.left, part.flipped ? arc.to : arc.from), name + "left end");
      report.expect(is_end(part.right, part.flipped ? arc.from : arc.to), name + "right end");
      if (part.left != at_infinity && part.right != at_infinity) {
        report.expect(chart.wall_of[part.left] < chart.wall_of[part.right], name + "does not run from left to right");
      }
    }
  }
  return report;
}

}  // namespace fathom::chart
