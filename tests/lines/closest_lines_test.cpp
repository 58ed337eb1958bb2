// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/closest_lines.hpp"

#include <gtest/gtest.h>

#include "fathom/depth.hpp"
#include "tests/support/grids.hpp"

namespace fathom::lines {
namespace {

using testing::cases_of_all_families;
using testing::prepare;
using testing::PreparedGrids;
using testing::text;

void expect_equal(const kernels::NearestPlanes& left, const kernels::NearestPlanes& right, const std::string& where) {
  ASSERT_EQ(left.empty(), right.empty()) << where;
  if (left.empty()) return;
  EXPECT_EQ(mpz_class(left.numerator() * right.denominator()), mpz_class(right.numerator() * left.denominator())) << where;
  EXPECT_EQ(left.directions(), right.directions()) << where;
}

// The filtered scan against exact arithmetic on every pair, one canonical pair at a time, so that ties and near ties that a better pair
// elsewhere would hide are seen as well.
TEST(ClosestLines, FilteredScanFindsWhatExactArithmeticFinds) {
  for (const Case& input : cases_of_all_families(2, 12)) {
    const PreparedGrids grids(input);
    for (std::size_t h = 0; h < 2; ++h) {
      const canonical::CanonicalSubsets& subsets = grids.subsets[h];
      kernels::NearestPlanes filtered, exact;
      kernels::Context context;
      closest_lines(context, subsets, grids.scenes[h], filtered, {.engine = ClosestLines::naive});
      for (std::size_t i = 0; i < subsets.size(); ++i) {
        for (const chart::ChartArcOfA e : subsets[i].a) {
          for (const chart::ChartArcOfB f : subsets[i].b) offer_arcs(grids.scenes[h], e, f, exact);
        }
      }
      expect_equal(filtered, exact, input.id);
      EXPECT_EQ(context.counters.pairs_evaluated, subsets.sums().product) << input.id;
    }
  }
}

// AGHRS, Lemma 2.2: the plane's distance from O is the distance of the two lines, here from the foot points of their common perpendicular.
TEST(ClosestLines, PlaneDistanceIsTheDistanceOfTheLines) {
  std::size_t compared = 0;
  for (const Case& input : cases_of_all_families(1, 6)) {
    const auto p = prepare(input);
    const EdgeLinesOfA a(p->a, p->exponent);
    const EdgeLinesOfB b(p->b, p->exponent);
    for (const gaussian::EdgeOfA e : a.ids()) {
      for (const gaussian::EdgeOfB f : b.ids()) {
        kernels::NearestPlanes nearest;
        if (!offer_edges(a, e, b, f, nearest)) continue;
        // Feet p + s d and q + t g: <q + t g - p - s d, d> = <..., g> = 0, by Cramer's rule.
        const Vector d = a.direction(e), g = b.direction(f), r = b.point(f) - a.point(e);
        const mpz_class dd = dot(d, d), gg = dot(g, g), dg = dot(d, g), rd = dot(r, d), rg = dot(r, g);
        const mpz_class det2 = dd * gg - dg * dg;
        const mpz_class s = rd * gg - rg * dg, t = rd * dg - rg * dd;
        const Vector foot{det2 * r.x + t * g.x - s * d.x, det2 * r.y + t * g.y - s * d.y, det2 * r.z + t * g.z - s * d.z};
        EXPECT_EQ(mpz_class(dot(foot, foot) * nearest.denominator()), mpz_class(nearest.numerator() * det2 * det2)) << input.id;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000U);
}

TEST(ClosestLines, SeparationHoldsWhereOIsInside) {
  std::size_t checked = 0;
  for (const Case& input : cases_of_all_families(3, 10)) {
    if (penetration_depth(input.a.points, input.b.points).status() != Status::penetrating) continue;
    const PreparedGrids grids(input);
    for (std::size_t h = 0; h < 2; ++h) {
      const kernels::Report report = validate_separation(grids.subsets[h], grids.scenes[h]);
      EXPECT_TRUE(report.ok()) << input.id << "\n" << text(report);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100U);
}

TEST(ClosestLines, SeparationIsNoticedToFail) {
  const PreparedGrids grids(families::find_family("random_disjoint")->make(1, 20));
  bool failed = false;
  for (std::size_t h = 0; h < 2; ++h) failed |= !validate_separation(grids.subsets[h], grids.scenes[h]).ok();
  EXPECT_TRUE(failed) << "disjoint bodies are not separated in every direction";
}

// In general position exact arithmetic is rare: it decides improvements and near ties only.
TEST(ClosestLines, FilterLeavesFewPairs) {
  const Case input = families::find_family("crossed_fans")->make(1, 300);
  Options options;
  options.closest_lines = ClosestLines::naive;
  const Depth depth = penetration_depth(input.a.points, input.b.points, options);
  EXPECT_GE(depth.counters.pairs_evaluated, 80000U);
  EXPECT_LE(depth.counters.pairs_exact, depth.counters.pairs_evaluated / 10);
}

// Ties below the precision of binary64, turned until the coordinates have 600 bits.
TEST(ClosestLines, TheFirstBitsOfLongCoordinatesLeaveFewPairs) {
  const Case input = families::find_family("crossed_vanishing_ties")->make(1, 600);
  families::Bodies bodies{input.a, input.b};
  for (const long k : {1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L, 10L})
    bodies = families::rotated(bodies, families::rotation((1L << 30) + k, (1L << 29) - k, (1L << 30) - 7 * k, (1L << 28) + 3 * k));
  const Options exact{.method = Method::exact, .closest_lines = ClosestLines::naive};
  const Depth depth = penetration_depth(bodies.a.points, bodies.b.points, exact);
  const Depth unturned = penetration_depth(input.a.points, input.b.points, exact);
  EXPECT_EQ(depth.squared(), unturned.squared());
  EXPECT_EQ(depth.optima().front().contact, unturned.optima().front().contact);
  EXPECT_GE(depth.counters.pairs_evaluated, 100000U);
  EXPECT_LE(depth.counters.pairs_exact, depth.counters.pairs_evaluated / 100);
}

}  // namespace
}  // namespace fathom::lines
