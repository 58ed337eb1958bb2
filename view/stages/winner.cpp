// SPDX-License-Identifier: GPL-3.0-or-later
// What the first optimum comes from: a facet of one body, or the crossing of two arcs.
#include <algorithm>
#include <stdexcept>

#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

// The face of a hull, spanned by these input points, whose outward normal is `normal` if it is a facet.
StagedFeature feature_of(const polytope::Polytope& hull, const std::vector<std::uint32_t>& points, const Vector& normal) {
  const auto vertex = [&](std::uint32_t point) {
    return static_cast<Index>(std::ranges::lower_bound(hull.input_ids, point) - hull.input_ids.begin());
  };
  if (points.size() == 1) return {StagedFeatureKind::vertex, vertex(points[0])};
  if (points.size() == 2) {
    const Index p = vertex(points[0]), q = vertex(points[1]);
    const auto joins = [&](const polytope::Edge& e) {
      return (e.from.value == p && e.to.value == q) || (e.from.value == q && e.to.value == p);
    };
    const auto edge = std::ranges::find_if(hull.edges, joins);
    if (edge != hull.edges.end()) return {StagedFeatureKind::edge, static_cast<Index>(edge - hull.edges.begin())};
  }
  for (Index i = 0; i < hull.facets.size(); ++i) {
    if (hull.facets[polytope::FacetId(i)].normal == normal) return {StagedFeatureKind::facet, i};
  }
  throw std::logic_error("the features of an optimum are no faces of the hulls");
}

WinnerKind kind_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::facet_vertex:
    case ContactKind::facet_edge:
    case ContactKind::facet_facet: return WinnerKind::facet_of_a;
    case ContactKind::vertex_facet:
    case ContactKind::edge_facet: return WinnerKind::facet_of_b;
    default: return WinnerKind::edges;
  }
}

bool holds(const Indices& edges, Index edge) { return std::ranges::find(edges, edge) != edges.end(); }

}  // namespace

void add_winner(const StagesSource& subject, const Depth& depth, Stages& stages) {
  if (!depth.penetration()) return;
  const Optimum& first = depth.optima().front();
  StagedWinner winner{kind_of(first.contact.kind), std::nullopt, feature_of(subject.exact.hulls.a, first.contact.a, -first.direction),
                      feature_of(subject.exact.hulls.b, first.contact.b, first.direction)};
  for (Index i = 0; winner.kind == WinnerKind::edges && i < stages.pairs.size(); ++i) {
    const StagedPair& pair = stages.pairs[i];
    if (holds(pair.a, winner.a.index) && holds(pair.b, winner.b.index)) winner.pair = i;
  }
  stages.winner = winner;
}

}  // namespace fathom::stages
