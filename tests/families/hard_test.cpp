// SPDX-License-Identifier: GPL-3.0-or-later
// Depths at rounding boundaries, deep and hair-thin pairs, long and thin bodies: that each has what
// its name says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "kernels/filters/support.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {
namespace {

Depth solved(const Case& input) { return penetration_depth(input.a.points, input.b.points); }

template <class F>
void for_each_coordinate(const Case& input, F f) {
  for (const Body* body : {&input.a, &input.b})
    for (const Point& p : body->points)
      for (const mpq_class* x : {&p.x, &p.y, &p.z}) f(*x);
}

bool in_binary64(const Case& input) {
  bool all = true;
  for_each_coordinate(input, [&](const mpq_class& x) {
    const double nearest = round_binary64(x, Rounding::rn);
    all = all && std::isfinite(nearest) && mpq_class(nearest) == x;
  });
  return all;
}

// --- Rounding boundaries

/// What a format rounds a depth to. Numbers beyond the greatest are taken as one ulp more.
template <class T>
struct Neighbours {
  mpq_class below, above, middle;
  explicit Neighbours(const mpq_class& squared) {
    const double down = root(squared, Rounding::rd), up = root(squared, Rounding::ru);
    constexpr double greatest = std::numeric_limits<T>::max();
    below = std::isinf(down) ? mpq_class(greatest) : mpq_class(down);
    above = std::isinf(up) ? mpq_class(greatest) + times_power_of_two(1, std::numeric_limits<T>::max_exponent -
                                                                             std::numeric_limits<T>::digits)
                           : mpq_class(up);
    middle = (below + above) / 2;
  }
  static double root(const mpq_class& squared, Rounding mode) {
    if constexpr (std::is_same_v<T, double>) return root_binary64(squared, mode);
    else return root_binary32(squared, mode);
  }
};

struct Closeness {
  bool on_it = false;
  long k = 0;  ///< within 2^-k of the distance between neighbours
};

/// How near the root of `squared` is to `boundary`, as a share of `ulp`: no root is taken.
Closeness closeness(const mpq_class& squared, const mpq_class& boundary, const mpq_class& ulp) {
  if (boundary * boundary == squared) return {true, 0};
  const auto within = [&](long k) {
    const mpq_class reach = times_power_of_two(ulp, -k), low = boundary - reach, high = boundary + reach;
    return (low <= 0 || low * low <= squared) && squared <= high * high;
  };
  long k = 0;
  while (k < 300 && within(k + 1)) ++k;
  return {false, k};
}

template <class T>
void expect_hard_to_round(const char* family) {
  std::set<long> seen;
  std::map<std::string, int> kinds;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Case input = find_family(family)->make(seed, seed % 3 ? 6 : 14);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.status(), Status::penetrating) << input.id;
    EXPECT_EQ(depth.optima().size(), 1U) << input.id;
    const Neighbours<T> around(depth.squared());
    const mpq_class ulp =
        around.below == around.above ? mpq_class(around.below) : mpq_class(around.above - around.below);
    Closeness best;
    for (const mpq_class* boundary : {&around.below, &around.above, &around.middle}) {
      const Closeness here = closeness(depth.squared(), *boundary, ulp);
      best = {best.on_it || here.on_it, std::max(best.k, here.k)};
    }
    EXPECT_TRUE(best.on_it || best.k >= 1) << input.id;
    EXPECT_LE(best.k, 202) << input.id;
    if (best.on_it) ++kinds["on it"];
    else seen.insert(best.k);
    if (around.below < std::numeric_limits<T>::min()) ++kinds["subnormal"];
    if (around.above > std::numeric_limits<T>::max()) ++kinds["overflow"];
    if (in_binary64(input)) ++kinds["in binary64"];
  }
  EXPECT_GT(seen.size(), 60U);
  EXPECT_GE(*seen.rbegin(), 190);
  for (const char* kind : {"on it", "in binary64"}) EXPECT_GE(kinds[kind], 40) << kind;
  for (const char* kind : {"subnormal", "overflow"}) EXPECT_GE(kinds[kind], 1) << kind;
}

TEST(RoundingBoundary, Binary32) { expect_hard_to_round<float>("rounding_binary32"); }
TEST(RoundingBoundary, Binary64) { expect_hard_to_round<double>("rounding_binary64"); }

// --- Extremes

TEST(Hair, OverlapsByAPowerOfTwoWithOneOptimumOfAnyKind) {
  std::set<ContactKind> kinds;
  long thinnest = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Case input = find_family("hair_overlap")->make(seed, 8);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.optima().size(), 1U) << input.id;
    kinds.insert(depth.contact()->kind);
    const mpq_class share = depth.squared() / dot(depth.direction(), depth.direction());
    const long log = binary_logarithm(share) / 2;
    EXPECT_LE(log, -38) << input.id;
    thinnest = std::min(thinnest, log);
    EXPECT_GT(*second_nearest_squared(input.a.points, input.b.points, *depth.penetration()),
              times_power_of_two(depth.squared(), 40))
        << input.id;
  }
  EXPECT_EQ(kinds.size(), 6U);
  EXPECT_LT(thinnest, -180);
}

TEST(Hair, GapsAreBetweenTheFeatures) {
  std::set<std::pair<std::size_t, std::size_t>> features;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const Case input = find_family("hair_gap")->make(seed, 8);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.status(), Status::disjoint) << input.id;
    const Vector& n = depth.distance()->direction;
    EXPECT_LE(binary_logarithm(depth.distance()->squared / dot(n, n)) / 2, -58) << input.id;
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    const std::size_t a = kernels::extreme_points_naive(placed.a.points(), -n).size(),
                      b = kernels::extreme_points_naive(placed.b.points(), n).size();
    features.emplace(std::min<std::size_t>(a, 3), std::min<std::size_t>(b, 3));
  }
  EXPECT_EQ(features.size(), 9U);
}

TEST(Deep, IsNearlyTheSumOfTheRadii) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Case input = find_family("deep")->make(seed, 60);
    const Depth depth = solved(input);
    ASSERT_EQ(depth.status(), Status::penetrating);
    EXPECT_GT(depth.squared(), ratio(1, 4)) << input.id;
    EXPECT_LT(*second_nearest_squared(input.a.points, input.b.points, *depth.penetration()),
              depth.squared() * ratio(3, 2))
        << input.id;
  }
}

TEST(Stretched, ReachesARatioOfABillion) {
  double greatest = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Case input = find_family("stretched")->make(seed, 12);
    const Depth thickness = fathom::testing::exact_depth(input.a.points, input.a.points);
    const double ratio = 1 / std::sqrt(thickness.squared().get_d());
    EXPECT_GT(ratio, 1e3) << input.id;
    greatest = std::max(greatest, ratio);
  }
  EXPECT_GT(greatest, 4e8);
}

TEST(ApproachingDegraded, IsLeftBehind) {
  std::size_t rank = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Case input = find_family("approaching_degraded")->make(seed, 8);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    rank += polytope::affine_rank(placed.a.points()) == 3 && polytope::affine_rank(placed.b.points()) == 3 ? 1U : 0U;
    EXPECT_LE(solved(input).optima().size(), 1U) << input.id << ": ties are gone";
  }
  EXPECT_EQ(rank, 40U);
}

}  // namespace
}  // namespace fathom::families
