// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/body_pair.hpp"

#include <algorithm>

#include "reference/polytope/position.hpp"

namespace fathom {
namespace {

Polytope hull(const std::vector<Vector>& points, const ReportProgress& progress, const char* stage) {
  report(progress, stage);
  return convex_hull(points);
}

Status status_of(Position position) {
  switch (position) {
    case Position::inside: return Status::penetrating;
    case Position::boundary: return Status::touching;
    case Position::outside: break;
  }
  return Status::disjoint;
}

std::vector<Vector> chosen(const std::vector<Vector>& points, const std::vector<std::uint32_t>& indices, const mpz_class& factor,
                           const Vector& shift) {
  std::vector<Vector> result;
  for (const std::uint32_t i : indices) {
    const Vector& p = points[i];
    result.push_back(Vector{factor * p.x, factor * p.y, factor * p.z} + shift);
  }
  return result;
}

std::vector<Vector> chosen(const std::vector<Vector>& points, const std::vector<std::uint32_t>& indices) {
  return chosen(points, indices, 1, {0, 0, 0});
}

}  // namespace

void report(const ReportProgress& progress, const char* stage, double share) {
  if (progress && !progress(stage, share)) throw Interrupted();
}

BodyPair::Solid::Solid(const Lattice& lattice, long exponent, const ReportProgress& progress)
    : hull_a(hull(lattice.a, progress, "hull of a")),
      hull_b(lattice.a == lattice.b ? hull_a : hull(lattice.b, progress, "hull of b")),
      hierarchy_a(hull_a),
      hierarchy_b(hull_b),
      bodies{lattice, hull_a, hull_b, PointCloud(hull_a.vertices, exponent), PointCloud(hull_b.vertices, exponent)} {}

BodyPair::BodyPair(std::span<const Point> a, std::span<const Point> b, const ReportProgress& progress) : lattice_(common_lattice(a, b)) {
  const long exponent = std::max(binary_exponent(lattice_.a), binary_exponent(lattice_.b));
  const PositionOfOrigin origin = position_of_origin(PointCloud(lattice_.a, exponent), PointCloud(lattice_.b, exponent));
  status_ = status_of(origin.position);
  separating_ = origin.normal;
  flat_a_ = affine_rank(lattice_.a) < 3;
  flat_b_ = affine_rank(lattice_.b) < 3;
  if (status_ == Status::penetrating) solid_ = std::make_unique<const Solid>(lattice_, exponent, progress);
}

Point BodyPair::translation(const mpq_class& factor, const Vector& u) const {
  const mpq_class s = factor / lattice_.denominator;
  return {s * u.x, s * u.y, s * u.z};
}

Contact BodyPair::contact(const Vector& n) const { return optimum(solid_->bodies, n).contact; }

// With t = v / d for an integer vector v, the faces F_A + t and F_B share a point exactly if d F_A + v and d F_B do.
std::optional<Witness> BodyPair::witness(const Vector& n, const Point& t) const {
  const mpz_class d = lcm(lcm(t.x.get_den(), t.y.get_den()), t.z.get_den());
  const mpq_class s = lattice_.denominator * d;
  const Vector v{mpq_class(s * t.x).get_num(), mpq_class(s * t.y).get_num(), mpq_class(s * t.z).get_num()};
  const Bodies& bodies = solid_->bodies;
  const std::vector<std::uint32_t> face_a = extreme_points(bodies.vertices_a, -n), face_b = extreme_points(bodies.vertices_b, n);
  std::vector<Vector> moved_a = chosen(bodies.a.vertices, face_a, d, v), scaled_b = chosen(bodies.b.vertices, face_b, d, {0, 0, 0});
  const long exponent = std::max(binary_exponent(moved_a), binary_exponent(scaled_b));
  const PositionOfOrigin common = position_of_origin(PointCloud(std::move(moved_a), exponent), PointCloud(std::move(scaled_b), exponent));
  if (common.position == Position::outside) return std::nullopt;
  return Witness{combination(lattice_, chosen(bodies.a.vertices, face_a), common.a),
                 combination(lattice_, chosen(bodies.b.vertices, face_b), common.b)};
}

}  // namespace fathom
