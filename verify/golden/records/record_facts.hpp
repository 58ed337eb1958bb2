// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a record says, as exact values. Its text is made from these in one way only.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

struct Facts {
  Recipe recipe;
  Form form = Form::given;
  Case points;  ///< its id is the record's
  bool in_binary64 = false, in_binary32 = false;

  Status status = Status::disjoint;
  mpq_class squared;  ///< depth^2
  bool flat_a = false, flat_b = false;
  std::vector<Optimum> optima;   ///< penetrating
  std::optional<mpq_class> gap;  ///< penetrating: squared distance of the second-best facet, unless all tie
  Vector direction;              ///< touching: primitive n with h(n) = 0. disjoint: that of the distance, h(n) < 0
  std::optional<Distance> distance;
  std::optional<Witness> witness;  ///< penetrating and touching; that of disjoint bodies is in `distance`

  std::string certificate_sha256;
  std::vector<std::string_view> flags;  ///< in the order of flags.hpp
};

/// The part that needs no answer.
Facts facts_of_points(const Recipe& recipe, Form form, const Case& points);

/// What a record says of these points, answered in the fastest way that proves itself: `answer` is one of penetration_depth.
Facts facts_of_answer(const Recipe& recipe, Form form, const Case& points, const Depth& answer);

}  // namespace fathom::golden
