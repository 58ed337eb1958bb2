// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/polytope/hierarchy_surface.hpp"

namespace fathom::polytope {

using HalfEdgeIndex = std::uint32_t;

HierarchySurface::HierarchySurface(const Polytope& polytope)
    : points_(polytope.vertices), leaving_(polytope.vertices.size()), degree_(polytope.vertices.size(), 0) {
  for (const Edge& e : polytope.edges) {
    add_edge(e.from, e.to);
  }
  next_.resize(origin_.size());
  previous_.resize(origin_.size());
  // The half-edge that leaves each corner along its facet: half-edges grouped by facet, then looked up by their origin.
  kernels::IdVector<FacetId, HalfEdgeIndex> free(polytope.facets.size());
  std::vector<HalfEdge> grouped(origin_.size());
  kernels::IdVector<VertexId, HalfEdge> at(polytope.vertices.size());
  for (const FacetId f : polytope.facets.ids()) free[f] = polytope.facets[f].begin;
  for (HalfEdgeIndex e = 0; e < polytope.edges.size(); ++e) {
    grouped[free[polytope.edges[e].left]++] = HalfEdge(2 * e);
    grouped[free[polytope.edges[e].right]++] = HalfEdge(2 * e + 1);
  }
  for (const Facet& f : polytope.facets) {
    for (HalfEdgeIndex c = f.begin; c < f.end; ++c) at[origin_[grouped[c]]] = grouped[c];
    for (HalfEdgeIndex c = f.begin; c < f.end; ++c) join(grouped[c], at[target(grouped[c])]);
  }
}

HalfEdge HierarchySurface::add_edge(VertexId from, VertexId to) {
  const HalfEdge h(static_cast<HalfEdgeIndex>(origin_.size()));
  origin_.insert(origin_.end(), {from, to});
  next_.resize(origin_.size());
  previous_.resize(origin_.size());
  leaving_[from] = h;
  leaving_[to] = opposite(h);
  ++degree_[from];
  ++degree_[to];
  return h;
}

void HierarchySurface::join(HalfEdge h, HalfEdge following) {
  next_[h] = following;
  previous_[following] = h;
}

std::vector<HalfEdge> HierarchySurface::leaving(VertexId v) const {
  std::vector<HalfEdge> ring;
  HalfEdge h = leaving_[v];
  do {
    ring.push_back(h);
    h = opposite(previous_[h]);
  } while (h != leaving_[v]);
  return ring;
}

/// h leaves v. The half-edge with the hole to its left, from h's target to the next neighbour, where v's corner of the facet left of h
/// is cut off. Of a triangle nothing is left but that side.
HalfEdge HierarchySurface::cut_corner(HalfEdge h) {
  const HalfEdge last = previous_[h], first = next_[h];
  if (next_[first] == last) return first;
  const HalfEdge cut = add_edge(target(h), origin_[last]);
  join(previous_[last], opposite(cut));
  join(opposite(cut), first);
  return cut;
}

std::vector<HalfEdgeIndex> HierarchySurface::remove(VertexId v) {
  std::vector<HalfEdgeIndex> touched;
  Cycle rim;
  for (const HalfEdge h : leaving(v)) rim.push_back(cut_corner(h));
  for (const HalfEdge h : rim) {
    leaving_[origin_[h]] = h;
    --degree_[origin_[h]];
    touched.push_back(edge_of(h));
  }
  degree_[v] = 0;
  close(rim, touched);
  return touched;
}

/// The facet left of hole[0], as positions of its further corners in the hole: a plane is turned about hole[0] until no corner lies
/// above it. The corners span less than a half-turn about hole[0], so the order in which the plane meets them is total.
std::vector<std::size_t> HierarchySurface::corners_of_facet(const Cycle& hole) const {
  std::size_t best = 2;
  kernels::Plane plane(points_, point(hole[0]), point(hole[1]), point(hole[best]));
  for (std::size_t i = 3; i < hole.size(); ++i) {
    if (plane.side(point(hole[i])) != kernels::Sign::positive) continue;
    best = i;
    plane = kernels::Plane(points_, point(hole[0]), point(hole[1]), point(hole[best]));
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 2; i < hole.size(); ++i)
    if (i == best || plane.side(point(hole[i])) == kernels::Sign::zero) corners.push_back(i);
  return corners;
}

/// Facets are found from the hole's first side inwards; each leaves smaller holes, at most greatest_degree deep.
void HierarchySurface::close(const Cycle& hole, std::vector<HalfEdgeIndex>& touched) {
  Cycle facet{hole[0]};
  std::vector<Cycle> holes;
  std::size_t from = 1;
  std::vector<std::size_t> corners = corners_of_facet(hole);
  corners.push_back(hole.size());  // back to where hole[0] begins
  for (const std::size_t to : corners) {
    if (to == from + 1) {
      facet.push_back(hole[from]);
    } else {
      const HalfEdge side = add_edge(origin_[hole[from]], to == hole.size() ? origin_[hole[0]] : origin_[hole[to]]);
      facet.push_back(side);
      touched.push_back(edge_of(side));
      Cycle& rest = holes.emplace_back(hole.begin() + static_cast<std::ptrdiff_t>(from), hole.begin() + static_cast<std::ptrdiff_t>(to));
      rest.push_back(opposite(side));
    }
    from = to;
  }
  for (std::size_t i = 0; i < facet.size(); ++i) join(facet[i], facet[(i + 1) % facet.size()]);
  for (const Cycle& rest : holes) close(rest, touched);
}

}  // namespace fathom::polytope
