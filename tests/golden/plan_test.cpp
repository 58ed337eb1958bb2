// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shards/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "verify/families/families.hpp"
#include "verify/golden/records/recipe.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

std::vector<Recipe> recipes(const std::vector<ShardPlan>& shards) {
  std::vector<Recipe> result;
  for (const ShardPlan& shard : shards)
    for (Recipe& recipe : shard.recipes()) result.push_back(std::move(recipe));
  return result;
}

bool same(const ShardPlan& s, const ShardPlan& t) {
  return s.name == t.name && s.level == t.level && s.recipes() == t.recipes();
}

void expect_prefix(const std::vector<ShardPlan>& part, const std::vector<ShardPlan>& whole) {
  ASSERT_LT(part.size(), whole.size());
  EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin(), same));
}

TEST(Plan, LevelsAreNested) {
  const auto l0 = plan(Level::L0, 7), l1 = plan(Level::L1, 7), l2 = plan(Level::L2, 7);
  expect_prefix(l0, l1);
  expect_prefix(l1, l2);
  for (std::size_t i = 0; i < l2.size(); ++i)
    EXPECT_EQ(l2[i].level, i < l0.size() ? Level::L0 : i < l1.size() ? Level::L1 : Level::L2) << l2[i].name;
}

TEST(Plan, IsAFunctionOfLevelAndSeed) {
  const auto once = plan(Level::L1, 3), again = plan(Level::L1, 3), other = plan(Level::L1, 4);
  EXPECT_TRUE(std::equal(once.begin(), once.end(), again.begin(), again.end(), same));
  EXPECT_FALSE(std::equal(once.begin(), once.end(), other.begin(), other.end(), same));
}

TEST(Plan, NoIdAndNoShardOccursTwice) {
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
    std::set<std::string> ids, names;
    for (const ShardPlan& shard : plan(Level::L2, seed)) {
      EXPECT_TRUE(names.insert(shard.name).second) << shard.name;
      EXPECT_FALSE(shard.recipes().empty()) << shard.name;
      for (const Recipe& recipe : shard.recipes()) ASSERT_TRUE(ids.insert(id_of(recipe)).second) << id_of(recipe);
    }
  }
}

TEST(Plan, LevelZeroHoldsEverythingByName) {
  std::set<std::string> families, others;
  for (const Recipe& recipe : recipes(plan(Level::L0, 1)))
    (recipe.source == Source::family ? families : others).insert(recipe.name);
  for (const families::Family& family : families::families()) {
    EXPECT_EQ(families.contains(std::string(family.name)), family.name != "catalogue") << family.name;
  }
  for (const families::CatalogueEntry& entry : families::catalogue())
    EXPECT_TRUE(others.contains(std::string(entry.name))) << entry.name;
  ASSERT_EQ(real_cases().size(), 63u);
  for (const Case& real : real_cases()) EXPECT_TRUE(others.contains(real.id)) << real.id;
}

TEST(Plan, LevelsOfShapesAreAChainOfTheirOwn) {
  const auto p0 = plan(Level::P0, 1), p1 = plan(Level::P1, 1);
  expect_prefix(p0, p1);
  std::set<std::string> families, others, ids;
  for (const Recipe& recipe : recipes(p1)) {
    EXPECT_EQ(kind_of(recipe.source), Kind::shapes);
    EXPECT_TRUE(ids.insert(id_of(recipe)).second) << id_of(recipe);
  }
  for (const Recipe& recipe : recipes(plan(Level::L1, 1))) {
    EXPECT_EQ(kind_of(recipe.source), Kind::polytopes);
    EXPECT_FALSE(ids.contains(id_of(recipe))) << id_of(recipe);
  }
  for (const Recipe& recipe : recipes(p0))
    (recipe.source == Source::shape_family ? families : others).insert(recipe.name);
  EXPECT_EQ(families.size(), families::families(families::Kind::shapes).size());
  EXPECT_EQ(others.size(), families::shape_catalogue().size());
  EXPECT_GT(recipes(p0).size(), 400u);
  EXPECT_LT(recipes(p0).size(), 800u);
  EXPECT_GT(recipes(p1).size(), 4000u);
}

TEST(Plan, TheLevelOfUnionsStandsAlone) {
  const auto u0 = plan(Level::U0, 1);
  EXPECT_GT(u0.size(), 1u) << "so that a run can be stopped between shards";
  std::set<std::string> families, others, ids;
  for (const Level level : {Level::L0, Level::P0})
    for (const Recipe& recipe : recipes(plan(level, 1))) ids.insert(id_of(recipe));
  for (const ShardPlan& shard : u0) EXPECT_EQ(shard.level, Level::U0);
  for (const Recipe& recipe : recipes(u0)) {
    EXPECT_EQ(kind_of(recipe.source), Kind::unions);
    EXPECT_TRUE(ids.insert(id_of(recipe)).second) << id_of(recipe);
    (recipe.source == Source::union_family ? families : others).insert(recipe.name);
  }
  EXPECT_EQ(families.size(), families::families(families::Kind::unions).size());
  EXPECT_EQ(others.size(), families::union_catalogue().size());
  EXPECT_GT(recipes(u0).size(), 100u);
  EXPECT_LT(recipes(u0).size(), 200u);
}

TEST(Plan, TheLevelOfThePlaneHasItsFamiliesAlone) {
  const auto f0 = plan(Level::F0, 1);
  EXPECT_GT(f0.size(), 1u) << "so that a run can be stopped between shards";
  std::set<std::string> families, ids;
  for (const ShardPlan& shard : f0) EXPECT_EQ(shard.level, Level::F0);
  for (const Recipe& recipe : recipes(f0)) {
    EXPECT_EQ(recipe.source, Source::plane_family);
    EXPECT_EQ(kind_of(recipe.source), Kind::plane);
    EXPECT_TRUE(ids.insert(id_of(recipe)).second) << id_of(recipe);
    families.insert(recipe.name);
  }
  EXPECT_EQ(families.size(), families::families(families::Kind::plane).size());
  EXPECT_GT(ids.size(), 200u);
  EXPECT_LT(ids.size(), 400u);
}

TEST(Plan, SizesAndCountsAreThoseOfTheLevel) {
  const auto count = [](Level level) { return recipes(plan(level, 1)).size(); };
  EXPECT_GT(count(Level::L0), 300u);
  EXPECT_LT(count(Level::L0), 800u);
  EXPECT_GT(count(Level::L1), 5000u);
  EXPECT_GT(count(Level::L2), 70000u);
  for (const auto& [level, most] :
       {std::pair(Level::L0, 12U), std::pair(Level::L1, 30U), std::pair(Level::L2, 1000U)}) {
    std::map<std::string, std::set<unsigned>> sizes;
    for (const Recipe& recipe : recipes(plan(level, 1))) sizes[recipe.name].insert(recipe.size);
    EXPECT_LE(*sizes["random_ball"].rbegin(), most);
    EXPECT_GE(*sizes["random_ball"].begin(), 4u);
    EXPECT_EQ(sizes["boxes_posed"].size(), 1u) << "its size is ignored";
  }
}

/// The plan of data version 1.3.0, which may not change: all ids of the released levels, in their
/// order.
TEST(Plan, ReleasedLevelsStayAsTheyAre) {
  struct Released {
    Level level;
    std::size_t count;
    std::uint64_t hash;  // FNV-1a
  };
  for (const Released& released :
       {Released{Level::L2, 92'399, 0x20c4faca599c1de1U}, Released{Level::P1, 4305, 0x8cbd9cee07ba36dcU}}) {
    std::size_t count = 0;
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const ShardPlan& shard : plan(released.level, 1)) {
      for (const Recipe& recipe : shard.recipes()) {
        for (const char c : shard.name + id_of(recipe) + '\n')
          hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
        ++count;
      }
    }
    EXPECT_EQ(count, released.count) << name_of(released.level);
    EXPECT_EQ(hash, released.hash) << name_of(released.level);
  }
}

TEST(Plan, LevelThreeIsPlannedWithoutMakingItsRecipes) {
  const auto l2 = plan(Level::L2, 1), l3 = plan(Level::L3, 1);
  expect_prefix(l2, l3);
  std::size_t count = 0;
  std::set<std::string> names;
  for (const ShardPlan& shard : l3) {
    count += shard.count();
    EXPECT_TRUE(names.insert(shard.name).second) << shard.name;
    EXPECT_LE(shard.count(), 1500u);
  }
  EXPECT_GT(count, 4'500'000u);
  EXPECT_LT(l3.size(), 5000u) << "files in one folder";
  // The seams between shards, and between levels: no recipe is lost, none is there twice.
  std::set<std::string> ids;
  std::size_t looked_at = 0;
  for (const std::size_t i : {l2.size() - 1, l2.size(), l2.size() + 1, l3.size() - 2, l3.size() - 1}) {
    const std::vector<Recipe> some = l3[i].recipes();
    EXPECT_EQ(some.size(), l3[i].count());
    for (const Recipe& recipe : some) EXPECT_TRUE(ids.insert(id_of(recipe)).second) << id_of(recipe);
    looked_at += some.size();
  }
  EXPECT_EQ(ids.size(), looked_at);
}

TEST(Plan, FamiliesThatIgnoreTheSeedHaveOneCaseOfASize) {
  std::set<unsigned> sizes;
  for (const Recipe& recipe : recipes(plan(Level::L1, 5))) {
    if (recipe.name != "crossed_parabolas") continue;
    EXPECT_EQ(recipe.seed, 0u);
    EXPECT_TRUE(sizes.insert(recipe.size).second);
  }
  EXPECT_GT(sizes.size(), 10u);
}

TEST(Plan, LevelsHaveNames) {
  for (const Level level :
       {Level::L0, Level::L1, Level::L2, Level::L3, Level::P0, Level::P1, Level::U0, Level::C0, Level::F0})
    EXPECT_EQ(find_level(name_of(level)), level);
  EXPECT_FALSE(find_level("L4"));
  EXPECT_FALSE(find_level("P2"));
  EXPECT_FALSE(find_level("U1"));
  EXPECT_FALSE(find_level("F1"));
  EXPECT_FALSE(find_level(""));
}

TEST(Recipe, IdsSayWhereTheCaseIsFrom) {
  EXPECT_EQ(id_of({Source::family, "random_ball", 8, 12}), "random_ball-n8-s12");
  EXPECT_EQ(id_of({Source::catalogue, "flat", 8, 12}, Form::binary64), "catalogue-flat.b64");
  EXPECT_EQ(id_of({Source::real, "fcl-545"}, Form::binary32), "real-fcl-545.b32");
  EXPECT_EQ(id_of({Source::shape_family, "cones", 8, 12}, Form::binary32), "cones-n8-s12.b32");
  EXPECT_EQ(id_of({Source::shape_catalogue, "cone_on_plane"}), "shape_catalogue-cone_on_plane");
  EXPECT_EQ(id_of({Source::union_family, "combs", 4, 12}, Form::binary64), "combs-n4-s12.b64");
  EXPECT_EQ(id_of({Source::union_catalogue, "slot_filled"}), "union_catalogue-slot_filled");
  EXPECT_EQ(id_of({Source::plane_family, "plane_far", 7, 12}, Form::binary32), "plane_far-n7-s12.b32");
  EXPECT_EQ(cases_of({Source::real, "fcl-545"}).front().id, "real-fcl-545");
  for (const Source source :
       {Source::family, Source::catalogue, Source::real, Source::shape_family, Source::shape_catalogue,
        Source::union_family, Source::union_catalogue, Source::plane_family})
    EXPECT_THROW(base_bodies({source, "no_such_thing", 8, 1}), std::invalid_argument);
}

// ---- the order of records ----

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
