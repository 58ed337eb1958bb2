// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes that input may name, and the fields of each: one vocabulary for JSON and for the command line.  [docs/command_line.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/shape.hpp"

namespace fathom::files {

/// The fields of one shape, as they were read.
struct ShapeFields {
  std::map<std::string, std::vector<mpq_class>, std::less<>> numbers;  ///< one or three of each name
  Axis axis = Axis::z;
  std::vector<Point> vertices;
  std::vector<Shape> terms;
};

/// A field that is one number, or three.
struct NumberField {
  std::string_view name;
  std::size_t count;
};

/// What a shape has beside its numbers.
enum class ShapePart { none, axis, vertices, terms };

/// A shape by its name. Its fields are all required, but for the axis.
struct ShapeName {
  std::string_view name;
  std::vector<NumberField> numbers;
  ShapePart part;
  Shape (*made)(const ShapeFields&);  ///< of complete fields. Throws std::invalid_argument with a sentence about their values
};

/// All of them.
std::span<const ShapeName> shape_names();

/// A shape as input names it: "rounded_box" is a box that must have a margin.
struct NamedShape {
  const ShapeName* shape = nullptr;  ///< null if there is none of this name
  bool rounded = false;
};
NamedShape named_shape(std::string_view name);

/// Returns the number field called `name` of any shape, "margin" included; null if no shape has one.
const NumberField* number_field(std::string_view name);

/// Returns whether this shape has the number field called `name`. Each has a margin.
bool has_number(const ShapeName& shape, std::string_view name);

/// "sphere, capsule, ...", for messages.
std::string list_of_shapes();

/// The shape of these fields, with its margin if there is one. Throws as ShapeName::made does.
Shape made_shape(const ShapeName& shape, const ShapeFields& fields);

/// The atoms' points, if the core is the hull of points, with no term beside it.
std::optional<std::vector<Point>> points_of(const Shape& shape);

/// The body as a shape: a polytope is the hull of its points.
Shape shape_of(const Body& body);

/// The body that this shape is: its points, if it is the hull of points and has no radius.
Body body_of(Shape shape);

}  // namespace fathom::files
