// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/canonical/query_filing.hpp"

#include <algorithm>

namespace fathom::canonical {

Strip strips_of(const chart::Charts& charts, gaussian::Colour colour, chart::ChartArcId arc) {
  const chart::ColourChart& chart = charts.of[colour];
  const chart::ChartArc& a = chart.arcs[arc];
  const auto strips = static_cast<std::uint32_t>(charts.walls.size() + 1);
  return {a.left != chart::at_infinity ? chart.wall_of[a.left].value + 1 : 0,
          a.right != chart::at_infinity ? chart.wall_of[a.right].value + 1 : strips};
}

Filing::Filing(const chart::Charts& charts, gaussian::Colour query_of) {
  strips_.reserve(charts.of[query_of].arcs.size());
  for (const chart::ChartArcId i : charts.of[query_of].arcs.ids()) strips_.push_back(strips_of(charts, query_of, i));
}

// Within one subset and sense: of two queries whose x-ranges overlap, a rising arc crosses later than one above it and a falling arc
// later than one below it, and ids are in height order; of two others the left one crosses first.
// [proofs/canonical_subsets.md, "Grid"]
void Filing::sort() {
  std::ranges::sort(entries_, [&](const Entry& e, const Entry& f) {
    if (e.subset != f.subset) return e.subset < f.subset;
    if (e.query == f.query) return false;
    const Strip& s = strips_[e.query];
    const Strip& t = strips_[f.query];
    if (!s.overlaps(t)) return s.first < t.first;
    return (e.subset % 2 == 1) == (e.query > f.query);
  });
}

}  // namespace fathom::canonical
