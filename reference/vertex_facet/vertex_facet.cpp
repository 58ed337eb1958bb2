// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/vertex_facet/vertex_facet.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "kernels/filters/support.hpp"

namespace fathom::vertex_facet {

std::vector<VertexFacetPair> vertex_facet_pairs(const chart::Charts& charts) {
  std::vector<VertexFacetPair> pairs;
  pairs.reserve(charts.walls.size());
  for (const chart::Wall& wall : charts.walls) {
    pairs.push_back({wall.colour, gaussian::facet_of(wall.node), charts.of[wall.colour].place_of[wall.node].face});
  }
  return pairs;
}

void offer(const std::vector<VertexFacetPair>& pairs, const chart::Charts& charts, const polytope::Polytope& a,
           const polytope::Polytope& b, kernels::NearestPlanes& nearest) {
  for (const VertexFacetPair& pair : pairs) {
    const bool facet_of_a = pair.facet_of == gaussian::Colour::a;
    const polytope::Polytope& body = facet_of_a ? a : b;
    const polytope::VertexId on_facet = body.corners[body.facets[pair.facet].begin];
    const Vector& p = a.vertices[facet_of_a ? on_facet : pair.vertex];
    const Vector& q = b.vertices[facet_of_a ? pair.vertex : on_facet];
    const Vector& n = charts.of[pair.facet_of].node(gaussian::node_of(pair.facet)).exact();
    nearest.offer(n, dot(n, q - p));
  }
}

kernels::Report validate(const std::vector<VertexFacetPair>& pairs, const chart::Charts& charts,
                         const polytope::Polytope& a, const polytope::Polytope& b) {
  kernels::Report report;
  std::vector<Vector> minus_a = a.vertices;
  for (Vector& p : minus_a) p = -p;
  const gaussian::PerColour<kernels::PointCloud> vertices{kernels::PointCloud(std::move(minus_a)),
                                                          kernels::PointCloud(b.vertices)};
  gaussian::PerColour<kernels::IdVector<gaussian::NodeId, int>> seen;
  for (const gaussian::Colour c : gaussian::both_colours) seen[c].resize(charts.of[c].wall_of.size());
  for (const VertexFacetPair& pair : pairs) {
    ++seen[pair.facet_of][gaussian::node_of(pair.facet)];
    const Vector& n = charts.of[pair.facet_of].node(gaussian::node_of(pair.facet)).exact();
    report.expect(std::ranges::binary_search(kernels::extreme_points(vertices[gaussian::other(pair.facet_of)], n),
                                             pair.vertex.value),
                  "vertex " + std::to_string(pair.vertex.value) + " is not extreme in the direction of facet " +
                      std::to_string(pair.facet.value));
  }
  for (const gaussian::Colour c : gaussian::both_colours) {
    for (const gaussian::NodeId i : seen[c].ids()) {
      report.expect(seen[c][i] == (charts.of[c].wall_of[i].is_none() ? 0 : 1),
                    "node " + std::to_string(i.value) + " is not located once");
    }
  }
  return report;
}

}  // namespace fathom::vertex_facet
