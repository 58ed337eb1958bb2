// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/contact.hpp"

#include <algorithm>

namespace fathom {
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

std::vector<std::uint32_t> input_ids(const Polytope& body, const std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint32_t> ids;
  for (const std::uint32_t v : vertices) ids.push_back(body.input_ids[v]);
  return ids;
}

Vector scaled(const mpz_class& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }

std::vector<Vector> chosen(const std::vector<Vector>& points, const std::vector<std::uint32_t>& indices) {
  std::vector<Vector> result;
  for (const std::uint32_t i : indices) result.push_back(points[i]);
  return result;
}

Point plus(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }

Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

// The point of the edge a0 a1 that lies over the line b0 b1, seen along n. The edges are not parallel.
Point over_line(const Lattice& lattice, const std::vector<Vector>& a, const std::vector<Vector>& b, const Vector& n) {
  const Vector along = a[1] - a[0], across = cross(b[1] - b[0], n);
  const mpz_class divisor = dot(along, across), share = dot(Vector(b[0] - a[0]), across);
  return position(lattice, scaled(divisor, a[0]) + scaled(share, along), divisor);
}

// Any common point of F_A + t and F_B. With t = (h / |n|^2) n there is one exactly if |n|^2 F_A + h n and |n|^2 F_B share one: integers again.
Witness common_point(const Bodies& bodies, const Vector& n, const std::vector<Vector>& face_a, const std::vector<Vector>& face_b) {
  const mpz_class square = dot(n, n);
  const Vector shift = scaled(dot(n, face_b.front() - face_a.front()), n);
  std::vector<Vector> moved_a, scaled_b;
  for (const Vector& p : face_a) moved_a.push_back(scaled(square, p) + shift);
  for (const Vector& p : face_b) scaled_b.push_back(scaled(square, p));
  const long exponent = std::max(binary_exponent(moved_a), binary_exponent(scaled_b));
  const PositionOfOrigin common = position_of_origin(PointCloud(std::move(moved_a), exponent), PointCloud(std::move(scaled_b), exponent));
  if (common.position == Position::outside) throw std::logic_error("the faces in an optimal direction do not meet");
  return {combination(bodies.lattice, face_a, common.a), combination(bodies.lattice, face_b, common.b)};
}

}  // namespace

Point combination(const Lattice& lattice, std::span<const Vector> points, const std::vector<Weight>& weights) {
  Point sum;
  for (const Weight& w : weights) {
    const Point p = position(lattice, points[w.index]);
    sum.x += w.weight * p.x;
    sum.y += w.weight * p.y;
    sum.z += w.weight * p.z;
  }
  return sum;
}

Optimum optimum(const Bodies& bodies, const Vector& n) {
  const std::vector<std::uint32_t> face_a = extreme_points(bodies.vertices_a, -n), face_b = extreme_points(bodies.vertices_b, n);
  const mpz_class height = dot(n, bodies.vertices_b[face_b.front()] - bodies.vertices_a[face_a.front()]);
  mpq_class factor(height, dot(n, n) * bodies.lattice.denominator);
  factor.canonicalize();
  return {n,
          {factor * n.x, factor * n.y, factor * n.z},
          {kind_of(face_a.size(), face_b.size()), input_ids(bodies.a, face_a), input_ids(bodies.b, face_b)}};
}

Witness witness(const Bodies& bodies, const Optimum& optimum) {
  const Vector& n = optimum.direction;
  const Point& t = optimum.translation;
  const std::vector<Vector> face_a = chosen(bodies.a.vertices, extreme_points(bodies.vertices_a, -n));
  const std::vector<Vector> face_b = chosen(bodies.b.vertices, extreme_points(bodies.vertices_b, n));
  if (face_b.size() == 1) {
    const Point b = position(bodies.lattice, face_b[0]);
    return {minus(b, t), b};
  }
  if (face_a.size() > 2 || (face_a.size() == 2 && face_b.size() > 2)) return common_point(bodies, n, face_a, face_b);
  const Point a = face_a.size() == 1 ? position(bodies.lattice, face_a[0]) : over_line(bodies.lattice, face_a, face_b, n);
  return {a, plus(a, t)};
}

}  // namespace fathom
