// SPDX-License-Identifier: GPL-3.0-or-later
// The order of a shard's records: recipe by recipe as planned, of each the exact record, then the rounded ones. So no id occurs twice and
// none is missing. Checked in O(1) memory.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

class RecordOrder {
 public:
  /// `recipes` must outlive this.
  explicit RecordOrder(const std::vector<Recipe>& recipes) : recipes_(&recipes) {}

  /// Returns what is wrong with `id` as the next one, or nullopt. If it is the first of its recipe, `ids` must be those of all its
  /// records: of cases_of(recipe).
  std::optional<std::string> next(std::string_view id, const std::vector<std::string>& ids);
  /// Returns what is missing at the end, or nullopt.
  [[nodiscard]] std::optional<std::string> at_end() const;

 private:
  /// Returns the id that has to come next, or "" after the last one.
  [[nodiscard]] std::string expected() const;

  const std::vector<Recipe>* recipes_;
  std::size_t begun_ = 0;             // recipes whose first record was seen
  std::vector<std::string> awaited_;  // the records of the last of them
  std::size_t seen_ = 0;              // how many of these
};

}  // namespace fathom::golden
