// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel edges and common normals: equal primitive vectors, found by sorting.
#include <array>
#include <map>

#include "verify/study/findings.hpp"

namespace fathom::studies {
namespace {

/// The one of u and -u whose first component other than zero is positive, primitive: equal for parallel vectors alone.
Vector line_direction(const Vector& u) {
  Vector result = primitive(u);
  return lexicographically_less(result, Vector{0, 0, 0}) ? -result : result;
}

using Groups = std::map<Vector, std::array<std::vector<std::uint32_t>, 2>, LexicographicOrder>;

void group_edges(const Subject& subject, std::size_t side, Groups& groups) {
  for (std::uint32_t i = 0; i < subject.diagram.arcs.size(); ++i)
    groups[line_direction(subject.diagram.arcs[gaussian::ArcId(i)].circle.exact())][side].push_back(i);
}

/// Whether the supporting planes of two facets with parallel normals are one.
bool coplanar(const Subject& a, std::uint32_t f, const Subject& b, std::uint32_t g) {
  const Vector& p = a.body.vertices[a.body.corners[a.body.facets[f].begin]];
  const Vector& q = b.body.vertices[b.body.corners[b.body.facets[g].begin]];
  return dot(a.body.facets[f].normal, p - q) == 0;
}

}  // namespace

void find_parallel_edges(const Subject& a, const Subject& b, Findings& findings) {
  Groups groups;
  group_edges(a, 0, groups);
  group_edges(b, 1, groups);
  for (const auto& [direction, edges] : groups) {
    findings.add_pairs(Coincidence::parallel_edges, edges[0], edges[1], [&](std::uint32_t e, std::uint32_t f) -> Involved {
      return {{a.edge(e)}, {b.edge(f)}};
    });
    findings.add_pairs(Coincidence::parallel_edges_of_a, edges[0], [&](std::uint32_t e, std::uint32_t f) -> Involved {
      return {{a.edge(e), a.edge(f)}, {}};
    });
    findings.add_pairs(Coincidence::parallel_edges_of_b, edges[1], [&](std::uint32_t e, std::uint32_t f) -> Involved {
      return {{}, {b.edge(e), b.edge(f)}};
    });
  }
}

// Facet normals are primitive, and no two facets of a body share one.
void find_common_normals(const Subject& a, const Subject& b, Findings& findings) {
  std::map<Vector, std::uint32_t, LexicographicOrder> facet_of_b;
  for (std::uint32_t g = 0; g < b.body.facets.size(); ++g) facet_of_b.emplace(b.body.facets[g].normal, g);
  for (std::uint32_t f = 0; f < a.body.facets.size(); ++f) {
    const Vector& normal = a.body.facets[f].normal;
    for (const bool equal : {false, true}) {
      const auto found = facet_of_b.find(equal ? normal : -normal);
      if (found == facet_of_b.end()) continue;
      const Involved facets{{a.facet(f)}, {b.facet(found->second)}};
      findings.add(equal ? Coincidence::equal_normals : Coincidence::coincident_normals, facets);
      if (coplanar(a, f, b, found->second)) findings.add(Coincidence::coplanar_facets, facets);
    }
  }
}

}  // namespace fathom::studies
