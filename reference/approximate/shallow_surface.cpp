// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/shallow_surface.hpp"

#include <algorithm>
#include <stdexcept>

namespace fathom::approximate {
namespace {

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

/// The order of directions in a plane with normal n by the angle, in [0, 2 pi), that they make with a first one.
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

/// The boundary of the sum of two convex polygons (an edge counts as one of two sides): all sides in the order of their directions.
std::vector<SumEdge> merged(const Boundary& a, const Boundary& b, const Vector& n) {
  const AngleOrder order(n, a.directions.front());
  const std::size_t first =
      std::ranges::min_element(b.directions, [&](const Vector& u, const Vector& v) { return order(u, v) < 0; }) - b.directions.begin();
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

SumFacet SumSurface::facet(const std::vector<polytope::VertexId>& face_a, const std::vector<polytope::VertexId>& face_b,
                           const Vector& n) const {
  return {minus_a_.face_of(face_a, n), b_.face_of(face_b, n), primitive(n)};
}

Vector SumSurface::point(const SumFacet& facet) const { return minus_a_.vertex(minus_a_.corner(facet.a)) + b_.vertex(b_.corner(facet.b)); }

std::vector<SumEdge> SumSurface::edges(const SumFacet& facet) const {
  const Boundary a = boundary(minus_a_, facet.a), b = boundary(b_, facet.b);
  if (!a.sides.empty() && !b.sides.empty()) return merged(a, b, facet.normal);
  std::vector<SumEdge> edges;
  for (const FaceEdge& s : a.sides) edges.push_back(edge_of_a(s, facet.b.vertex()));
  for (const FaceEdge& s : b.sides) edges.push_back(edge_of_b(facet.a.vertex(), s));
  return edges;
}

// The body whose face grows first when the normal is turned about the edge decides; both grow, if both do so at the same angle.
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
