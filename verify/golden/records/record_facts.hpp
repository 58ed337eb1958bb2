// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a record says, as exact values. Serialization is canonical: equal facts give equal bytes.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/records/recipe.hpp"
#include "verify/golden/records/rounded.hpp"

namespace fathom::golden {

/// The results as records print them. All modes of a number are rounded at once, and once.
struct RoundedResults {
  Rounded depth{}, distance{};  ///< the distance of disjoint bodies, else 0
  /// Of each optimum; else of the direction, and if disjoint of the distance's translation.
  std::vector<RoundedVector> units, translations;
};

struct Facts {
  Recipe recipe;
  Form form = Form::given;
  Case points;  ///< its id is the record's; in binary64 where they can be
  bool in_binary64 = false, in_binary32 = false;

  Depth answer;                  ///< its method and counters are not recorded
  std::optional<mpq_class> gap;  ///< penetrating: squared distance of the second-best facet, unless all tie
  RoundedResults rounded;

  std::string certificate_sha256;
  std::vector<std::string_view> flags;  ///< in the order of flags.hpp
};

/// Returns the part that needs no answer.
Facts facts_of_points(const Recipe& recipe, Form form, const Case& points);

/// Returns what a record says of these points; `answer` is that of penetration_depth. Throws Interrupted.
Facts facts_of_answer(const Recipe& recipe, Form form, const Case& points, Depth answer, Monitor* monitor = nullptr,
                      Workspace* workspace = nullptr);

}  // namespace fathom::golden
