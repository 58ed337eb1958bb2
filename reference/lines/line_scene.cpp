// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/line_scene.hpp"

#include <algorithm>

namespace fathom {

template <Colour c>
ChartLines<c>::ChartLines(const ColourChart& chart, const EdgeLines<c>& lines) : chart_(&chart), lines_(&lines) {
  std::vector<ArcId> whole(chart.arcs.size());
  std::ranges::transform(chart.arcs, whole.begin(), &ChartArc::arc);
  images_.gather(lines.images(), whole);
  for (const ChartArcId i : chart.arcs.ids()) {
    if (chart.arcs[i].flipped) images_.reverse(i.value);
  }
}

template class ChartLines<Colour::a>;
template class ChartLines<Colour::b>;

bool offer_arcs(const LineScene& scene, ChartArcOfA e, ChartArcOfB f, NearestPlanes& nearest) {
  return offer_edges(scene.a.lines(), scene.a.edge(e), scene.b.lines(), scene.b.edge(f), nearest);
}

}  // namespace fathom
