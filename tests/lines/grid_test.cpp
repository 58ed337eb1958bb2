// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/grid.hpp"

#include <gtest/gtest.h>

#include "fathom/depth.hpp"
#include "tests/support/grids.hpp"

namespace fathom::lines {
namespace {

using testing::cases_of_all_families;
using testing::PreparedGrids;
using testing::text;

// With O inside P: order, hemisphere and membership at every crossing of every canonical pair, under several perturbations.
TEST(Grid, IsValidOnAllFamilies) {
  std::size_t grids = 0, falling = 0;
  const std::vector<kernels::Perturbation> perturbations = testing::perturbations();
  unsigned k = 0;
  for (const Case& input : cases_of_all_families(2, 14)) {
    if (penetration_depth(input.a.points, input.b.points).status() != Status::penetrating) continue;
    const PreparedGrids prepared(input, perturbations[k++ % perturbations.size()]);
    for (std::size_t h = 0; h < 2; ++h) {
      const canonical::CanonicalSubsets& subsets = prepared.subsets[h];
      for (std::size_t i = 0; i < subsets.size(); ++i) {
        const kernels::Report report = validate(Grid(subsets[i], prepared.scenes[h]));
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
    const canonical::CanonicalSubsets& subsets = fans.subsets[h];
    const auto valid = [&](const canonical::CanonicalPair& pair) { return validate(Grid(pair, fans.scenes[h])).ok(); };
    for (std::size_t i = 0; i < subsets.size(); ++i) {
      const canonical::CanonicalPair pair = subsets[i];
      if (pair.a.size() < 2 || pair.b.size() < 2) continue;
      std::vector<chart::ChartArcOfA> a(pair.a.begin(), pair.a.end());
      std::vector<chart::ChartArcOfB> b(pair.b.begin(), pair.b.end());
      std::swap(a.front(), a.back());
      EXPECT_FALSE(valid({pair.stored_of, pair.rising, pair.strip, a, pair.b}));
      std::swap(b.front(), b[1]);
      EXPECT_FALSE(valid({pair.stored_of, pair.rising, pair.strip, pair.a, b}));
      ++shuffled;
      EXPECT_FALSE(valid({pair.stored_of, !pair.rising, pair.strip, pair.a, pair.b}));
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
    if (penetration_depth(input.a.points, input.b.points).status() != Status::penetrating) continue;
    const PreparedGrids grids(input);
    grids.for_each([&](const Grid& grid) {
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
}  // namespace fathom::lines
