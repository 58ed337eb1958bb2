// SPDX-License-Identifier: GPL-3.0-or-later
// Families of unions: the same on every machine, with pieces that have interiors, and for nobody
// who takes polytopes; cut bodies are whole.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "fathom/union.hpp"
#include "verify/families/families.hpp"
#include "verify/families/union_pairs.hpp"
#include "verify/golden/shards/plan.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::families {
namespace {

bool is_cut(std::string_view name) { return name.starts_with("cut_"); }

/// FNV-1a of all coordinates as text, and of the sizes of all pieces.
std::uint64_t hash(const Case& unions) {
  std::uint64_t value = 0xcbf29ce484222325U;
  const auto add = [&value](const std::string& text) {
    for (const char c : text + ' ') value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  };
  for (const Body* body : {&unions.a, &unions.b})
    for (const std::vector<Point>& piece : *body->pieces) {
      add(std::to_string(piece.size()));
      for (const Point& p : piece)
        for (const mpq_class* x : {&p.x, &p.y, &p.z}) add(x->get_str());
    }
  return value;
}

UnionDepth depth_of(const Case& pair) { return union_depth(*pair.a.pieces, *pair.b.pieces); }

TEST(Families, WhoTakesPolytopesGetsNoOthers) {
  for (std::uint64_t number = 0; number < 2 * fathom::families::families().size(); ++number) {
    const Case pair = harness::random_case(7, number);
    for (const Body* body : {&pair.a, &pair.b}) EXPECT_FALSE(body->shape || body->pieces) << pair.id;
  }
  for (const golden::ShardPlan& shard : golden::plan(golden::Level::L1, 1))
    for (const golden::Recipe& recipe : shard.recipes()) {
      const Family* const family = find_family(recipe.name);
      EXPECT_TRUE(family == nullptr || family->kind() == Kind::polytopes) << recipe.name;
    }
}

TEST(UnionFamilies, SameSeedSameCaseOtherSeedOtherCase) {
  for (const Family& family : fathom::families::families(Kind::unions)) {
    std::set<std::uint64_t> hashes;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Case unions = family.make(seed, 5);
      EXPECT_EQ(unions.id, std::string(family.name) + "-n5-s" + std::to_string(seed));
      EXPECT_EQ(hash(unions), hash(family.make(seed, 5))) << unions.id;
      hashes.insert(hash(unions));
    }
    EXPECT_GE(hashes.size(), 5U) << family.name;
  }
}

/// Published cases must stay what they are.
TEST(UnionFamilies, CasesNeverChange) {
  std::uint64_t all = 0;
  for (const Family& family : fathom::families::families(Kind::unions)) all = all * 31 + hash(family.make(2, 10));
  EXPECT_EQ(all, 14833387818270508681U) << "some family changed";
}

TEST(UnionFamilies, EveryPieceHasAnInteriorAtEverySize) {
  for (const Family& family : fathom::families::families(Kind::unions))
    for (const unsigned size : {0U, 1U, 2U, 9U, 27U}) {
      const Case unions = family.make(3, size);
      for (const Body* body : {&unions.a, &unions.b}) {
        EXPECT_TRUE(body->points.empty() && !body->shape) << unions.id;
        ASSERT_TRUE(body->pieces && !body->pieces->empty()) << unions.id;
        EXPECT_LE(body->pieces->size(), 4 * std::max(size, 9U)) << unions.id;
        for (const std::vector<Point>& piece : *body->pieces) EXPECT_FALSE(is_flat(piece)) << unions.id;
      }
    }
}

TEST(UnionFamilies, CutBodiesHaveTheDepthOfTheWholeWithClearance) {
  for (const Family& family : fathom::families::families(Kind::unions)) {
    std::size_t penetrating = 0;
    for (std::uint64_t seed = 0; is_cut(family.name) && seed < 8; ++seed) {
      const Case unions = family.make(seed, 6);
      const UnionDepth depth = depth_of(unions);
      EXPECT_EQ(depth.squared(), depth.bounds->hulls) << unions.id;
      for (const UnionOptimum& optimum : depth.optima) EXPECT_TRUE(optimum.clearance) << unions.id;
      penetrating += depth.status == Status::penetrating;
    }
    EXPECT_TRUE(penetrating > 1 || !is_cut(family.name)) << family.name;
  }
}

TEST(UnionFamilies, OthersAreNoConvexBodies) {
  for (const Family& family : fathom::families::families(Kind::unions)) {
    if (is_cut(family.name) || family.name.ends_with("_apart") || family.name.ends_with("_touching") ||
        family.name == "slots_narrow")
      continue;
    std::size_t below = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const UnionDepth depth = depth_of(family.make(seed, family.usual_size));
      below += depth.squared() < depth.bounds->hulls;
    }
    EXPECT_GT(below, 1U) << family.name;
  }
}

TEST(UnionFamilies, SlotsAreFitsAndNarrowOnesAreNone) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const UnionDepth fit = depth_of(find_family("slots")->make(seed, 3)),
                     narrow = depth_of(find_family("slots_narrow")->make(seed, 3));
    ASSERT_EQ(fit.status, Status::penetrating);
    ASSERT_EQ(fit.optima.size(), 1U);
    EXPECT_FALSE(fit.optima[0].clearance);
    EXPECT_EQ(fit.squared(), fit.bounds->deepest_pair);
    ASSERT_EQ(narrow.status, Status::penetrating);
    EXPECT_GT(narrow.squared(), 1);
    for (const UnionOptimum& optimum : narrow.optima) EXPECT_TRUE(optimum.clearance);
  }
}

TEST(UnionFamilies, EverySituationOccurs) {
  std::map<std::string_view, std::set<Status>> seen;
  for (const Family& family : fathom::families::families(Kind::unions))
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      if (is_cut(family.name)) continue;  // these take long, and were seen above
      seen[family.name].insert(depth_of(family.make(seed, family.usual_size)).status);
    }
  EXPECT_EQ(seen["clusters_apart"], std::set{Status::disjoint});
  EXPECT_TRUE(seen["box_unions_touching"].contains(Status::touching));
  EXPECT_FALSE(seen["box_unions_touching"].contains(Status::penetrating));
  for (const char* family : {"rings_linked", "ring_and_rod"})
    EXPECT_TRUE(seen[family].contains(Status::penetrating) && seen[family].contains(Status::disjoint)) << family;
}

}  // namespace
}  // namespace fathom::families
