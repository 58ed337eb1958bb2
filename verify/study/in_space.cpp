// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel edges and common normals: equal primitive vectors, found by sorting.
#include "verify/study/study.hpp"

namespace fathom::studies {
namespace {

/// The one of u and -u whose first component other than zero is positive, primitive: equal for parallel vectors alone.
Vector line_direction(const Vector& u) {
  Vector result = primitive(u);
  return lexicographically_less(result, Vector{0, 0, 0}) ? -result : result;
}

const polytope::Facet& facet_of(const Subject& subject, gaussian::NodeId node) { return subject.body.facets[gaussian::facet_of(node)]; }

/// Whether the supporting planes of two facets with parallel normals are one.
bool coplanar(const Subjects& subjects, gaussian::NodeId of_a, gaussian::NodeId of_b) {
  const polytope::Polytope &a = subjects.a.body, &b = subjects.b.body;
  const polytope::Facet& facet = facet_of(subjects.a, of_a);
  return dot(facet.normal, a.vertices[a.corners[facet.begin]] - b.vertices[b.corners[facet_of(subjects.b, of_b).begin]]) == 0;
}

}  // namespace

void find_parallel_edges(const Subjects& subjects, Findings& findings) {
  ByDirection<gaussian::PerColour<std::vector<gaussian::ArcId>>> groups;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    const gaussian::GaussianDiagram& diagram = subjects[colour].diagram;
    for (const gaussian::ArcId i : diagram.arcs.ids()) groups[line_direction(diagram.arcs[i].circle.exact())][colour].push_back(i);
  }
  for (const auto& [direction, edges] : groups) {
    findings.add_pairs(Coincidence::parallel_edges, subjects, edges);
    findings.add_pairs(Coincidence::parallel_edges_of_a, subjects.a, edges.a);
    findings.add_pairs(Coincidence::parallel_edges_of_b, subjects.b, edges.b);
  }
}

// Facet normals are primitive, and no two facets of a body share one.
void find_common_normals(const Subjects& subjects, Findings& findings) {
  const auto& [a, b] = subjects;
  ByDirection<gaussian::NodeId> facet_of_b;
  for (const gaussian::NodeId g : b.diagram.nodes.ids()) facet_of_b.emplace(facet_of(b, g).normal, g);
  for (const gaussian::NodeId f : a.diagram.nodes.ids()) {
    const Vector& normal = facet_of(a, f).normal;
    for (const bool equal : {false, true}) {
      const auto found = facet_of_b.find(equal ? normal : -normal);
      if (found == facet_of_b.end()) continue;
      const Involved facets{{a.feature(f)}, {b.feature(found->second)}};
      findings.add(equal ? Coincidence::equal_normals : Coincidence::coincident_normals, facets);
      if (coplanar(subjects, f, found->second)) findings.add(Coincidence::coplanar_facets, facets);
    }
  }
}

}  // namespace fathom::studies
