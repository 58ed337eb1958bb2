// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of few points against its twin, quickhull, once the triangles of both are merged.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "reference/polytope/hull.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/catalogue.hpp"

namespace fathom::polytope {
namespace {

using Ids = std::vector<std::uint32_t>;

Ids distinct(const std::vector<Vector>& points) {
  DistinctPoints seen = no_points_yet(points, points.size());
  Ids ids;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (seen.insert(i).second) ids.push_back(i);
  return ids;
}

void expect_equal(const Polytope& x, const Polytope& y) {
  ASSERT_EQ(std::vector<std::uint32_t>(x.input_ids.begin(), x.input_ids.end()),
            std::vector<std::uint32_t>(y.input_ids.begin(), y.input_ids.end()));
  ASSERT_EQ(x.corners, y.corners);
  ASSERT_EQ(x.facets.size(), y.facets.size());
  for (const FacetId f : x.facets.ids()) {
    EXPECT_EQ(x.facets[f].normal, y.facets[f].normal);
    EXPECT_EQ(x.facets[f].begin, y.facets[f].begin);
  }
  ASSERT_EQ(x.edges.size(), y.edges.size());
  for (std::size_t i = 0; i < x.edges.size(); ++i)
    EXPECT_TRUE(x.edges[i].from == y.edges[i].from && x.edges[i].to == y.edges[i].to);
}

/// Whether the points are solid; then both ways must agree.
bool agrees(const std::vector<Vector>& points) {
  if (affine_rank(points) < 3) return false;
  const Ids ids = distinct(points);
  const Polytope few = merge_coplanar(points, hull_triangles_of_few(points, ids)),
                 twin = merge_coplanar(points, hull_triangles(points, ids));
  expect_equal(few, twin);
  EXPECT_TRUE(validate(few, points).ok());
  return true;
}

TEST(HullOfFew, IsQuickhullsOnSmallLattices) {
  std::mt19937_64 random(3);
  std::size_t solid = 0;
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE(i);
    const auto reach = static_cast<unsigned long>(1 + i % 4);
    std::vector<Vector> points(4 + random() % 30);
    for (Vector& p : points)
      for (mpz_class* c : {&p.x, &p.y, &p.z}) *c = random() % (reach + 1);
    solid += agrees(points) ? 1U : 0U;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(solid, 3000U);
}

TEST(HullOfFew, IsQuickhullsOnFamiliesAndTheCatalogue) {
  std::vector<Case> cases = testing::cases_of_all_families(2, 9);
  for (const Case& more : testing::cases_of_all_families(1, 40)) cases.push_back(more);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t solid = 0;
  for (const Case& input : cases) {
    SCOPED_TRACE(input.id);
    const PlacedPair pair = place(input.a.points, input.b.points);
    for (const kernels::PointCloud* cloud : {&pair.a, &pair.b}) solid += agrees(cloud->points()) ? 1U : 0U;
  }
  EXPECT_GT(solid, 400U);
}

}  // namespace
}  // namespace fathom::polytope
