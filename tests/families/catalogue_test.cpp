// SPDX-License-Identifier: GPL-3.0-or-later
// Every entry of the catalogue: what is written beside it is what the pipeline and its twins find;
// and the approach to it.
#include "verify/families/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include "tests/oracles/cdd_oracle.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/degrade.hpp"
#include "verify/families/random.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

Depth solve(const Case& pair, Method method = Method::exact) {
  return penetration_depth(pair.a.points, pair.b.points, {.method = method, .validate = true});
}

int rank_of(const Body& body) {
  return polytope::convex_hull(polytope::place(body.points, body.points).a.points()).rank;
}

class EveryEntry : public ::testing::TestWithParam<CatalogueEntry> {};

TEST_P(EveryEntry, IsWhatItSays) {
  const CatalogueEntry& entry = GetParam();
  const Depth depth = solve(entry.pair);
  EXPECT_EQ(depth.status(), entry.status);
  EXPECT_EQ(depth.optima().size(), entry.optima);
  std::set<ContactKind> kinds;
  for (const Optimum& optimum : depth.optima()) kinds.insert(optimum.contact.kind);
  EXPECT_EQ(kinds.size() == 1, entry.kind.has_value());
  if (entry.kind) {
    EXPECT_EQ(*kinds.begin(), *entry.kind);
  }
  const kernels::Report report = fathom::testing::check(depth, entry.pair.a.points, entry.pair.b.points);
  EXPECT_TRUE(report.ok()) << fathom::testing::text(report);
}

TEST_P(EveryEntry, EqualsItsTwinAndTheOracle) {
  const Case& pair = GetParam().pair;
  const Depth depth = solve(pair), naive = solve(pair, Method::naive);
  EXPECT_EQ(depth.status(), naive.status());
  EXPECT_EQ(depth.squared(), naive.squared());
  EXPECT_EQ(depth.optima(), naive.optima());
  if (pair.a.points.size() * pair.b.points.size() > 150) return;
  EXPECT_EQ(oracles::answer_of(depth), oracles::cdd_oracle(pair.a.points, pair.b.points));
}

TEST_P(EveryEntry, IsApproached) {
  const Case& pair = GetParam().pair;
  if (pair.a.points.size() > 16 || pair.b.points.size() > 16) return;
  for (const unsigned k : {3u, 60u}) {
    const Case near = approach(pair, k, 5);
    EXPECT_EQ(solve(near).optima(), solve(near, Method::naive).optima()) << near.id;
    const mpq_class bound = times_power_of_two(1, -static_cast<long>(k));
    for (Body Case::*body : {&Case::a, &Case::b})
      for (std::size_t i = 0; i < (pair.*body).points.size(); ++i) {
        const Point &p = (pair.*body).points[i], &q = (near.*body).points[i];
        EXPECT_TRUE(abs(q.x - p.x) <= bound && abs(q.y - p.y) <= bound && abs(q.z - p.z) <= bound) << near.id;
        EXPECT_NE(p, q) << near.id;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEntry,
                         ::testing::ValuesIn(std::vector<CatalogueEntry>(catalogue().begin(), catalogue().end())),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Catalogue, NamesAreUniqueAndPlainAndFound) {
  EXPECT_GE(catalogue().size(), 40U);
  std::set<std::string_view> names;
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_TRUE(std::regex_match(std::string(entry.name), std::regex("[a-z_]+"))) << entry.name;
    EXPECT_FALSE(entry.breaks.empty() || entry.description.empty()) << entry.name;
    EXPECT_EQ(entry.pair.id, entry.name);
    EXPECT_EQ(find_catalogue_entry(entry.name), &entry);
  }
  EXPECT_EQ(find_catalogue_entry("nothing"), nullptr);
}

TEST(Catalogue, FlatEntriesHaveTheNamedRanks) {
  constexpr std::string_view ranks[] = {"point", "segment", "polygon", "solid"};
  std::set<std::pair<int, int>> seen;
  for (const CatalogueEntry& entry : catalogue()) {
    if (!entry.name.starts_with("flat_")) continue;
    const int a = rank_of(entry.pair.a), b = rank_of(entry.pair.b);
    EXPECT_TRUE(entry.name.starts_with("flat_" + std::string(ranks[a]) + "_" + std::string(ranks[b]))) << entry.name;
    seen.insert({a, b});
  }
  EXPECT_EQ(seen.size(), 15U) << "all but solid against solid";
}

TEST(Catalogue, NearOnesAreOffBy2ToTheMinus1000) {
  const Depth apart = solve(find_catalogue_entry("nearly_touching_apart")->pair);
  const Depth deep = solve(find_catalogue_entry("nearly_touching_deep")->pair);
  EXPECT_EQ(apart.status(), Status::disjoint);
  EXPECT_EQ(deep.squared(), times_power_of_two(1, -2000));
}

TEST(Approach, IsGenericAndReproducible) {
  const Case& cubes = find_catalogue_entry("identical_cubes")->pair;
  const Case near = approach(cubes, 80, 1), again = approach(cubes, 80, 1), other = approach(cubes, 80, 2);
  EXPECT_EQ(near.a.points, again.a.points);
  EXPECT_NE(near.a.points, other.a.points);
  EXPECT_EQ(near.id, "identical_cubes-k80-s1");
  const polytope::Polytope hull = polytope::convex_hull(polytope::place(near.a.points, near.a.points).a.points());
  EXPECT_TRUE(std::ranges::all_of(hull.facets, [](const polytope::Facet& f) { return f.end - f.begin == 3; }))
      << "no coplanar points are left";
  EXPECT_EQ(solve(near).optima().size(), 1U) << "no tie is left";
}

}  // namespace

namespace fathom::families {
void PrintTo(const CatalogueEntry& entry, std::ostream* out) { *out << entry.name; }
}  // namespace fathom::families
