// SPDX-License-Identifier: GPL-3.0-or-later
// Of bodies.hpp: the makers of shapes, and bodies made of others. All have the words by which a case describes them.
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/src/bodies.hpp"
#include "fathom/shape.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::python {
namespace {

Axis axis_from(const std::string& axis) {
  if (axis == "x") return Axis::x;
  if (axis == "y") return Axis::y;
  if (axis == "z") return Axis::z;
  throw py::value_error("expected the axis 'x', 'y' or 'z', found '" + axis + "'");
}

/// The words for a convex body: those that it has, or a hull of its points.
files::NamedBody words_of(const Body& body) {
  if (convex(body).words) return *body.words;
  if (body.shape) throw std::logic_error("a shape has no words");
  return files::named_hull(body.points.exact());
}

using Numbers = std::vector<mpq_class>;

Numbers one(const py::object& number) { return {number_from(number)}; }

Numbers three(const py::object& numbers) {
  const Point p = point_from(numbers);
  return {p.x, p.y, p.z};
}

/// With the words for it.
Body shape(const char* name, files::NumbersByName numbers, const std::string& axis = "z") {
  return files::body_of(files::named(name, numbers, axis_from(axis)));
}

}  // namespace

Body body_with_margin(const Body& body, const mpq_class& margin) {
  Body result = files::body_of(with_margin(files::shape_of(convex(body)), margin));
  files::NamedBody words = words_of(body);
  const auto present = words.fields.numbers.find("margin");
  if (present == words.fields.numbers.end()) words = files::rounded(std::move(words), margin);
  else present->second = {present->second.front() + margin};
  result.words = std::make_shared<const files::NamedBody>(std::move(words));
  return result;
}

Body body_sum(const Body& a, const Body& b) {
  Body result = files::body_of(minkowski_sum(files::shape_of(convex(a)), files::shape_of(convex(b))));
  result.words = std::make_shared<const files::NamedBody>(files::named_sum({words_of(a), words_of(b)}));
  return result;
}

void bind_shapes(py::module_& module) {
  using py::arg;
  using Object = const py::object&;
  using Text = const std::string&;
  module.def(
      "sphere",
      [](Object radius) {
        return shape("sphere", {{"radius", one(radius)}});
      },
      arg("radius"));
  module.def(
      "capsule",
      [](Object radius, Object half_length, Text axis) {
        return shape("capsule", {{"radius", one(radius)}, {"half_length", one(half_length)}}, axis);
      },
      arg("radius"), arg("half_length"), arg("axis") = "z");
  module.def(
      "tapered_capsule",
      [](Object low, Object high, Object half_length, Text axis) {
        return shape("tapered_capsule", {{"radius_low", one(low)}, {"radius_high", one(high)}, {"half_length", one(half_length)}}, axis);
      },
      arg("radius_low"), arg("radius_high"), arg("half_length"), arg("axis") = "z");
  module.def(
      "box",
      [](Object half) {
        return shape("box", {{"half", three(half)}});
      },
      arg("half"));
  module.def(
      "cylinder",
      [](Object radius, Object half_length, Text axis) {
        return shape("cylinder", {{"radius", one(radius)}, {"half_length", one(half_length)}}, axis);
      },
      arg("radius"), arg("half_length"), arg("axis") = "z");
  module.def(
      "cone",
      [](Object radius, Object half_length, Text axis) {
        return shape("cone", {{"radius", one(radius)}, {"half_length", one(half_length)}}, axis);
      },
      arg("radius"), arg("half_length"), arg("axis") = "z");
  module.def(
      "frustum",
      [](Object low, Object high, Object half_length, Text axis) {
        return shape("frustum", {{"radius_low", one(low)}, {"radius_high", one(high)}, {"half_length", one(half_length)}}, axis);
      },
      arg("radius_low"), arg("radius_high"), arg("half_length"), arg("axis") = "z");
  module.def(
      "ellipsoid",
      [](Object radii) {
        return shape("ellipsoid", {{"radii", three(radii)}});
      },
      arg("radii"));
  module.def(
      "halfspace",
      [](Object normal, Object offset) {
        return shape("halfspace", {{"normal", three(normal)}, {"offset", one(offset)}});
      },
      arg("normal"), arg("offset"));
}

}  // namespace fathom::python
