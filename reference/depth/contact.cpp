// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a body is the hull of the body's extreme points in a direction: the hull of the whole body is not needed.
#include "reference/depth/contact.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernels/number/ratio.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {
namespace {

// A face of a convex polytope given by its extreme points: one is a vertex, two an edge, more a facet.
ContactKind kind_of(std::size_t corners_of_a, std::size_t corners_of_b) {
  if (corners_of_a >= 3) {
    return corners_of_b == 1 ? ContactKind::facet_vertex : corners_of_b == 2 ? ContactKind::facet_edge : ContactKind::facet_facet;
  }
  if (corners_of_b >= 3) return corners_of_a == 1 ? ContactKind::vertex_facet : ContactKind::edge_facet;
  if (corners_of_a == 2 && corners_of_b == 2) return ContactKind::edge_edge;
  throw std::logic_error("the faces in an optimal direction do not span a facet");
}

ExtremeFace face(const kernels::PointCloud& body, const Vector& u) {
  ExtremeFace face;
  face.ids = kernels::extreme_points(body, u);
  for (const std::uint32_t i : face.ids) face.points.push_back(body[i]);
  if (face.ids.size() == 1) return face;
  polytope::Polytope hull = polytope::convex_hull(face.points);
  for (std::uint32_t& id : hull.input_ids) id = face.ids[id];
  return {std::move(hull.vertices), std::move(hull.input_ids)};
}

Vector scaled(const mpz_class& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }

Point plus(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }

Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

// The point of the edge a0 a1 that lies over the line b0 b1, seen along n. The edges are not parallel.
Point over_line(const polytope::PlacedPair& pair, const std::vector<Vector>& a, const std::vector<Vector>& b, const Vector& n) {
  const Vector along = a[1] - a[0], across = cross(b[1] - b[0], n);
  const mpz_class divisor = dot(along, across), share = dot(Vector(b[0] - a[0]), across);
  return pair.position(scaled(divisor, a[0]) + scaled(share, along), divisor);
}

}  // namespace

FacingFaces facing_faces(const polytope::PlacedPair& pair, const Vector& n) { return {face(pair.a, -n), face(pair.b, n)}; }

Point combination(const polytope::PlacedPair& pair, std::span<const Vector> points, const std::vector<Weight>& weights) {
  Point sum;
  for (const Weight& w : weights) {
    const Point p = pair.position(points[w.index]);
    sum.x += w.weight * p.x;
    sum.y += w.weight * p.y;
    sum.z += w.weight * p.z;
  }
  return sum;
}

Optimum optimum(const polytope::PlacedPair& pair, const Vector& n, const FacingFaces& faces) {
  const mpq_class factor = kernels::ratio(dot(n, faces.b.points.front() - faces.a.points.front()), dot(n, n) * pair.denominator);
  return {n, {factor * n.x, factor * n.y, factor * n.z}, {kind_of(faces.a.ids.size(), faces.b.ids.size()), faces.a.ids, faces.b.ids}};
}

// The faces F_A + v / d and F_B share a point exactly if d F_A + v and d F_B do: integers again.
std::optional<Witness> meeting_points(const polytope::PlacedPair& pair, const FacingFaces& faces, const Vector& v, const mpz_class& d) {
  std::vector<Vector> moved_a, scaled_b;
  for (const Vector& p : faces.a.points) moved_a.push_back(scaled(d, p) + v);
  for (const Vector& p : faces.b.points) scaled_b.push_back(scaled(d, p));
  const polytope::PlacedPair moved = polytope::place_integers(std::move(moved_a), std::move(scaled_b));
  const polytope::PositionOfOrigin common = polytope::position_of_origin(moved.a, moved.b);
  if (common.position == polytope::Position::outside) return std::nullopt;
  return Witness{combination(pair, faces.a.points, common.a), combination(pair, faces.b.points, common.b)};
}

Witness witness(const polytope::PlacedPair& pair, const Optimum& optimum, const FacingFaces& faces) {
  const Point& t = optimum.translation;
  const std::vector<Vector>&a = faces.a.points, &b = faces.b.points;
  if (b.size() == 1) {
    const Point p = pair.position(b[0]);
    return {minus(p, t), p};
  }
  if (a.size() > 2 || (a.size() == 2 && b.size() > 2)) {
    const Vector& n = optimum.direction;
    const std::optional<Witness> common = meeting_points(pair, faces, scaled(dot(n, b.front() - a.front()), n), dot(n, n));
    if (!common) throw std::logic_error("the faces in an optimal direction do not meet");
    return *common;
  }
  const Point p = a.size() == 1 ? pair.position(a[0]) : over_line(pair, a, b, optimum.direction);
  return {p, plus(p, t)};
}

void require_listed(const std::optional<std::size_t>& listed) {
  if (listed == 0U) throw std::invalid_argument("at least one optimum must be listed");
}

void list_first(Penetration& penetration, const std::optional<std::size_t>& listed) {
  const std::size_t all = penetration.optima.size();
  if (!listed || all <= *listed) return;
  penetration.optima.resize(*listed);
  penetration.unlisted += all - *listed;
}

Penetration penetration_along(const polytope::PlacedPair& pair, const std::vector<Vector>& nearest, std::optional<std::size_t> listed) {
  Penetration result;
  result.unlisted = nearest.size() - std::min(nearest.size(), listed.value_or(nearest.size()));
  for (const Vector& n : std::span(nearest).first(nearest.size() - result.unlisted)) {
    const FacingFaces faces = facing_faces(pair, n);
    result.optima.push_back(optimum(pair, n, faces));
    if (result.optima.size() == 1) result.witness = witness(pair, result.optima.front(), faces);
  }
  const Point& t = result.optima.front().translation;
  result.squared = t.x * t.x + t.y * t.y + t.z * t.z;
  return result;
}

}  // namespace fathom::depth
