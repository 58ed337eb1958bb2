// SPDX-License-Identifier: GPL-3.0-or-later
// The vertex test's filter against exact integers, on lines that are hard for it, in all rounding modes.
#include <gtest/gtest.h>

#include "kernels/filters/line_filter.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

// <s,w> > 0 and <s,w>^2 > bound |w|^2 at all corners of the lines i, i' and j, j'.
bool exactly_beyond(const Line& p, const Line& q, const std::array<const Line*, 2>& rows, const std::array<const Line*, 2>& columns,
                    const mpq_class& bound) {
  for (const Line* i : rows) {
    for (const Line* j : columns) {
      const Vector w = cross(i->direction, j->direction);
      const mpz_class height = dot(q.point - p.point, w);
      if (height <= 0 || mpq_class(height * height) <= bound * dot(w, w)) return false;
    }
  }
  return true;
}

TEST(CornersBeyond, VerdictsAreThoseOfExactArithmetic) {
  Random random(8);
  std::size_t beyond = 0, within = 0, unsure = 0;
  for (int repeat = 0; repeat < 80; ++repeat) {
    for (const Scene& scene : adversarial_scenes(random, 6)) {
      const LineImages all = images(scene);
      const std::size_t n = scene.lines.size();
      if (n < 6) continue;
      for (int k = 0; k < 12; ++k) {
        // Rows and columns of two lines each, the difference from any two; the bound from one of the four crossings.
        const std::size_t i = random() % (n - 1), j = random() % (n - 1), of_a = random() % n, of_b = random() % n;
        const Line &p = scene.lines[of_a], &q = scene.lines[of_b];
        const Vector w = cross(scene.lines[i].direction, scene.lines[j].direction);
        const mpz_class height = dot(q.point - p.point, w), square = dot(w, w);
        if (square == 0) continue;
        mpz_class numerator = height * height, denominator = square;
        if (k % 3 == 1) numerator *= 2;
        if (k % 3 == 2) denominator *= 1000;
        LineBound bound;
        CornerVerdict verdict;
        {
          const RoundingMode mode(rounding_modes[k % 4]);
          bound = line_bound(numerator, denominator, scene.exponent);
          verdict = corners_beyond(all, all, {{i, of_a, i + 1}, {j, of_b, j + 1}}, bound);
        }
        const mpq_class exact = mpq_class(numerator) / mpq_class(denominator);
        EXPECT_LE(mpq_class(bound.below), times_power_of_four(exact, -scene.exponent));
        const bool truth = exactly_beyond(p, q, {&scene.lines[i], &scene.lines[i + 1]}, {&scene.lines[j], &scene.lines[j + 1]}, exact);
        ASSERT_TRUE(truth || verdict != CornerVerdict::beyond);
        ASSERT_TRUE(!truth || verdict != CornerVerdict::within);
        beyond += verdict == CornerVerdict::beyond;
        within += verdict == CornerVerdict::within;
        unsure += verdict == CornerVerdict::unsure;
      }
    }
  }
  EXPECT_GT(beyond, 100U);
  EXPECT_GT(within, 5000U);
  EXPECT_GT(unsure, 100U);
}

TEST(CornersBeyond, AnInfiniteBoundIsNeverPassed) {
  Random random(9);
  const Scene scene = random_lines(random, 30, 8);
  const LineImages all = images(scene);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NE(corners_beyond(all, all, {{i, i, i + 1}, {0, 0, 1}}, {infinite, 0}), CornerVerdict::beyond);
}

}  // namespace
}  // namespace fathom::kernels
