// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies by name, as sums of terms and a radius; of fathom/shape.hpp.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
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

Shape of_atoms(std::vector<Atom> atoms, const mpq_class& radius = 0) { return {std::vector<Term>{{std::move(atoms)}}, radius}; }

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
  return shapes::of_atoms({shapes::point(shapes::along(axis, -half_length)), shapes::point(shapes::along(axis, half_length))}, radius);
}

// The smaller radius is that of the shape, so that at least one of the balls is a point.
Shape tapered_capsule(const mpq_class& low, const mpq_class& high, const mpq_class& half_length, Axis axis) {
  shapes::require_positive(low, "a radius of a tapered capsule");
  shapes::require_positive(high, "a radius of a tapered capsule");
  shapes::require_positive(half_length, "the half length of a tapered capsule");
  const mpq_class radius = std::min(low, high);
  const auto end = [&](const mpq_class& place, const mpq_class& of_end) {
    return of_end == radius ? shapes::point(shapes::along(axis, place)) : shapes::ball(shapes::along(axis, place), of_end - radius);
  };
  return shapes::of_atoms({end(-half_length, low), end(half_length, high)}, radius);
}

Shape box(const Point& half) {
  for (const mpq_class* length : {&half.x, &half.y, &half.z}) shapes::require_positive(*length, "a half length of a box");
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
  for (const mpq_class* length : {&radii.x, &radii.y, &radii.z}) shapes::require_positive(*length, "a radius of an ellipsoid");
  return shapes::of_atoms({{{}, {shapes::along(Axis::x, radii.x), shapes::along(Axis::y, radii.y), shapes::along(Axis::z, radii.z)}}});
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

}  // namespace fathom
