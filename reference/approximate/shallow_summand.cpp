// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "reference/approximate/shallow_surface.hpp"

namespace fathom::approximate {
namespace {

using Index = std::uint32_t;
using polytope::FacetId, polytope::VertexId;

constexpr Index no_edge = std::numeric_limits<Index>::max();

kernels::IdVector<VertexId, Vector> vertices_of(const polytope::Polytope& polytope, gaussian::Colour colour) {
  kernels::IdVector<VertexId, Vector> vertices = polytope.vertices;
  if (colour == gaussian::Colour::a) {
    for (Vector& v : vertices) v = -v;
  }
  return vertices;
}

}  // namespace

Summand::Summand(const polytope::Polytope& polytope, gaussian::Colour colour)
    : polytope_(&polytope),
      reflected_(colour == gaussian::Colour::a),
      vertices_(vertices_of(polytope, colour)),
      first_spoke_(polytope.vertices.size() + 1),
      spokes_(2 * polytope.edges.size()),
      edge_after_(polytope.corners.size()) {
  for (const polytope::Edge& e : polytope.edges) {
    ++first_spoke_[e.from.next()];
    ++first_spoke_[e.to.next()];
  }
  std::partial_sum(first_spoke_.begin(), first_spoke_.end(), first_spoke_.begin());
  kernels::IdVector<VertexId, Index> next = first_spoke_;
  for (Index i = 0; i < polytope.edges.size(); ++i) {
    const polytope::Edge& e = polytope.edges[i];
    spokes_[next[e.from]++] = {e.to, i};
    spokes_[next[e.to]++] = {e.from, i};
  }
  for (const VertexId v : polytope.vertices.ids()) {
    std::sort(spokes_.begin() + first_spoke_[v], spokes_.begin() + first_spoke_[v.next()],
              [](const Spoke& s, const Spoke& t) { return s.other < t.other; });
  }
  for (const polytope::Facet& f : polytope.facets) {
    for (Index i = f.begin; i < f.end; ++i) {
      edge_after_[i] = edge_between(polytope.corners[i], polytope.corners[i + 1 == f.end ? f.begin : i + 1]);
    }
  }
}

Vector Summand::normal(FacetId facet) const {
  const Vector& n = polytope_->facets[facet].normal;
  return reflected_ ? -n : n;
}

VertexId Summand::corner(const Face& face) const {
  switch (face.kind) {
    case Face::Kind::vertex: return face.vertex();
    case Face::Kind::edge: return polytope_->edges[face.index].from;
    case Face::Kind::facet: break;
  }
  return polytope_->corners[polytope_->facets[face.facet()].begin];
}

Face Summand::face_of(std::span<const VertexId> vertices, const Vector& n) const {
  const VertexId v = vertices.front();
  if (vertices.size() == 1) return Face::of(v);
  if (vertices.size() == 2) return Face::of_edge(edge_between(v, vertices[1]));
  for (const Spoke& s : star(v)) {
    const polytope::Edge& e = polytope_->edges[s.edge];
    for (const FacetId f : {e.left, e.right}) {
      if (same_direction(normal(f), n)) return Face::of(f);
    }
  }
  throw std::logic_error("no facet of the body has this normal");
}

std::vector<FaceEdge> Summand::sides(const Face& face) const {
  if (face.kind == Face::Kind::vertex) return {};
  if (face.kind == Face::Kind::edge) {
    const polytope::Edge& e = polytope_->edges[face.index];
    return {{e.from, e.to, face.index}, {e.to, e.from, face.index}};
  }
  const polytope::Facet& f = polytope_->facets[face.facet()];
  const std::vector<VertexId>& corners = polytope_->corners;
  std::vector<FaceEdge> sides;
  sides.reserve(f.end - f.begin);
  for (Index i = f.begin; i < f.end; ++i) sides.push_back({corners[i], corners[i + 1 == f.end ? f.begin : i + 1], edge_after_[i]});
  if (reflected_) {
    std::ranges::reverse(sides);
    for (FaceEdge& s : sides) std::swap(s.from, s.to);
  }
  return sides;
}

std::span<const Summand::Spoke> Summand::star(VertexId v) const {
  return std::span(spokes_).subspan(first_spoke_[v], first_spoke_[v.next()] - first_spoke_[v]);
}

Index Summand::edge_between(VertexId v, VertexId w) const { return std::ranges::lower_bound(star(v), w, {}, &Spoke::other)->edge; }

/// The facet to the right when the edge is walked from `from`, seen from outside.
FacetId Summand::right_of(Index edge, VertexId from) const {
  const polytope::Edge& e = polytope_->edges[edge];
  return (e.from == from) != reflected_ ? e.right : e.left;
}

/// Two edges at one vertex of a solid have at most one facet in common, those of a polygon two.
FacetId Summand::common_facet(Index edge, Index other_edge, const Vector& n) const {
  const polytope::Edge &e = polytope_->edges[edge], &other = polytope_->edges[other_edge];
  for (const FacetId f : {e.left, e.right}) {
    if ((f == other.left || f == other.right) && sgn(dot(normal(f), n)) > 0) return f;
  }
  throw std::logic_error("two edges of one face have no facet in common");
}

// The arc of the edge runs from the facet on its left to the one on its right, about the edge's direction.
Turn Summand::turn_at_edge(Index edge, VertexId from) const {
  const FacetId facet = right_of(edge, from);
  if (facet.is_none()) return {};
  const polytope::Edge& e = polytope_->edges[edge];
  const VertexId* corner = &polytope_->corners[polytope_->facets[facet].begin];
  while (*corner == e.from || *corner == e.to) ++corner;
  return {false, vertices_[*corner] - vertices_[from], Face::of(facet)};
}

// A neighbour x becomes extreme at an angle in (0, pi], the earlier of two x, y being x exactly if det(d, x, y) > 0.
Turn Summand::turn(const Face& face, VertexId from, const Vector& d, std::uint64_t* steps) const {
  ++*steps;
  if (face.kind == Face::Kind::edge) return turn_at_edge(face.index, from);
  const std::span<const Spoke> spokes = star(from);
  if (spokes.empty()) return {};
  *steps += spokes.size() - 1;
  const Vector& origin = vertices_[from];
  Vector best, across;
  Index edge = no_edge, tied = no_edge;
  for (const Spoke& s : spokes) {
    Vector x = vertices_[s.other] - origin;
    const int order = edge == no_edge ? -1 : sgn(dot(across, x));
    if (order > 0) continue;
    if (order == 0) {
      tied = s.edge;
      continue;
    }
    best = std::move(x);
    across = cross(d, best);
    edge = s.edge;
    tied = no_edge;
  }
  if (tied == no_edge) return {false, std::move(best), Face::of_edge(edge)};
  const FacetId facet = common_facet(edge, tied, -across);
  return {false, std::move(best), Face::of(facet)};
}

}  // namespace fathom::approximate
