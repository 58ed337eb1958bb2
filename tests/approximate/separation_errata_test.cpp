// SPDX-License-Identifier: GPL-3.0-or-later
// Where APPROX-SEPARATION, taken to the letter, is off by more than a factor of 1 + delta.
//                                                                                [proofs/errata.md]
#include <gtest/gtest.h>

#include <array>

#include "reference/approximate/directions.hpp"
#include "reference/approximate/separation.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::approximate {
namespace {

/// The sum of the first `terms` terms of the series of cos(sqrt(d)). For 0 <= d <= 2 they alternate
/// and fall: an upper bound when their number is odd, a lower one when it is even.
mpq_class cosine_of_root(const mpq_class& d, int terms) {
  mpq_class sum, term = 1;
  for (int k = 1; k <= terms; ++k) {
    sum += term;
    term *= -d / (2 * k * (2 * k - 1));
  }
  return sum;
}

// The paper's grid has a point within the angle sqrt(delta) of every direction, and 1 /
// cos(sqrt(delta)) is to be at most 1 + delta.
TEST(SeparationErrata, TheBoundOfLemma31FailsForLargeDelta) {
  for (const mpq_class& d : {mpq_class(1, 4), mpq_class(1), mpq_class(121, 100)})
    EXPECT_GE((1 + d) * cosine_of_root(d, 8), 1) << d;
  for (const mpq_class& d : {mpq_class(61, 50), mpq_class(3, 2), mpq_class(2)})
    EXPECT_LT((1 + d) * cosine_of_root(d, 9), 1) << d;
  // Its middle step, 1 / (1 - alpha^2 / 2) <= 1 + alpha^2, fails from alpha = 1 on.
  for (const mpq_class& d : {mpq_class(1, 4), mpq_class(1)}) EXPECT_GE((1 + d) * (1 - d / 2), 1) << d;
  EXPECT_LT((1 + mpq_class(101, 100)) * (1 - mpq_class(101, 200)), 1);
}

const mpq_class delta(38, 25);
const std::array<Vector, 4> grid{Vector{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

// Four directions, to the corners of a regular tetrahedron. Those farthest from them are the
// opposites, where the cosine is 1/3.
TEST(SeparationErrata, FourDirectionsAreAGridByThePapersCriterion) {
  EXPECT_LT(cosine_of_root(delta, 5), mpq_class(1, 3))
      << "the angle sqrt(delta) is larger than that with the cosine 1/3";
  const auto near = [](const Vector& p, const Vector& v) {
    const mpz_class along = dot(p, v);
    return along > 0 && 9 * along * along >= dot(p, p) * dot(v, v);
  };
  std::mt19937_64 random(1);
  std::vector<Vector> directions;
  for (const Vector& p : grid) directions.insert(directions.end(), {p, -p});
  for (int i = 0; i < 2000; ++i) directions.push_back(testing::random_direction(random, i % 2 == 0 ? 3 : 40));
  for (const Vector& v : directions) {
    bool any = false;
    for (const Vector& p : grid) any = any || near(p, v);
    EXPECT_TRUE(any) << v;
  }
}

// P is that tetrahedron. Every ray of the grid runs into a corner, three times as far from O as the
// facets are.
TEST(SeparationErrata, ThatGridIsOffByAFactorOfThree) {
  const std::vector<Point> a{{0, 0, 0}};
  std::vector<Point> b;
  for (const Vector& p : grid) b.push_back({p.x, p.y, p.z});
  const mpq_class squared = testing::exact_depth(a, b).squared();
  EXPECT_EQ(squared, mpq_class(1, 3));
  const polytope::Polytope tetrahedron = polytope::convex_hull(grid);
  for (const Vector& p : grid) {
    const mpq_class factor = testing::factor_naive(tetrahedron, p);
    EXPECT_EQ(factor * factor * dot(p, p), 9 * squared);
    EXPECT_GT(factor * factor * dot(p, p), (1 + delta) * (1 + delta) * squared) << "longer than the guarantee allows";
    for (const Vector& q : grid) EXPECT_FALSE(covers(p, -q, delta)) << "the criterion used here refuses the grid";
  }
  const ApproxDepth approx = approx_depth(a, b, delta);
  EXPECT_LE(approx.squared(), (1 + delta) * (1 + delta) * approx.bound_squared());
  EXPECT_LE(approx.bound_squared(), squared);
}

}  // namespace
}  // namespace fathom::approximate
