// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/grid.hpp"

#include <gtest/gtest.h>

#include "reference/depth/depth.hpp"
#include "tests/support/grids.hpp"

namespace fathom {
namespace {

using testing::cases_of_all_families;
using testing::prepare;
using testing::PreparedGrids;
using testing::text;

// With O inside P: order, hemisphere and membership at every crossing of every canonical pair, under several perturbations.
TEST(Grid, IsValidOnAllFamilies) {
  std::size_t grids = 0, falling = 0;
  const std::vector<Perturbation> perturbations = testing::perturbations();
  unsigned k = 0;
  for (const Case& input : cases_of_all_families(2, 14)) {
    if (penetration_depth(input.a.points, input.b.points).status != Status::penetrating) continue;
    const auto p = prepare(input, perturbations[k++ % perturbations.size()]);
    const EdgeLines a(p->a, p->exponent), b(p->b, p->exponent);
    for (const Charts& charts : p->charts) {
      const CanonicalSubsets subsets = canonical_subsets(p->context, charts);
      for (std::size_t i = 0; i < subsets.size(); ++i) {
        const Report report = validate(Grid(subsets[i], charts, a, b), charts);
        ASSERT_TRUE(report.ok()) << input.id << "\n" << text(report);
        ++grids;
        falling += !subsets[i].rising;
      }
    }
  }
  EXPECT_GT(grids, 1000U);
  EXPECT_GT(falling, grids / 10);
  EXPECT_LT(falling, grids - grids / 10);
}

// Each law, broken: a chain out of order, and the wrong sense.
TEST(Grid, ValidationNoticesDisorder) {
  std::size_t shuffled = 0, turned = 0;
  const PreparedGrids fans(families::find_family("crossed_fans")->make(1, 30));
  for (std::size_t h = 0; h < 2; ++h) {
    const CanonicalSubsets& subsets = fans.subsets[h];
    const Charts& charts = fans.prepared->charts[h];
    for (std::size_t i = 0; i < subsets.size(); ++i) {
      const CanonicalPair pair = subsets[i];
      if (pair.stored.size() < 2 || pair.queries.size() < 2) continue;
      std::vector<std::uint32_t> stored(pair.stored.begin(), pair.stored.end()), queries(pair.queries.begin(), pair.queries.end());
      std::swap(stored.front(), stored.back());
      EXPECT_FALSE(validate(Grid({pair.stored_of, pair.rising, stored, pair.queries}, charts, *fans.a, *fans.b), charts).ok());
      std::swap(queries.front(), queries[1]);
      EXPECT_FALSE(validate(Grid({pair.stored_of, pair.rising, pair.stored, queries}, charts, *fans.a, *fans.b), charts).ok());
      ++shuffled;
      EXPECT_FALSE(validate(Grid({pair.stored_of, !pair.rising, pair.stored, pair.queries}, charts, *fans.a, *fans.b), charts).ok());
      ++turned;
    }
  }
  EXPECT_GT(shuffled, 0U);
  EXPECT_GT(turned, 0U);
}

// The laws that make the vertex test right: at each crossing the outward normal has its plane above O, and P nowhere beyond it.
TEST(Grid, EveryCrossingSupportsP) {
  std::size_t crossings = 0;
  for (const Case& input : cases_of_all_families(1, 10)) {
    if (penetration_depth(input.a.points, input.b.points).status != Status::penetrating) continue;
    const PreparedGrids grids(input);
    grids.for_each([&](const Grid& grid, const Charts&) {
      for (std::size_t i = 0; i < grid.rows(); ++i) {
        for (std::size_t j = 0; j < grid.columns(); ++j) {
          const Vector w = cross(grid.row_direction(i), grid.column_direction(j));
          const mpz_class height = dot(grid.column_point(j) - grid.row_point(i), w);
          for (const Vector& q : grids.prepared->b.vertices) ASSERT_LE(dot(w, q - grid.column_point(j)), 0) << input.id;
          for (const Vector& p : grids.prepared->a.vertices) ASSERT_GE(dot(w, p - grid.row_point(i)), 0) << input.id;
          ASSERT_TRUE(is_zero(w) || height > 0) << input.id;
          ++crossings;
        }
      }
    });
  }
  EXPECT_GT(crossings, 1000U);
}

}  // namespace
}  // namespace fathom
