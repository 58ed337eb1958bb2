// SPDX-License-Identifier: GPL-3.0-or-later
// The facets of P from nodes and crossings against the naive twin: the hull of all vertex
// differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "kernels/nearest.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/naive.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/catalogue.hpp"
#include "view/stages/parts.hpp"
#include "view/stages/stages.hpp"

namespace {

using namespace fathom;
using fathom::testing::cases_of_all_families;

std::vector<Case> polytopes() {
  std::vector<Case> cases = cases_of_all_families(2, 8);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  return cases;
}

/// Facets by normal, each by its corners as differences, ascending.
using Facets = std::map<Vector, std::set<Vector, kernels::NearestPlanes::LexicographicOrder>,
                        kernels::NearestPlanes::LexicographicOrder>;

Facets naive(const polytope::Polytope& a, const polytope::Polytope& b) {
  std::vector<Vector> differences;
  for (const Vector& p : a.vertices)
    for (const Vector& q : b.vertices) differences.push_back(q - p);
  const polytope::Polytope hull = polytope::convex_hull(differences);
  Facets facets;
  for (const polytope::Facet& facet : hull.facets)
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) facets[facet.normal].insert(hull.vertices[hull.corners[i]]);
  return facets;
}

struct ExactRun {
  polytope::PlacedPair pair;
  kernels::Context context;
  std::unique_ptr<depth::ExactStages> exact;

  explicit ExactRun(const Case& input)
      : pair(polytope::place(input.a.points.exact(), input.b.points.exact())),
        exact(depth::exact_stages(context, pair)) {}
};

TEST(Sum, FacetsAreThoseOfTheHullOfAllDifferences) {
  std::size_t seen = 0;
  for (const Case& input : polytopes()) {
    const ExactRun run(input);
    if (!run.exact->depth.penetration()) continue;
    ++seen;
    const auto found = stages::sum_facets(*run.exact, 100'000);
    ASSERT_TRUE(found) << input.id;
    const depth::Hulls& hulls = run.exact->hulls;
    Facets facets;
    for (const stages::ExactSumFacet& facet : *found) {
      auto& corners = facets[facet.normal];
      for (const stages::SumCorner& corner : facet.corners) {
        const Vector p = hulls.b.vertices[corner.b] - hulls.a.vertices[corner.a];
        EXPECT_TRUE(corners.insert(p).second) << input.id << ", law: a corner occurs once";
        EXPECT_EQ(dot(facet.normal, p), facet.height) << input.id << ", law: corners lie in the plane";
      }
      for (std::size_t i = 0; i < facet.corners.size(); ++i) {
        const auto at = [&](std::size_t k) {
          const stages::SumCorner& corner = facet.corners[(i + k) % facet.corners.size()];
          return Vector(hulls.b.vertices[corner.b] - hulls.a.vertices[corner.a]);
        };
        EXPECT_GT(det(facet.normal, at(1) - at(0), at(2) - at(1)), 0)
            << input.id << ", law: counter-clockwise, strictly convex";
      }
    }
    EXPECT_EQ(facets.size(), found->size()) << input.id << ", law: one facet for each normal";
    EXPECT_EQ(facets, naive(hulls.a, hulls.b)) << input.id << ", law: the facets are those of the hull of differences";
  }
  EXPECT_GT(seen, 50U);
}

TEST(Sum, TheNearestAreThoseOfTheNaiveTwin) {
  for (const Case& input : polytopes()) {
    const stages::Stages staged = stages::stages_of(input.a, input.b);
    const polytope::PlacedPair pair = polytope::place(input.a.points.exact(), input.b.points.exact());
    const depth::NaiveDepth twin = depth::naive_depth(pair.a.points(), pair.b.points());
    if (twin.status != Status::penetrating) {
      EXPECT_EQ(staged.sum.kind, stages::SumKind::none) << input.id;
      continue;
    }
    const std::vector<stages::StagedFacet>& facets = staged.sum.facets;
    const mpq_class unit = kernels::ratio(1, pair.denominator * pair.denominator);
    ASSERT_FALSE(facets.empty()) << input.id;
    EXPECT_EQ(facets.front().squared, mpq_class(twin.squared * unit))
        << input.id << ", law: the nearest is as far as the depth";
    EXPECT_TRUE(std::ranges::is_sorted(facets, {}, &stages::StagedFacet::squared)) << input.id << ", law: ascending";
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(facets, true, &stages::StagedFacet::optimal)),
              twin.directions.size())
        << input.id << ", law: the optimal ones are the optima";
  }
}

/// The input points of the edges of a pair.
std::vector<std::vector<std::uint32_t>> edges(const stages::StagedBody& body, const stages::Indices& of_pair) {
  std::vector<std::vector<std::uint32_t>> result;
  for (const stages::Index e : of_pair) {
    std::vector<std::uint32_t> ids{body.ids[body.edges[e][0]], body.ids[body.edges[e][1]]};
    std::ranges::sort(ids);
    result.push_back(ids);
  }
  return result;
}

TEST(Sum, EachEdgeEdgeFacetNamesItsOnePair) {
  std::size_t seen = 0;
  for (const Case& input : polytopes()) {
    const stages::Stages staged = stages::stages_of(input.a, input.b);
    for (const stages::StagedFacet& facet : staged.sum.facets) {
      if (facet.kind != stages::SumFacetKind::edges) continue;
      ++seen;
      ASSERT_EQ(facet.pairs.size(), 1U) << input.id << ", law: each crossing once";
      const stages::StagedPair& pair = staged.pairs[facet.pairs.front()];
      const auto a = edges(staged.a, pair.a), b = edges(staged.b, pair.b);
      EXPECT_TRUE(std::ranges::count(a, facet.a) == 1 && std::ranges::count(b, facet.b) == 1)
          << input.id << ", law: the pair holds both edges";
    }
  }
  EXPECT_GT(seen, 1000U);
}

TEST(Sum, StopsAtTheMostFacets) {
  const Case cubes = families::families().front().make(1, 12);
  const ExactRun run(cubes);
  const auto all = stages::sum_facets(*run.exact, 100'000);
  ASSERT_TRUE(all);
  EXPECT_TRUE(stages::sum_facets(*run.exact, all->size()));
  EXPECT_FALSE(stages::sum_facets(*run.exact, all->size() - 1));
}

}  // namespace
