// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as cases name them: what was read, and what can be printed again.                                          [docs/shapes.md]
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/shape.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::files {

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

/// Returns the shape that this is, placed: that of the case that is printed of it. Throws std::invalid_argument where its fields are bad.
Shape shape_of(const NamedBody& body);

/// The body that this is, with these words.
Body body_of(NamedBody body);

}  // namespace fathom::files
