// SPDX-License-Identifier: GPL-3.0-or-later
// Every entry of the catalogue of unions: what is written beside it is what the search finds, its
// proof holds, and for tiny ones the naive twin agrees.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include "fathom/certificate.hpp"
#include "tests/unions/naive_union.hpp"
#include "verify/check/check.hpp"
#include "verify/families/catalogue.hpp"

namespace fathom::families {
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
