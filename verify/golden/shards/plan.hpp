// SPDX-License-Identifier: GPL-3.0-or-later
// The cases of a release in their order, as a function of level and seed alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// Five chains, of polytopes, of shapes, of unions, of contacts and of the plane; in each a level's
/// cases are among those of the next. Judging a fast library takes about a second for L0 and P0,
/// seconds for U0, ten seconds for L1 and P1, minutes for L2, two hours for L3.
enum class Level {
  L0,  ///< hundreds of records, bodies of 4 to 12 points
  L1,  ///< about ten thousand, to 30 points
  L2,  ///< about a hundred and fifty thousand, to 200 points, a few to 1000
  L3,  ///< about ten million, to 200 points: for clusters
  P0,  ///< primitives: about a thousand records of shapes, hulls of 4 to 8 points among them
  P1,  ///< about ten thousand, hulls to 30 points
  U0,  ///< unions: hundreds of records, bodies of some 2 to 12 pieces
  C0,  ///< contacts: hundreds of records of polytopes and of shapes, with all points where they touch
  F0   ///< flat: hundreds of records of bodies of the plane, of 3 to 8 points
};

/// "L0", "L1", "L2", "L3", "P0", "P1", "U0", "C0", "F0".
std::string_view name_of(Level level);
/// Returns whether its records are of polytopes alone, and have rows of CSV.
constexpr bool of_polytopes(Level level) { return level < Level::P0; }
std::optional<Level> find_level(std::string_view name);

class Additions;

/// One file of records. Its recipes are made on demand, because those of all files may be millions.
struct ShardPlan {
  std::string name;  ///< "golden-L1-0007": the level that adds the shard, and its number there
  Level level = Level::L0;
  std::shared_ptr<const Additions> additions;  ///< the recipes that this level adds
  std::size_t begin = 0, end = 0;              ///< the range of them in this shard

  [[nodiscard]] std::size_t count() const { return end - begin; }
  /// Returns the recipes in their order; at least one.
  [[nodiscard]] std::vector<Recipe> recipes() const;
};

/// Must change whenever the same level and seed yield other records than before.
inline constexpr std::string_view data_version = "1.3.0";

/// All shards of a level: first those of the levels below it, unchanged. No recipe occurs twice.
std::vector<ShardPlan> plan(Level level, std::uint64_t seed);

/// Checks the order of a shard's records in O(1) memory: recipe by recipe as planned, for each the
/// exact record, then the rounded ones. So no id occurs twice and none is missing.
class RecordOrder {
 public:
  /// `recipes` must outlive this.
  explicit RecordOrder(const std::vector<Recipe>& recipes) : recipes_(&recipes) {}

  /// Returns a sentence if `id` is not the expected next one, or nullopt. If it is the first of its
  /// recipe, `ids` must be the ids of cases_of(recipe).
  std::optional<std::string> next(std::string_view id, const std::vector<std::string>& ids);
  /// Returns a sentence on what is missing at the end, or nullopt.
  [[nodiscard]] std::optional<std::string> at_end() const;

 private:
  /// Returns the id expected next, or "" after the last one.
  [[nodiscard]] std::string expected() const;

  const std::vector<Recipe>* recipes_;
  std::size_t begun_ = 0;             // recipes whose first record occurred
  std::vector<std::string> awaited_;  // the ids of the last of these recipes
  std::size_t seen_ = 0;              // how many of them occurred
};

}  // namespace fathom::golden
