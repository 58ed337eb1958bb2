// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/line_scene.hpp"

#include <algorithm>

namespace fathom::lines {

template <gaussian::Colour c>
EdgeLines<c>::EdgeLines(const polytope::Polytope& polytope, long exponent) : polytope_(&polytope), images_(exponent) {
  for (const Edge i : ids()) images_.push_back(point(i), direction(i));
}

template <gaussian::Colour c>
Vector EdgeLines<c>::direction(Edge edge) const {
  const auto& e = polytope_->edges[edge.value];
  return polytope_->vertices[e.to] - polytope_->vertices[e.from];
}

template class EdgeLines<gaussian::Colour::a>;
template class EdgeLines<gaussian::Colour::b>;

bool offer_edges(const EdgeLinesOfA& a, gaussian::EdgeOfA e, const EdgeLinesOfB& b, gaussian::EdgeOfB f,
                 kernels::NearestPlanes& nearest) {
  const Vector w = cross(a.direction(e), b.direction(f));
  if (is_zero(w)) return false;
  const mpz_class height = dot(b.point(f) - a.point(e), w);
  return height > 0 ? nearest.offer(w, height) : nearest.offer(-w, mpz_class(-height));
}

template <gaussian::Colour c>
ChartLines<c>::ChartLines(const chart::ColourChart& chart, const EdgeLines<c>& lines) : chart_(&chart), lines_(&lines) {
  std::vector<gaussian::ArcId> whole(chart.arcs.size());
  std::ranges::transform(chart.arcs, whole.begin(), &chart::ChartArc::arc);
  images_.gather(lines.images(), whole);
  for (const chart::ChartArcId i : chart.arcs.ids()) {
    if (chart.arcs[i].flipped) images_.reverse(i.value);
  }
}

template <gaussian::Colour c>
kernels::WideLine ChartLines<c>::wide(Arc i) const {
  kernels::WideLine line = kernels::wide_line(point(i), lines_->direction(edge(i)), images_.exponent());
  if (arc(i).flipped) line.reverse();
  return line;
}

template <gaussian::Colour c>
kernels::WideLines ChartLines<c>::wide() const {
  return {images_.size(), [this](std::size_t i) { return wide(Arc(static_cast<std::uint32_t>(i))); }};
}

template class ChartLines<gaussian::Colour::a>;
template class ChartLines<gaussian::Colour::b>;

bool offer_arcs(const LineScene& scene, chart::ChartArcOfA e, chart::ChartArcOfB f, kernels::NearestPlanes& nearest) {
  return offer_edges(scene.a.lines(), scene.a.edge(e), scene.b.lines(), scene.b.edge(f), nearest);
}

}  // namespace fathom::lines
