// SPDX-License-Identifier: GPL-3.0-or-later
// Which cases a release holds: a function of the level and the seed alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// Nested: a level's cases are among those of the next. Judging a fast library takes about a second for L0, ten seconds for L1, minutes for
/// L2.
enum class Level {
  L0,  ///< hundreds of records, bodies of 4 to 12 points
  L1,  ///< about ten thousand, to 30 points
  L2   ///< about a hundred and fifty thousand, to 200 points, a few to 1000
};

/// "L0", "L1", "L2".
std::string_view name_of(Level level);
std::optional<Level> find_level(std::string_view name);

/// The recipes of one file of records, in their order.
struct ShardPlan {
  std::string name;  ///< "golden-L1-0007": the level that the shard is new in, and its number there
  Level level = Level::L0;
  std::vector<Recipe> recipes;
};

/// Must change whenever the same level and seed yield other records than before.
inline constexpr std::string_view data_version = "1.0.0";

/// All shards of a level: first those of the levels below it, unchanged. No recipe occurs twice.
std::vector<ShardPlan> plan(Level level, std::uint64_t seed);

}  // namespace fathom::golden
