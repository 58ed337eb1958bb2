// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a cube with others added whose place is known.
#include <gtest/gtest.h>

#include <vector>

#include "reference/polytope/convexity.hpp"

namespace fathom::polytope {
namespace {

const std::vector<Point> cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

std::vector<Point> with(std::vector<Point> points, const std::vector<Point>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

TEST(InnerPoints, AreCounted) {
  const mpq_class half(1, 2);
  EXPECT_EQ(count_inner_points(cube), 0U);
  EXPECT_EQ(count_inner_points(std::vector<Point>{{half, 0, 0}}), 0U);
  EXPECT_EQ(count_inner_points(with(cube, {{half, half, half}})), 1U) << "inside";
  EXPECT_EQ(count_inner_points(with(cube, {{half, half, 0}, {half, 0, 0}})), 2U) << "in a facet, on an edge";
  EXPECT_EQ(count_inner_points(with(cube, cube)), 0U) << "vertices again";
  EXPECT_EQ(count_inner_points(with(with(cube, cube), {{half, half, half}})), 1U) << "vertices again, and one inside";
  EXPECT_EQ(count_inner_points(with(cube, {{half, half, half}, {half, half, half}})), 2U) << "one inner point twice";
}

TEST(InnerPoints, AreNotTriedIfDenominatorsShareLittle) {
  std::vector<Point> points = cube;
  mpz_class prime = mpz_class(1) << 200;
  for (int i = 0; i < 100; ++i) {
    mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
    points.push_back({mpq_class(1, prime), mpq_class(1, 2), mpq_class(1, 2)});
  }
  EXPECT_EQ(count_inner_points(points), std::nullopt);
}

}  // namespace
}  // namespace fathom::polytope
