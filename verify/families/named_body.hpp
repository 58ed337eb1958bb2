// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes as cases name them: what is printed in a case, and built from by the reader of cases.                    [docs/shapes.md]
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/shape.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::families {

/// A shape by its name and its fields, turned and then moved.
struct NamedBody {
  std::string shape;                  ///< "capsule", "rounded_box": a name that files::named_shape knows
  files::ShapeFields fields = {};     ///< without terms, which have names too
  std::vector<NamedBody> terms = {};  ///< of a sum
  Quaternion turn = {1, 0, 0, 0};
  Point place = {};
};

using NumbersByName = std::initializer_list<std::pair<const char*, std::vector<mpq_class>>>;
NamedBody named(std::string shape, NumbersByName numbers, Axis axis = Axis::z);
NamedBody named_hull(std::vector<Point> vertices);
NamedBody named_sum(std::vector<NamedBody> terms);
/// "rounded_..." of a body that has no margin.
NamedBody rounded(NamedBody body, const mpq_class& margin);

/// The body after a further turn about O and translation.
NamedBody posed(NamedBody body, const Quaternion& turn, const Point& place);

/// Returns the shape that this is, placed: that of the case that is printed of it. Throws std::invalid_argument where its fields are bad.
Shape shape_of(const NamedBody& body);

/// What is known of the answer by construction.
struct KnownDepth {
  Surd signed_depth;
  std::optional<Point> direction = std::nullopt;  ///< one that attains it, of length 1
};

/// Two bodies that have no id yet.
struct NamedPair {
  NamedBody a, b;
  std::optional<KnownDepth> known = std::nullopt;
};

struct ShapeCase {
  std::string id;
  NamedPair pair;

  /// What a reader finds in the printed case.
  [[nodiscard]] Case read() const;
};

}  // namespace fathom::families
