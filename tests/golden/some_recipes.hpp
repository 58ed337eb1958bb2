// SPDX-License-Identifier: GPL-3.0-or-later
// A sample of a level that every kind of case is in, and the cases that its records are.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "fathom/files.hpp"
#include "verify/golden/records/record.hpp"
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

inline Case case_of(const Record& record) {
  const CaseItem item = parse_case(record.line, "record");
  EXPECT_TRUE(item.ok()) << record.id << ": " << (item.ok() ? "" : item.error().what());
  EXPECT_EQ(item.id, record.id);
  return item.ok() ? item.value() : Case{};
}

}  // namespace fathom::golden::testing
