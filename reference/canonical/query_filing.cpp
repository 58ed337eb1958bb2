// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/canonical/query_filing.hpp"

#include <algorithm>

namespace fathom {

Strip strips_of(const Charts& charts, Colour colour, std::uint32_t arc) {
  const ChartArc& a = charts.arcs_of(colour)[arc];
  const auto strips = static_cast<std::uint32_t>(charts.walls.size() + 1);
  return {a.left != at_infinity ? charts.wall(colour, a.left) + 1 : 0, a.right != at_infinity ? charts.wall(colour, a.right) + 1 : strips};
}

Filing::Filing(const Charts& charts, Colour stored_of) {
  const auto count = static_cast<std::uint32_t>(charts.arcs_of(other(stored_of)).size());
  strips_.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) strips_.push_back(strips_of(charts, other(stored_of), i));
}

// Within one subset and sense: of two queries whose x-ranges overlap, a rising arc crosses later than one above it and a falling arc
// later than one below it, and heights are indices; of two others the left one crosses first.       [proofs/canonical_subsets.md, "Grid"]
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

}  // namespace fathom
