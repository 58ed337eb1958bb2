// SPDX-License-Identifier: GPL-3.0-or-later
// Every entry of the catalogue: what is written beside it is what the pipeline and its twins find;
// and the approach to it.

#include <gtest/gtest.h>
#include <stdio.h>

#include <algorithm>
#include <memory>
#include <regex>
#include <set>
#include <string>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "tests/oracles/cdd_oracle.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/unions/naive_union.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/random.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

Depth solve(const Case& pair, Method method = Method::exact) {
  return penetration_depth(pair.a.points, pair.b.points, {.method = method, .validate = true});
}

int rank_of(const Body& body) { return polytope::hull_of(body.points).rank; }

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
  const polytope::Polytope hull = polytope::hull_of(near.a.points);
  EXPECT_TRUE(std::ranges::all_of(hull.facets, [](const polytope::Facet& f) { return f.end - f.begin == 3; }))
      << "no coplanar points are left";
  EXPECT_EQ(solve(near).optima().size(), 1U) << "no tie is left";
}

}  // namespace

namespace fathom::families {
void PrintTo(const CatalogueEntry& entry, std::ostream* out) { *out << entry.name; }

// Every entry of the catalogue of unions: what is written beside it is what the search finds, its
// proof holds, and for tiny ones the naive twin agrees.

namespace {

class EveryUnion : public ::testing::TestWithParam<UnionCatalogueEntry> {};

void expect_entry(const UnionDepth& depth, const UnionCatalogueEntry& entry) {
  EXPECT_EQ(depth.status, entry.status);
  EXPECT_EQ(depth.status == Status::disjoint ? depth.apart->distance.squared : depth.squared(), entry.squared);
  EXPECT_EQ(depth.optima.size(), entry.optima);
  std::set<bool> clearance;
  for (const UnionOptimum& optimum : depth.optima) clearance.insert(optimum.clearance);
  EXPECT_EQ(clearance.size() == 1, entry.clearance.has_value());
  if (entry.clearance) {
    EXPECT_EQ(*clearance.begin(), *entry.clearance);
  }
}

TEST_P(EveryUnion, IsWhatItSays) {
  const Pieces &a = *GetParam().pair.a.pieces, &b = *GetParam().pair.b.pieces;
  expect_entry(union_depth(a, b), GetParam());
  expect_entry(union_depth(b, a), GetParam());
}

TEST_P(EveryUnion, IsProved) {
  const Pieces &a = *GetParam().pair.a.pieces, &b = *GetParam().pair.b.pieces;
  const fathom_check::Verdict verdict = fathom_check::verify(certificate_text(a, b, union_depth(a, b)));
  EXPECT_TRUE(verdict.accepted()) << verdict.reason;
}

/// In units of 2^-18, which all entries but those in thirds share.
TEST_P(EveryUnion, EqualsItsNaiveTwin) {
  const mpq_class unit(1L << 18);
  const Pieces a = unions::scaled(*GetParam().pair.a.pieces, unit), b = unions::scaled(*GetParam().pair.b.pieces, unit);
  if (GetParam().status == Status::disjoint || a.size() * b.size() > 8) return;
  const unions::NaiveUnion naive = unions::naive_union(a, b);
  EXPECT_EQ(naive.squared, GetParam().squared * unit * unit);
  if (GetParam().status == Status::penetrating) {
    EXPECT_EQ(naive.optima.size(), GetParam().optima);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryUnion,
                         ::testing::ValuesIn(std::vector<UnionCatalogueEntry>(union_catalogue().begin(),
                                                                              union_catalogue().end())),
                         [](const auto& info) { return info.param.pair.id; });

TEST(UnionCatalogue, NamesAreUniqueAndPlain) {
  EXPECT_GE(union_catalogue().size(), 30U);
  std::set<std::string> names;
  for (const UnionCatalogueEntry& entry : union_catalogue()) {
    EXPECT_TRUE(names.insert(entry.pair.id).second) << entry.pair.id;
    EXPECT_TRUE(std::regex_match(entry.pair.id, std::regex("[a-z0-9_]+"))) << entry.pair.id;
    EXPECT_FALSE(entry.description.empty()) << entry.pair.id;
  }
}

}  // namespace

void PrintTo(const UnionCatalogueEntry& entry, std::ostream* out) { *out << entry.pair.id; }

}  // namespace fathom::families

// What `fathom cases` prints, read back, is the generated case to the last digit: every family, and
// the catalogues.

namespace {

using namespace fathom;
using namespace fathom::families;

std::vector<Case> printed(const std::string& options) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("'" FATHOM_EXECUTABLE "' cases " + options).c_str(), "r"),
                                                   pclose);
  std::vector<Case> result;
  std::string line;
  for (int c = fgetc(pipe.get()); c != EOF; c = fgetc(pipe.get())) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    const CaseItem item = parse_case(line, options);
    EXPECT_TRUE(item.ok()) << line;
    if (item.ok()) result.push_back(item.value());
    line.clear();
  }
  EXPECT_EQ(line, "");
  return result;
}

void expect_same(const Case& read, const Case& made) {
  EXPECT_EQ(read.id, made.id);
  EXPECT_TRUE(read.a.points == made.a.points && read.b.points == made.b.points) << made.id;
  EXPECT_TRUE(read.a.shape == made.a.shape && read.b.shape == made.b.shape) << made.id;
  for (const Body Case::*body : {&Case::a, &Case::b}) {
    ASSERT_EQ((read.*body).pieces != nullptr, (made.*body).pieces != nullptr) << made.id;
    EXPECT_TRUE(!(made.*body).pieces || *(read.*body).pieces == *(made.*body).pieces) << made.id;
  }
}

TEST(CasesRoundTrip, EveryFamilyOfEachKind) {
  const std::pair<Kind, std::uint64_t> counts[] = {{Kind::polytopes, 3}, {Kind::shapes, 20}, {Kind::unions, 5}};
  for (const auto& [kind, count] : counts) {
    for (const Family& family : fathom::families::families(kind)) {
      const std::string name(family.name);
      const std::vector<Case> read = printed("--family " + name + " --count " + std::to_string(count) + " --seed 11");
      ASSERT_EQ(read.size(), count) << name;
      for (std::uint64_t i = 0; i < count; ++i) expect_same(read[i], family.make(11 + i, family.usual_size));
    }
  }
}

TEST(CasesRoundTrip, TheCatalogueOfShapes) {
  const std::vector<Case> read = printed("--catalogue --shapes");
  ASSERT_EQ(read.size(), shape_catalogue().size());
  for (std::size_t i = 0; i < read.size(); ++i) expect_same(read[i], shape_catalogue()[i].shapes.read());
}

TEST(CasesRoundTrip, TheCatalogueOfUnions) {
  const std::vector<Case> read = printed("--catalogue --unions");
  ASSERT_EQ(read.size(), union_catalogue().size());
  for (std::size_t i = 0; i < read.size(); ++i) expect_same(read[i], union_catalogue()[i].pair);
}

TEST(CasesRoundTrip, TheCatalogue) {
  const std::vector<Case> read = printed("--catalogue");
  ASSERT_EQ(read.size(), catalogue().size());
  for (std::size_t i = 0; i < read.size(); ++i) expect_same(read[i], catalogue()[i].pair);
}

}  // namespace
