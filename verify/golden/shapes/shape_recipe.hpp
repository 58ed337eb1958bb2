// SPDX-License-Identifier: GPL-3.0-or-later
// What a base case of shapes is made from, and how its numbers are rounded: recipe.hpp for bodies that are no points.
#pragma once

#include <optional>
#include <vector>

#include "verify/families/shape_families.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// The shapes of one record.
struct FormedShapes {
  Form form = Form::given;
  families::ShapeCase shapes;  ///< its id is the record's; what is known of the answer stands beside the given ones only
};

/// Whether every number of the bodies is one of that format: lengths, margins, points, and the parts of quaternions and places.
bool in_format(const families::NamedPair& shapes, Form format);

/// Returns the bodies with each number rounded to the nearest. Returns nullopt if a number overflows, or if what results is no shape: where
/// a length is rounded to 0, or a quaternion.
std::optional<families::NamedPair> rounded_shapes(const families::NamedPair& base, Form form);

/// Returns the shapes of all records of a recipe in their order, as cases_of does for points. Throws std::invalid_argument if nothing has
/// that name.
std::vector<FormedShapes> shape_cases_of(const Recipe& recipe);

}  // namespace fathom::golden
