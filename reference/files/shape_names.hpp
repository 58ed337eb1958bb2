// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes that input may name, the fields of each, and bodies in such words: one vocabulary for
// JSON and for the command line.
//                                                                            [docs/command_line.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "reference/files/pose.hpp"

namespace fathom::files {

/// The fields of one shape, as they were read.
struct ShapeFields {
  std::map<std::string, std::vector<mpq_class>, std::less<>> numbers;  ///< one or three of each name
  Axis axis = Axis::z;
  std::vector<Point> vertices;
  std::vector<Shape> terms;
};

/// A field that is one number, or three; of the plane two.
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
  /// of complete fields. Throws std::invalid_argument with a sentence about their values
  Shape (*made)(const ShapeFields&);
};

/// All of them; those of space, or with dimension 2 those of the plane.
std::span<const ShapeName> shape_names(unsigned dimension = 3);

/// A shape as input names it: "rounded_box" is a box that must have a margin.
struct NamedShape {
  const ShapeName* shape = nullptr;  ///< null if there is none of this name
  bool rounded = false;
};
NamedShape named_shape(std::string_view name, unsigned dimension = 3);

/// Returns the number field called `name` of any shape of space, or of this shape, "margin"
/// included; null if there is none.
const NumberField* number_field(std::string_view name);
const NumberField* number_field(const ShapeName& shape, std::string_view name);

/// "sphere, capsule, ...", for messages.
std::string list_of_shapes(unsigned dimension = 3);

/// The shape of these fields, with its margin if there is one. Throws as ShapeName::made does.
Shape made_shape(const ShapeName& shape, const ShapeFields& fields);

/// The atoms' points, if the core is the hull of points, with no term beside it.
std::optional<std::vector<Point>> points_of(const Shape& shape);

/// The body as a shape: a polytope is the hull of its points.
Shape shape_of(const Body& body);

/// The body that this shape is: its points, if it is the hull of points and has no radius.
Body body_of(Shape shape);

// ---- as cases name them: what was read, and what can be printed again ----       [docs/shapes.md]

/// A shape by its name and its fields, turned and then moved; or placed by a matrix.
struct NamedBody {
  std::string shape;                  ///< "capsule", "rounded_box": a name that named_shape knows
  ShapeFields fields = {};            ///< without terms, which have names too
  std::vector<NamedBody> terms = {};  ///< of a sum
  Quaternion turn = {1, 0, 0, 0};
  Point place = {};
  std::optional<Pose> matrix = std::nullopt;  ///< if set, in the place of `turn` and `place`
};

using NumbersByName = std::initializer_list<std::pair<const char*, std::vector<mpq_class>>>;
NamedBody named(std::string shape, NumbersByName numbers, Axis axis = Axis::z);
NamedBody named_hull(std::vector<Point> vertices);
NamedBody named_sum(std::vector<NamedBody> terms);
/// "rounded_..." of a body that has no margin.
NamedBody rounded(NamedBody body, const mpq_class& margin);

/// The body after a further turn about O and translation.
NamedBody posed(NamedBody body, const Quaternion& turn, const Point& place);

/// The same of a further pose of any kind.
NamedBody posed(NamedBody body, const GivenPose& pose);

/// The pose that the body has.
Pose pose_of(const NamedBody& body);

/// Returns the shape that this is, placed: that of the case that is printed of it. Throws
/// std::invalid_argument where its fields are bad.
Shape shape_of(const NamedBody& body);

/// The body that this is, with these words.
Body body_of(NamedBody body);

// ---- in one word of the command line ----

/// Returns whether the word stands for a shape and not for a file: it begins with the name of a
/// shape and a colon, "capsule:r=0.1,h=0.5", or with another word of small letters and a colon, and
/// there are fields behind: `parse_shape` then says which shapes there are. "plane:" may stand in
/// front.
bool is_shape_text(const std::string& word);

/// Reads NAME:FIELD=VALUE,... with the fields of JSON, `r` for radius and `h` for half_length.
/// Three numbers are joined by colons: box:half=1:2:3. `at` moves the shape, `quaternion` turns it
/// before (w:x:y:z), `axis` is x, y or z. With "plane:" in front it is one of the plane:
/// plane:box:half=1:2,at=3:4,half_angle=1/2. Hulls, triangles and sums have no such form. Throws
/// InputError with a sentence on the first fault. `decimals` says what a decimal stands for.
Body parse_shape(const std::string& word, Decimals decimals);

}  // namespace fathom::files
