// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/shape_names.hpp"

#include <algorithm>
#include <stdexcept>

namespace fathom::files {
namespace {

constexpr NumberField margin{"margin", 1};
constexpr std::string_view rounded_prefix = "rounded_";

const mpq_class& number(const ShapeFields& fields, std::string_view name) { return fields.numbers.find(name)->second.front(); }

Point triple(const ShapeFields& fields, std::string_view name) {
  const std::vector<mpq_class>& numbers = fields.numbers.find(name)->second;
  return {numbers[0], numbers[1], numbers[2]};
}

Shape made_sphere(const ShapeFields& f) { return sphere(number(f, "radius")); }
Shape made_capsule(const ShapeFields& f) { return capsule(number(f, "radius"), number(f, "half_length"), f.axis); }
Shape made_tapered_capsule(const ShapeFields& f) {
  return tapered_capsule(number(f, "radius_low"), number(f, "radius_high"), number(f, "half_length"), f.axis);
}
Shape made_box(const ShapeFields& f) { return box(triple(f, "half")); }
Shape made_cylinder(const ShapeFields& f) { return cylinder(number(f, "radius"), number(f, "half_length"), f.axis); }
Shape made_cone(const ShapeFields& f) { return cone(number(f, "radius"), number(f, "half_length"), f.axis); }
Shape made_frustum(const ShapeFields& f) {
  return frustum(number(f, "radius_low"), number(f, "radius_high"), number(f, "half_length"), f.axis);
}
Shape made_ellipsoid(const ShapeFields& f) { return ellipsoid(triple(f, "radii")); }
Shape made_hull(const ShapeFields& f) { return hull(f.vertices); }
Shape made_halfspace(const ShapeFields& f) { return halfspace(triple(f, "normal"), number(f, "offset")); }

Shape made_triangle(const ShapeFields& f) {
  if (f.vertices.size() != 3) throw std::invalid_argument("a triangle has three vertices, found " + std::to_string(f.vertices.size()));
  return triangle(f.vertices[0], f.vertices[1], f.vertices[2]);
}

Shape made_sum(const ShapeFields& f) {
  if (f.terms.empty()) throw std::invalid_argument("a sum has at least one term, found none");
  Shape sum = f.terms.front();
  for (std::size_t i = 1; i < f.terms.size(); ++i) sum = minkowski_sum(sum, f.terms[i]);
  return sum;
}

const std::vector<ShapeName>& names() {
  constexpr NumberField radius{"radius", 1}, half_length{"half_length", 1}, low{"radius_low", 1}, high{"radius_high", 1};
  static const std::vector<ShapeName> all{
      {"sphere", {radius}, ShapePart::none, made_sphere},
      {"capsule", {radius, half_length}, ShapePart::axis, made_capsule},
      {"tapered_capsule", {low, high, half_length}, ShapePart::axis, made_tapered_capsule},
      {"box", {{"half", 3}}, ShapePart::none, made_box},
      {"cylinder", {radius, half_length}, ShapePart::axis, made_cylinder},
      {"cone", {radius, half_length}, ShapePart::axis, made_cone},
      {"frustum", {low, high, half_length}, ShapePart::axis, made_frustum},
      {"ellipsoid", {{"radii", 3}}, ShapePart::none, made_ellipsoid},
      {"hull", {}, ShapePart::vertices, made_hull},
      {"triangle", {}, ShapePart::vertices, made_triangle},
      {"halfspace", {{"normal", 3}, {"offset", 1}}, ShapePart::none, made_halfspace},
      {"sum", {}, ShapePart::terms, made_sum},
  };
  return all;
}

}  // namespace

std::span<const ShapeName> shape_names() { return names(); }

NamedShape named_shape(std::string_view name) {
  const bool rounded = name.starts_with(rounded_prefix);
  if (rounded) name.remove_prefix(rounded_prefix.size());
  for (const ShapeName& shape : names())
    if (shape.name == name) return {&shape, rounded};
  return {};
}

const NumberField* number_field(std::string_view name) {
  if (name == margin.name) return &margin;
  for (const ShapeName& shape : names())
    for (const NumberField& field : shape.numbers)
      if (field.name == name) return &field;
  return nullptr;
}

bool has_number(const ShapeName& shape, std::string_view name) {
  return name == margin.name ||
         std::any_of(shape.numbers.begin(), shape.numbers.end(), [&](const NumberField& field) { return field.name == name; });
}

std::string list_of_shapes() {
  std::string list;
  for (const ShapeName& shape : names()) list += (list.empty() ? "" : ", ") + std::string(shape.name);
  return list;
}

Shape shape_of(const Body& body) { return body.shape ? *body.shape : hull(body.points); }

Body body_of(Shape shape) {
  const std::optional<std::vector<Point>> points = shape.radius == 0 ? points_of(shape) : std::nullopt;
  Body body;
  if (points) body.points = *points;
  else body.shape = std::move(shape);
  return body;
}

std::optional<std::vector<Point>> points_of(const Shape& shape) {
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  if (!terms || terms->size() != 1) return std::nullopt;
  std::vector<Point> points;
  for (const Atom& atom : terms->front().atoms) {
    if (!atom.axes.empty()) return std::nullopt;
    points.push_back(atom.center);
  }
  return points;
}

Shape made_shape(const ShapeName& shape, const ShapeFields& fields) {
  Shape result = shape.made(fields);
  return fields.numbers.contains(margin.name) ? with_margin(std::move(result), number(fields, margin.name)) : result;
}

}  // namespace fathom::files
