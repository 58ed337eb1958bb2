// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/vertex_facet/vertex_facet.hpp"

#include <algorithm>
#include <array>

#include "kernels/filters/support.hpp"

namespace fathom {
std::vector<VertexFacetPair> vertex_facet_pairs(const Charts& charts) {
  std::vector<VertexFacetPair> pairs;
  pairs.reserve(charts.walls.size());
  for (const Charts::Wall& wall : charts.walls) pairs.push_back({wall.colour, wall.node, charts.place(wall.colour, wall.node).face});
  return pairs;
}

void offer(const std::vector<VertexFacetPair>& pairs, const Charts& charts, const Polytope& a, const Polytope& b, NearestPlanes& nearest) {
  for (const VertexFacetPair& pair : pairs) {
    const bool facet_of_a = pair.facet_of == Colour::a;
    const Polytope& body = facet_of_a ? a : b;
    const std::uint32_t on_facet = body.corners[body.facets[pair.facet].begin];
    const Vector& p = a.vertices[facet_of_a ? on_facet : pair.vertex];
    const Vector& q = b.vertices[facet_of_a ? pair.vertex : on_facet];
    const Vector& n = charts.node(pair.facet_of, pair.facet).exact();
    nearest.offer(n, dot(n, q - p));
  }
}

Report validate(const std::vector<VertexFacetPair>& pairs, const Charts& charts, const Polytope& a, const Polytope& b) {
  Report report;
  std::array<std::vector<int>, 2> seen{std::vector<int>(charts.wall_of[0].size()), std::vector<int>(charts.wall_of[1].size())};
  std::array<PointCloud, 2> vertices;
  for (std::size_t c = 0; c < 2; ++c) {
    std::vector<Vector> points = (c == 0 ? a : b).vertices;
    if (c == 0) {
      for (Vector& p : points) p = -p;
    }
    vertices[c] = PointCloud(std::move(points));
  }
  for (const VertexFacetPair& pair : pairs) {
    ++seen[static_cast<std::size_t>(pair.facet_of)][pair.facet];
    const std::vector<std::uint32_t> extreme =
        extreme_points(vertices[static_cast<std::size_t>(other(pair.facet_of))], charts.node(pair.facet_of, pair.facet).exact());
    report.expect(std::ranges::binary_search(extreme, pair.vertex),
                  "vertex " + std::to_string(pair.vertex) + " is not extreme in the direction of facet " + std::to_string(pair.facet));
  }
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < seen[c].size(); ++i) {
      report.expect(seen[c][i] == (charts.wall_of[c][i] != at_infinity ? 1 : 0), "node " + std::to_string(i) + " is not located once");
    }
  }
  return report;
}

}  // namespace fathom
