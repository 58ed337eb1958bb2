// SPDX-License-Identifier: GPL-3.0-or-later
// A sample of a level that every kind of case is in.
#pragma once

#include <vector>

#include "verify/golden/shards/plan.hpp"

namespace fathom::golden::testing {

/// Every `step`-th recipe.
inline std::vector<Recipe> some_recipes(std::size_t step, Level level = Level::L0) {
  std::vector<Recipe> result;
  std::size_t i = 0;
  for (const ShardPlan& shard : plan(level, 1)) {
    for (const Recipe& recipe : shard.recipes()) {
      if (i++ % step == 0) result.push_back(recipe);
    }
  }
  return result;
}

}  // namespace fathom::golden::testing
