// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chart/height_order.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace fathom::chart {
namespace {

// Indices 0, 1, ... grouped by a key below `keys`: those of key k are items[begin[k], begin[k + 1]), ascending.
struct Groups {
  std::vector<std::uint32_t> begin, items;
};

template <class Key>
Groups group(std::uint32_t count, std::uint32_t keys, Key key) {
  Groups groups{std::vector<std::uint32_t>(keys + 1, 0), std::vector<std::uint32_t>(count)};
  for (std::uint32_t i = 0; i < count; ++i) ++groups.begin[key(i)];
  std::partial_sum(groups.begin.begin(), groups.begin.end(), groups.begin.begin());
  for (std::uint32_t i = count; i-- > 0;) groups.items[--groups.begin[key(i)]] = i;
  return groups;
}

}  // namespace

void sort_by_height(ColourChart& chart) {
  const std::vector<ChartArc>& arcs = chart.arcs;
  const auto above = [&](const ChartArc& arc) { return chart.vertex_above(arc).value; };
  const auto below = [&](const ChartArc& arc) { return chart.vertex_below(arc).value; };
  std::uint32_t faces = 0;
  for (const ChartArc& arc : arcs) faces = std::max({faces, above(arc) + 1, below(arc) + 1});
  const auto count = static_cast<std::uint32_t>(arcs.size());
  const Groups leaving = group(count, faces, [&](std::uint32_t i) { return below(arcs[i]); });
  std::vector<std::uint32_t> waiting(faces, 0);  // of each face, how many arcs below it have not been listed
  for (const ChartArc& arc : arcs) ++waiting[above(arc)];
  std::vector<std::uint32_t> ready;  // faces in topological order, as a queue
  for (std::uint32_t f = 0; f < faces; ++f) {
    if (waiting[f] == 0) ready.push_back(f);
  }
  kernels::IdVector<ChartArcId, ChartArc> sorted;
  sorted.reserve(arcs.size());
  for (std::size_t k = 0; k < ready.size(); ++k) {
    const std::uint32_t face = ready[k];
    for (std::uint32_t i = leaving.begin[face]; i < leaving.begin[face + 1]; ++i) {
      sorted.push_back(arcs[leaving.items[i]]);
      const std::uint32_t next = above(sorted.back());
      if (--waiting[next] == 0) ready.push_back(next);
    }
  }
  if (sorted.size() != arcs.size()) throw std::logic_error("arcs of a chart lie above each other in a circle");
  chart.arcs = std::move(sorted);
}

}  // namespace fathom::chart
