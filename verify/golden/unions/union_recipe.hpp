// SPDX-License-Identifier: GPL-3.0-or-later
// What a base case of unions is made from, and how its points are rounded: recipe.hpp for bodies of convex pieces.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// What is known of an answer by construction.
struct KnownUnion {
  Status status = Status::disjoint;
  mpq_class squared;       ///< depth^2, or the squared distance if they are disjoint
  std::size_t optima = 0;  ///< 0 unless they penetrate
};

/// The unions of one record.
struct FormedUnions {
  Form form = Form::given;
  Case unions;  ///< its id is the record's
  /// Beside given ones only. An entry of the catalogue states it; of convex bodies that were cut it is the answer about the hulls.
  std::optional<KnownUnion> known;
};

/// Whether every coordinate of all pieces is a number of that format.
bool unions_in_format(const Case& unions, Form format);

/// Returns the unions with each coordinate rounded to the nearest, and the id as it was. Returns nullopt if a coordinate overflows, or if a
/// piece becomes flat. Pieces that abutted may overlap then, or leave a gap.
std::optional<Case> rounded_unions(const Case& base, Form form);

/// Returns the unions of all records of a recipe in their order, as cases_of does for points. Throws std::invalid_argument if nothing has
/// that name.
std::vector<FormedUnions> union_cases_of(const Recipe& recipe);

}  // namespace fathom::golden
