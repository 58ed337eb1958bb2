// SPDX-License-Identifier: GPL-3.0-or-later
// Law: a shard's records have one order; anything lost, doubled, exchanged or added is seen.
#include "verify/golden/records/record_order.hpp"

#include <gtest/gtest.h>

#include "verify/golden/records/record.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {
namespace {

TEST(Order, IdsAreThoseOfTheRecords) {
  std::size_t rounded = 0;
  for (const ShardPlan& shard : plan(Level::L0, 1)) {
    const std::vector<Recipe> recipes = shard.recipes();
    for (std::size_t i = 0; i < recipes.size(); i += 7) {
      std::vector<std::string> ids, made;
      for (const Record& record : records_of(recipes[i])) ids.push_back(record.id);
      for (const FormedCase& one : cases_of(recipes[i])) made.push_back(one.id);
      EXPECT_EQ(made, ids);
      rounded += ids.size() - 1;
    }
  }
  EXPECT_GT(rounded, 20U);
}

TEST(Order, RecipeByRecipe) {
  const std::vector<Recipe> recipes = {{Source::catalogue, "one", 0, 0}, {Source::family, "two", 4, 9}};
  const std::string one = id_of(recipes[0]), two = id_of(recipes[1]);
  const std::vector<std::string> ones = {one, one + ".b64", one + ".b32"}, twos = {two};
  const auto accepts = [&](const std::vector<std::string>& ids) {
    RecordOrder order(recipes);
    for (const std::string& id : ids)
      if (order.next(id, id == one ? ones : id == two ? twos : std::vector<std::string>())) return false;
    return !order.at_end();
  };
  const std::vector<std::string> good = {ones[0], ones[1], ones[2], two};
  EXPECT_TRUE(accepts(good));
  EXPECT_FALSE(accepts({}));
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<std::string> lost = good, doubled = good, exchanged = good, added = good;
    lost.erase(lost.begin() + static_cast<std::ptrdiff_t>(i));
    doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(i), good[i]);
    std::swap(exchanged[i], exchanged[(i + 1) % good.size()]);
    for (const std::string& other : {std::string("three"), std::string(), two + ".b64"}) {
      added = good;
      added.insert(added.begin() + static_cast<std::ptrdiff_t>(i) + 1, other);
      EXPECT_FALSE(accepts(added)) << i << other;
    }
    EXPECT_FALSE(accepts(lost)) << i;
    EXPECT_FALSE(accepts(doubled)) << i;
    EXPECT_FALSE(accepts(exchanged)) << i;
  }
}

}  // namespace
}  // namespace fathom::golden
