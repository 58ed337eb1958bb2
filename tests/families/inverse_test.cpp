// SPDX-License-Identifier: GPL-3.0-or-later
// That the answers which the bodies were built for are their answers; against the hull of all
// differences.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/naive.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {
namespace {

Depth solved(const Case& input) { return penetration_depth(input.a.points, input.b.points, {.method = Method::naive}); }

/// k, if the ratio is (1 + 2^-k)^2.
std::optional<std::size_t> exact_gap(const mpq_class& squared_ratio) {
  for (long k = 1; k <= 220; ++k) {
    const mpq_class factor = 1 + times_power_of_two(1, -k);
    if (squared_ratio == factor * factor) return static_cast<std::size_t>(k);
  }
  return std::nullopt;
}

const std::map<std::string_view, ContactKind> kinds{
    {"inverse_facet_vertex", ContactKind::facet_vertex}, {"inverse_vertex_facet", ContactKind::vertex_facet},
    {"inverse_facet_edge", ContactKind::facet_edge},     {"inverse_edge_facet", ContactKind::edge_facet},
    {"inverse_facet_facet", ContactKind::facet_facet},   {"inverse_edge_edge", ContactKind::edge_edge}};

TEST(Inverse, HasTheKindAndTheGapThatWereChosen) {
  for (const auto& [name, kind] : kinds) {
    std::set<std::size_t> gaps;
    for (const unsigned size : {1U, 12U, 20U}) {
      for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Case input = find_family(name)->make(100 * size + seed, size);
        const Depth depth = solved(input);
        ASSERT_EQ(depth.optima().size(), 1U) << input.id;
        EXPECT_EQ(depth.contact()->kind, kind) << input.id;
        const std::optional<mpq_class> next = depth::second_nearest_squared_naive(input.a.points, input.b.points);
        const std::optional<std::size_t> k = exact_gap(*next / depth.squared());
        ASSERT_TRUE(k.has_value()) << input.id;
        EXPECT_TRUE(*k >= 8 && *k <= 200) << input.id;
        gaps.insert(*k);
        EXPECT_EQ(second_nearest_squared(input.a.points, input.b.points, *depth.penetration()), next) << input.id;
      }
    }
    EXPECT_GT(gaps.size(), 20U) << name;
    EXPECT_GT(*gaps.rbegin(), 150U) << name;
  }
}

// B is moved along n, past the tie: then the facet that was next is the nearest one, and of any
// kind.
TEST(Inverse, TheNextFacetLiesOppositeAndIsOfAnyKind) {
  std::set<ContactKind> seen;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Case input = find_family("inverse_edge_edge")->make(seed, 8);
    const Depth before = solved(input);
    const Point& t = before.translation();
    const mpq_class part = ratio(1, 100);
    input.b = translated(input.b, {mpq_class(t.x * part), mpq_class(t.y * part), mpq_class(t.z * part)});
    const Depth after = solved(input);
    ASSERT_EQ(after.optima().size(), 1U) << input.id;
    EXPECT_EQ(after.direction(), -before.direction()) << input.id;
    seen.insert(after.contact()->kind);
  }
  EXPECT_EQ(seen.size(), 6U);
}

TEST(Inverse, TiesAreExactAndOfTwoKinds) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Case input = find_family("inverse_tie")->make(seed, 10);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.optima().size(), 2U) << input.id;
    EXPECT_EQ(depth.optima()[0].direction, -depth.optima()[1].direction) << input.id;
    EXPECT_NE(depth.optima()[0].contact.kind, depth.optima()[1].contact.kind) << input.id;
    EXPECT_GT(*depth::second_nearest_squared_naive(input.a.points, input.b.points), depth.squared() * ratio(129, 128))
        << input.id;
  }
}

/// (next / depth - 1), from the squares; to many digits, from below.
mpq_class relative_gap(const mpq_class& next, const mpq_class& depth) {
  return quotient_of_roots(next, depth, 300) - 1;
}

TEST(Inverse, RidgesHaveTheGapNearly) {
  std::set<ContactKind> seen;
  std::set<long> gaps;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Case input = find_family("inverse_ridge")->make(seed, seed % 2 ? 12 : 5);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.optima().size(), 1U) << input.id;
    const mpq_class gap =
        relative_gap(*depth::second_nearest_squared_naive(input.a.points, input.b.points), depth.squared());
    long k = 1;
    while (times_power_of_two(gap, k) < ratio(3, 4)) ++k;
    EXPECT_LT(abs(times_power_of_two(gap, k) - 1), ratio(1, 1 << 16)) << input.id;
    EXPECT_TRUE(k >= 8 && k <= 200) << input.id;
    gaps.insert(k);
    seen.insert(depth.contact()->kind);
  }
  EXPECT_GT(gaps.size(), 40U);
  EXPECT_EQ(seen.size(), 3U) << "points in general position";
}

}  // namespace
}  // namespace fathom::families
