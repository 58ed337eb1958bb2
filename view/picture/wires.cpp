// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/wires.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fathom::picture {
namespace {

constexpr std::size_t most_edges = 600;
constexpr double margin = 16;  // pixels

}  // namespace

Wires wires_of(const polytope::Polytope& hull, const View& view) {
  kernels::IdVector<polytope::FacetId, bool> faces_us;
  for (const polytope::Facet& facet : hull.facets) faces_us.push_back(view.faces_us(facet.normal));
  const auto seen = [&](polytope::FacetId f) { return f.is_none() || faces_us[f]; };
  const bool all = hull.edges.size() <= most_edges;
  Wires result{{}, hull.input_ids};
  for (const polytope::Edge& edge : hull.edges) {
    const bool left = seen(edge.left), right = seen(edge.right);
    if (all || left != right) result.wires.push_back({hull.input_ids[edge.from], hull.input_ids[edge.to], !left && !right});
  }
  if (hull.rank == 2)  // a polygon seen from its edge has no side that we see, and hides nothing
    for (Wires::Wire& wire : result.wires) wire.hidden = false;
  return result;
}

Viewport Viewport::around(const std::vector<Dot>& dots) {
  Dot low = dots.front(), high = dots.front();
  for (const Dot& d : dots) {
    low = {std::min(low.x, d.x), std::min(low.y, d.y)};
    high = {std::max(high.x, d.x), std::max(high.y, d.y)};
  }
  const double across = std::max((high.x - low.x) / (width - 2 * margin), (high.y - low.y) / (height - 2 * margin));
  return {{(low.x + high.x) / 2, (low.y + high.y) / 2}, across > 0 ? 1 / across : 1};
}

std::string Viewport::path(const std::vector<Dot>& dots, bool closed) const {
  std::vector<Dot> pixels;
  for (const Dot& d : dots) pixels.push_back(pixel(d));
  std::string result;
  for (const Dot& d : clipped(std::move(pixels), closed, {width / 2, height / 2}, {width, height}))
    result += fmt::format("{}{:.1f} {:.1f}", result.empty() ? 'M' : 'L', d.x, d.y);
  return result.empty() || !closed ? result : result + "Z";
}

}  // namespace fathom::picture
