// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of tangents: as many edges as slopes, strictly convex, each on its tangent.
#include <gtest/gtest.h>

#include "verify/families/polytope_pairs.hpp"

namespace {

using namespace fathom::families;

TEST(Slopes, AscendInEqualPartsWithGapsBetween) {
  for (const unsigned n : {2U, 3U, 100U, 4096U}) {
    Random random(n);
    const mpq_class width = ratio(3, 7), part = 2 * width / n;
    const std::vector<mpz_class> slopes = spread_slopes(random, n, width);
    ASSERT_EQ(slopes.size(), n);
    for (unsigned i = 0; i < n; ++i) {
      const mpq_class x = times_power_of_two(mpq_class(slopes[i]), -slope_bits), shift = x + width - i * part;
      EXPECT_GE(shift, part * ratio(249, 1000)) << i;
      EXPECT_LE(shift, part * ratio(751, 1000)) << i;
    }
  }
}

TEST(Tangents, TouchTheOutlineAndTurnStrictly) {
  for (const unsigned n : {2U, 5U, 64U, 2000U})
    for (const mpq_class& width : {ratio(1, 1), ratio(1, 32), ratio(1, n)}) {
      Random random(n);
      const Outline outline{ratio(5, 4), ratio(-1, 16)};
      const std::vector<mpz_class> slopes = spread_slopes(random, n, width);
      const Chain chain = tangent_chain(outline, slopes, width, 3);
      ASSERT_EQ(chain.size(), n + 1);
      EXPECT_EQ(chain.front().along, -3);
      EXPECT_EQ(chain.back().along, 3);
      mpq_class last = 4;
      for (unsigned i = 0; i < n; ++i) {
        const ChainPoint &p = chain[i], &q = chain[i + 1];
        ASSERT_LT(p.along, q.along) << "n = " << n << ", width " << width << ", edge " << i;
        const mpq_class slope = (q.height - p.height) / (q.along - p.along),
                        x = times_power_of_two(mpq_class(slopes[i]), -slope_bits);
        ASSERT_LT(slope, last) << "n = " << n << ", width " << width << ", edge " << i;
        last = slope;
        EXPECT_LT(abs(mpq_class(slope + x)), width / (2 * n)) << "within half of the least gap";
        const mpq_class support = x * x / 2 * outline.quadratic + x * x * x * x * outline.quartic;
        EXPECT_LT(abs(mpq_class(p.height + x * p.along - support)), times_power_of_two(1, -49))
            << "the edge's begin is on the tangent";
        EXPECT_LT(abs(mpq_class(q.height + x * q.along - support)), times_power_of_two(1, -49)) << "and so is its end";
      }
    }
}

}  // namespace
