// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/shallow_surface.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

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

/// The sides of a face, each with its direction.
struct Boundary {
  std::vector<FaceEdge> sides;
  std::vector<Vector> directions;
};

Boundary boundary(const Summand& body, const Face& face) {
  Boundary result{body.sides(face), {}};
  for (const FaceEdge& s : result.sides) result.directions.push_back(body.vertex(s.to) - body.vertex(s.from));
  return result;
}

/// The order of directions in a plane with normal n by the angle, in [0, 2 pi), that they make with
/// a first one.
class AngleOrder {
 public:
  AngleOrder(const Vector& n, const Vector& first) : n_(n), first_(first), left_(cross(n, first)) {}

  /// Negative if u comes before v, 0 if they point the same way.
  [[nodiscard]] int operator()(const Vector& u, const Vector& v) const {
    if (const int halves = half(u) - half(v)) return halves;
    return -sgn(det(n_, u, v));
  }

 private:
  [[nodiscard]] int half(const Vector& u) const {
    const int side = sgn(dot(left_, u));
    return side > 0 || (side == 0 && dot(first_, u) > 0) ? 0 : 1;
  }

  const Vector &n_, &first_;
  Vector left_;
};

SumEdge edge_of_a(const FaceEdge& s, polytope::VertexId corner_of_b) {
  return {Face::of_edge(s.edge), Face::of(corner_of_b), s.from, s.to, corner_of_b, corner_of_b};
}

SumEdge edge_of_b(polytope::VertexId corner_of_a, const FaceEdge& s) {
  return {Face::of(corner_of_a), Face::of_edge(s.edge), corner_of_a, corner_of_a, s.from, s.to};
}

SumEdge edge_of_both(const FaceEdge& s, const FaceEdge& t) {
  return {Face::of_edge(s.edge), Face::of_edge(t.edge), s.from, s.to, t.from, t.to};
}

/// The boundary of the sum of two convex polygons (an edge counts as one of two sides): all sides
/// in the order of their directions.
std::vector<SumEdge> merged(const Boundary& a, const Boundary& b, const Vector& n) {
  const AngleOrder order(n, a.directions.front());
  const std::size_t first =
      std::ranges::min_element(b.directions, [&](const Vector& u, const Vector& v) { return order(u, v) < 0; }) -
      b.directions.begin();
  const std::size_t count_a = a.sides.size(), count_b = b.sides.size();
  std::vector<SumEdge> edges;
  std::size_t i = 0, j = 0;
  while (i < count_a || j < count_b) {
    const std::size_t k = (first + j) % count_b;
    const FaceEdge &s = a.sides[i % count_a], &t = b.sides[k];
    const int next = i == count_a ? 1 : j == count_b ? -1 : order(a.directions[i], b.directions[k]);
    edges.push_back(next < 0 ? edge_of_a(s, t.from) : next > 0 ? edge_of_b(s.from, t) : edge_of_both(s, t));
    if (next <= 0) ++i;
    if (next >= 0) ++j;
  }
  return edges;
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
  for (Index i = f.begin; i < f.end; ++i)
    sides.push_back({corners[i], corners[i + 1 == f.end ? f.begin : i + 1], edge_after_[i]});
  if (reflected_) {
    std::ranges::reverse(sides);
    for (FaceEdge& s : sides) std::swap(s.from, s.to);
  }
  return sides;
}

std::span<const Summand::Spoke> Summand::star(VertexId v) const {
  return std::span(spokes_).subspan(first_spoke_[v], first_spoke_[v.next()] - first_spoke_[v]);
}

Index Summand::edge_between(VertexId v, VertexId w) const {
  return std::ranges::lower_bound(star(v), w, {}, &Spoke::other)->edge;
}

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

// The arc of the edge runs from the facet on its left to the one on its right, about the edge's
// direction.
Turn Summand::turn_at_edge(Index edge, VertexId from) const {
  const FacetId facet = right_of(edge, from);
  if (facet.is_none()) return {};
  const polytope::Edge& e = polytope_->edges[edge];
  const VertexId* corner = &polytope_->corners[polytope_->facets[facet].begin];
  while (*corner == e.from || *corner == e.to) ++corner;
  return {false, vertices_[*corner] - vertices_[from], Face::of(facet)};
}

// A neighbour x becomes extreme at an angle in (0, pi], the earlier of two x, y being x exactly if
// det(d, x, y) > 0.
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

SumFacet SumSurface::facet(const std::vector<polytope::VertexId>& face_a, const std::vector<polytope::VertexId>& face_b,
                           const Vector& n) const {
  return {minus_a_.face_of(face_a, n), b_.face_of(face_b, n), primitive(n)};
}

Vector SumSurface::point(const SumFacet& facet) const {
  return minus_a_.vertex(minus_a_.corner(facet.a)) + b_.vertex(b_.corner(facet.b));
}

std::vector<SumEdge> SumSurface::edges(const SumFacet& facet) const {
  const Boundary a = boundary(minus_a_, facet.a), b = boundary(b_, facet.b);
  if (!a.sides.empty() && !b.sides.empty()) return merged(a, b, facet.normal);
  std::vector<SumEdge> edges;
  for (const FaceEdge& s : a.sides) edges.push_back(edge_of_a(s, facet.b.vertex()));
  for (const FaceEdge& s : b.sides) edges.push_back(edge_of_b(facet.a.vertex(), s));
  return edges;
}

// The body whose face grows first when the normal is turned about the edge decides; both grow, if
// both do so at the same angle.
SumFacet SumSurface::across(const SumEdge& edge, std::uint64_t* steps) const {
  const Vector d = to(edge) - from(edge);
  const Turn a = minus_a_.turn(edge.a, edge.from_a, d, steps), b = b_.turn(edge.b, edge.from_b, d, steps);
  if (a.never && b.never) throw std::logic_error("the sum of the bodies has no interior");
  const int order = b.never ? 1 : a.never ? -1 : sgn(det(d, a.x, b.x));
  SumFacet next{order >= 0 ? a.face : edge.a, order <= 0 ? b.face : edge.b, {}};
  next.normal = order >= 0 && a.face.kind == Face::Kind::facet   ? minus_a_.normal(a.face.facet())
                : order <= 0 && b.face.kind == Face::Kind::facet ? b_.normal(b.face.facet())
                                                                 : primitive(cross(order >= 0 ? a.x : b.x, d));
  return next;
}

}  // namespace fathom::approximate
