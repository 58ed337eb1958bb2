// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes by name, as sums of terms and a radius, and their poses; of fathom/shape.hpp. And which
// way a rigid motion turns; of fathom/impact.hpp.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "fathom/impact.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/pose.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::shapes {
namespace {

void require_positive(const mpq_class& value, const char* what) {
  kernels::require_lowest_terms(value);
  if (value <= 0) throw std::invalid_argument(std::string(what) + " is not positive: " + value.get_str());
}

Point along(Axis axis, const mpq_class& length) {
  Point p;
  (axis == Axis::x ? p.x : axis == Axis::y ? p.y : p.z) = length;
  return p;
}

Atom point(Point p) { return {std::move(p), {}}; }

Atom ball(Point center, const mpq_class& radius) {
  return {std::move(center), {along(Axis::x, radius), along(Axis::y, radius), along(Axis::z, radius)}};
}

// Orthogonal to the axis.
Atom disc(Axis axis, const mpq_class& place, const mpq_class& radius) {
  const Axis u = axis == Axis::x ? Axis::y : Axis::x, v = axis == Axis::z ? Axis::y : Axis::z;
  return {along(axis, place), {along(u, radius), along(v, radius)}};
}

Shape of_atoms(std::vector<Atom> atoms, const mpq_class& radius = 0) {
  return {std::vector<Term>{{std::move(atoms)}}, radius};
}

// ---- poses ----

using Row = std::array<mpq_class, 4>;

// Of rows i and j, without the translations.
Point cross_product(const Row& u, const Row& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

void require_numbers(const Pose& pose) {
  for (const Row& row : pose)
    for (const mpq_class& x : row) kernels::require_lowest_terms(x);
}

// The transpose of the inverse matrix, which maps normals of planes. Its rows are cross products
// over the determinant.
Pose normal_map(const Pose& pose) {
  const Point x = cross_product(pose[1], pose[2]), y = cross_product(pose[2], pose[0]),
              z = cross_product(pose[0], pose[1]);
  const mpq_class determinant = pose[0][0] * x.x + pose[0][1] * x.y + pose[0][2] * x.z;
  if (determinant == 0) throw std::invalid_argument("the matrix of a pose is singular");
  const auto row = [&](const Point& p) { return Row{p.x / determinant, p.y / determinant, p.z / determinant, 0}; };
  return {row(x), row(y), row(z)};
}

HalfSpace moved_core(const HalfSpace& half, const Pose& pose) {
  const Point n = files::placed(half.normal, normal_map(pose));
  return {n, half.offset + n.x * pose[0][3] + n.y * pose[1][3] + n.z * pose[2][3]};
}

std::vector<Term> moved_core(std::vector<Term> terms, const Pose& pose) {
  Pose linear = pose;
  for (Row& row : linear) row[3] = 0;
  // The sum of the terms moves once.
  const Pose* of_points = &pose;
  for (Term& term : terms) {
    for (Atom& atom : term.atoms) {
      atom.center = files::placed(atom.center, *of_points);
      for (Point& axis : atom.axes) axis = files::placed(axis, linear);
    }
    of_points = &linear;
  }
  return terms;
}

}  // namespace
}  // namespace fathom::shapes

namespace fathom {

Shape sphere(const mpq_class& radius) {
  shapes::require_positive(radius, "the radius of a sphere");
  return shapes::of_atoms({shapes::point({})}, radius);
}

Shape capsule(const mpq_class& radius, const mpq_class& half_length, Axis axis) {
  shapes::require_positive(radius, "the radius of a capsule");
  shapes::require_positive(half_length, "the half length of a capsule");
  return shapes::of_atoms(
      {shapes::point(shapes::along(axis, -half_length)), shapes::point(shapes::along(axis, half_length))}, radius);
}

// The smaller radius is that of the shape, so that at least one of the balls is a point.
Shape tapered_capsule(const mpq_class& low, const mpq_class& high, const mpq_class& half_length, Axis axis) {
  shapes::require_positive(low, "a radius of a tapered capsule");
  shapes::require_positive(high, "a radius of a tapered capsule");
  shapes::require_positive(half_length, "the half length of a tapered capsule");
  const mpq_class radius = std::min(low, high);
  const auto end = [&](const mpq_class& place, const mpq_class& of_end) {
    return of_end == radius ? shapes::point(shapes::along(axis, place))
                            : shapes::ball(shapes::along(axis, place), of_end - radius);
  };
  return shapes::of_atoms({end(-half_length, low), end(half_length, high)}, radius);
}

Shape box(const Point& half) {
  for (const mpq_class* length : {&half.x, &half.y, &half.z})
    shapes::require_positive(*length, "a half length of a box");
  std::vector<Atom> corners;
  for (const int z : {-1, 1})
    for (const int y : {-1, 1})
      for (const int x : {-1, 1}) corners.push_back(shapes::point({x * half.x, y * half.y, z * half.z}));
  return shapes::of_atoms(std::move(corners));
}

Shape cylinder(const mpq_class& radius, const mpq_class& half_length, Axis axis) {
  shapes::require_positive(radius, "the radius of a cylinder");
  shapes::require_positive(half_length, "the half length of a cylinder");
  return shapes::of_atoms({shapes::disc(axis, -half_length, radius), shapes::disc(axis, half_length, radius)});
}

Shape cone(const mpq_class& radius, const mpq_class& half_length, Axis axis) {
  shapes::require_positive(radius, "the radius of a cone");
  shapes::require_positive(half_length, "the half length of a cone");
  return shapes::of_atoms({shapes::disc(axis, -half_length, radius), shapes::point(shapes::along(axis, half_length))});
}

Shape frustum(const mpq_class& low, const mpq_class& high, const mpq_class& half_length, Axis axis) {
  shapes::require_positive(low, "a radius of a frustum");
  shapes::require_positive(high, "a radius of a frustum");
  shapes::require_positive(half_length, "the half length of a frustum");
  return shapes::of_atoms({shapes::disc(axis, -half_length, low), shapes::disc(axis, half_length, high)});
}

Shape ellipsoid(const Point& radii) {
  for (const mpq_class* length : {&radii.x, &radii.y, &radii.z})
    shapes::require_positive(*length, "a radius of an ellipsoid");
  return shapes::of_atoms(
      {{{}, {shapes::along(Axis::x, radii.x), shapes::along(Axis::y, radii.y), shapes::along(Axis::z, radii.z)}}});
}

Shape hull(std::span<const Point> vertices) {
  std::vector<Atom> atoms;
  atoms.reserve(vertices.size());
  for (const Point& p : vertices) atoms.push_back(shapes::point(p));
  Shape shape = shapes::of_atoms(std::move(atoms));
  shapes::require_shape(shape);
  return shape;
}

Shape triangle(const Point& p, const Point& q, const Point& r) { return hull(std::array{p, q, r}); }

Shape halfspace(const Point& normal, const mpq_class& offset) {
  Shape shape{HalfSpace{normal, offset}, 0};
  shapes::require_shape(shape);
  return shape;
}

Shape with_margin(Shape shape, const mpq_class& margin) {
  kernels::require_lowest_terms(margin);
  if (margin < 0) throw std::invalid_argument("a margin is negative: " + margin.get_str());
  shape.radius += margin;
  return shape;
}

Shape minkowski_sum(const Shape& a, const Shape& b) {
  if (std::holds_alternative<HalfSpace>(a.core) || std::holds_alternative<HalfSpace>(b.core))
    throw std::invalid_argument("a half-space cannot be a part of a sum");
  std::vector<Term> terms = std::get<std::vector<Term>>(a.core);
  const std::vector<Term>& more = std::get<std::vector<Term>>(b.core);
  terms.insert(terms.end(), more.begin(), more.end());
  return {std::move(terms), a.radius + b.radius};
}

Pose rigid_pose(const Quaternion& rotation, const Point& translation) {
  const auto& [w, x, y, z] = rotation;
  for (const mpq_class* number : {&w, &x, &y, &z, &translation.x, &translation.y, &translation.z})
    kernels::require_lowest_terms(*number);
  const mpq_class square = w * w + x * x + y * y + z * z;
  if (square == 0) throw std::invalid_argument("the quaternion of a pose is 0");
  const mpq_class s = 2 / square;
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), translation.x},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), translation.y},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y), translation.z}}};
}

RigidMotion shorter_way(RigidMotion motion) {
  const Quaternion& p = motion.q0;
  Quaternion& q = motion.q1;
  if (p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z < 0) q = {-q.w, -q.x, -q.y, -q.z};
  return motion;
}

Shape moved(const Shape& shape, const Pose& pose) {
  shapes::require_shape(shape);
  shapes::require_numbers(pose);
  shapes::normal_map(pose);  // throws if the matrix is singular
  return std::visit([&](const auto& core) { return Shape{shapes::moved_core(core, pose), shape.radius}; }, shape.core);
}

}  // namespace fathom
