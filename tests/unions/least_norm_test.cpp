// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of half-spaces: against every choice of at most three planes; and what is named
// as contradictory is.
#include "reference/unions/least_norm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

#include "kernels/number/rational.hpp"

namespace fathom::unions {
namespace {

using Planes = std::vector<kernels::OrientedPlane>;

Planes random_planes(std::mt19937_64& random, std::size_t count, long size) {
  Planes planes;
  while (planes.size() < count) {
    const auto number = [&] {
      return mpz_class(static_cast<long>(random() % static_cast<unsigned long>(2 * size + 1)) - size);
    };
    const Vector n{number(), number(), number()}, p{number(), number(), number()};
    if (!is_zero(n)) planes.push_back(kernels::oriented_plane(n, dot(n, p) - size * size / 2, 4));
  }
  return planes;
}

std::vector<Barrier> barriers_of(const Planes& planes) {
  std::vector<Barrier> barriers;
  for (const kernels::OrientedPlane& plane : planes) barriers.push_back(&plane);
  return barriers;
}

// |x|^2 of the nearest point, by all choices of planes that it may lie in.
class Naive {
 public:
  explicit Naive(const Planes& planes) : planes_(planes) {
    consider({0, 0, 0}, 1);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const auto& [f, a, unused1] = planes[i];
      consider(a * f, dot(f, f));
      for (std::size_t j = 0; j < i; ++j) {
        const auto& [g, b, unused2] = planes[j];
        const Vector d = cross(f, g);
        if (is_zero(d)) continue;
        consider(a * cross(g, d) + b * cross(d, f), dot(d, d));
        for (std::size_t k = 0; k < j; ++k) {
          const auto& [e, c, unused3] = planes[k];
          if (dot(d, e) != 0) consider(a * cross(g, e) + b * cross(e, f) + c * d, dot(d, e));
        }
      }
    }
  }
  std::optional<mpq_class> squared;

 private:
  void consider(Vector v, mpz_class w) {
    if (w < 0) {
      v = -v;
      w = -w;
    }
    for (const kernels::OrientedPlane& f : planes_)
      if (dot(f.normal, v) < f.height * w) return;
    const mpq_class q = kernels::ratio(dot(v, v), w * w);
    if (!squared || q < *squared) squared = q;
  }
  const Planes& planes_;
};

TEST(LeastNorm, IsThatOfAllChoicesOfPlanes) {
  std::size_t found = 0, infeasible = 0, conflicts = 0;
  for (unsigned seed = 1; seed <= 600; ++seed) {
    std::mt19937_64 random(seed);
    const Planes planes = random_planes(random, 1 + seed % 9, seed % 2 == 0 ? 2 : 30);
    kernels::RationalPoint p;
    std::vector<Barrier> barriers = barriers_of(planes);
    const Naive naive(planes);
    const CellEnd end = nearest_in_cell(barriers, 4, p);
    ASSERT_EQ(end == CellEnd::found, naive.squared.has_value()) << seed;
    if (end == CellEnd::found) {
      EXPECT_EQ(kernels::ratio(dot(p.v, p.v), p.w * p.w), *naive.squared) << seed;
      for (const Barrier f : barriers) EXPECT_GE(kernels::side(*f, p), 0);
      ++found;
      continue;
    }
    ++infeasible;
    const Barrier wall = barriers.back();
    barriers.pop_back();
    if (nearest_in_cell(barriers, 4, p) != CellEnd::found || kernels::side(*wall, p) >= 0) continue;
    std::vector<Barrier> conflict;
    ASSERT_EQ(nearest_on_wall(wall, barriers, nullptr, 4, p, &conflict), CellEnd::infeasible);
    EXPECT_LE(conflict.size(), 4U);
    EXPECT_EQ(nearest_in_cell(conflict, 4, p), CellEnd::infeasible) << "law: the conflict alone leaves nothing";
    ++conflicts;
  }
  EXPECT_GT(found, 200U);
  EXPECT_GT(infeasible, 60U);
  EXPECT_GT(conflicts, 20U);
}

TEST(LeastNorm, EndsBeyondTheLimitExactly) {
  std::size_t beyond = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937_64 random(seed);
    const Planes planes = random_planes(random, 4, 9);
    std::vector<Barrier> barriers = barriers_of(planes);
    kernels::RationalPoint p;
    if (nearest_in_cell(barriers, 4, p) != CellEnd::found || is_zero(p.v)) continue;
    const Barrier wall = barriers.back();
    barriers.pop_back();
    kernels::RationalPoint before, again;
    if (nearest_in_cell(barriers, 4, before) != CellEnd::found || kernels::side(*wall, before) >= 0) continue;
    kernels::SquaredDistance limit = kernels::squared_distance(p);
    EXPECT_EQ(nearest_on_wall(wall, barriers, &limit, 4, again), CellEnd::found) << "law: not beyond if equal";
    limit.numerator = limit.numerator * 1000000 - 1;
    limit.denominator *= 1000000;
    EXPECT_EQ(nearest_on_wall(wall, barriers, &limit, 4, again), CellEnd::beyond);
    ++beyond;
  }
  EXPECT_GT(beyond, 30U);
}

}  // namespace
}  // namespace fathom::unions
