// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of all differences against brute force on small lattices, where every degeneracy is
// frequent, and the laws that hold for any answer.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <stdexcept>

#include "reference/depth/naive.hpp"
#include "tests/oracles/brute_oracle.hpp"
#include "tests/support/property.hpp"

namespace {

using namespace fathom;
using Points = std::vector<Vector>;

/// 1 to 8 points of a box of integers around O with half extents 0 to 3; half extent 0 makes a flat
/// body.
rc::Gen<Points> lattice_points() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([] {
                           const int x = *rc::gen::inRange(0, 4), y = *rc::gen::inRange(0, 4),
                                     z = *rc::gen::inRange(0, 4);
                           const int count = *rc::gen::inRange(1, 9);
                           Points points;
                           for (int i = 0; i < count; ++i) {
                             const int px = *rc::gen::inRange(-x, x + 1), py = *rc::gen::inRange(-y, y + 1),
                                       pz = *rc::gen::inRange(-z, z + 1);
                             points.push_back({px, py, pz});
                           }
                           return points;
                         }));
}

std::vector<Point> rational_points(const Points& points) {
  std::vector<Point> result;
  for (const Vector& v : points) result.push_back({v.x, v.y, v.z});
  return result;
}

template <class Map>
Points mapped(Points points, Map map) {
  for (Vector& v : points) v = map(v);
  return points;
}

Points sorted(Points directions) {
  std::ranges::sort(directions, lexicographically_less);
  return directions;
}

TEST(NaiveDepth, RefusesEmptyBodies) {
  const Points point{{0, 0, 0}};
  EXPECT_THROW(depth::naive_depth({}, point), std::invalid_argument);
  EXPECT_THROW(depth::naive_depth(point, {}), std::invalid_argument);
}

TEST(NaiveDepth, EqualsBruteForceOnSmallLattices) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    const oracles::OracleAnswer brute = oracles::brute_oracle(rational_points(a), rational_points(b));
    RC_CLASSIFY(naive.status == Status::penetrating, "penetrating");
    RC_CLASSIFY(naive.status == Status::touching, "touching");
    RC_ASSERT(naive.status == brute.status);
    RC_ASSERT(naive.squared == brute.squared);
    RC_ASSERT(naive.directions == brute.directions);
  }));
}

TEST(NaiveDepth, SwappedBodiesReverseTheDirections) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    depth::NaiveDepth expected = depth::naive_depth(a, b);
    expected.directions = sorted(mapped(expected.directions, [](const Vector& v) { return -v; }));
    RC_ASSERT(depth::naive_depth(b, a) == expected);
  }));
}

TEST(NaiveDepth, SimilarityScalesTheDepth) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    const auto turned = [](const Vector& v) { return Vector{v.y, -v.z, v.x}; };
    const auto placed = [&](const Vector& v) { return turned({3 * v.x + 10, 3 * v.y - 7, 3 * v.z + 1000}); };
    depth::NaiveDepth expected = depth::naive_depth(a, b);
    expected.squared *= 9;
    expected.directions = sorted(mapped(expected.directions, turned));
    RC_ASSERT(depth::naive_depth(mapped(a, placed), mapped(b, placed)) == expected);
  }));
}

TEST(NaiveDepth, OrderAndRepetitionOfPointsDoNotMatter) {
  EXPECT_TRUE(holds({.seed = 41, .runs = 1000}, [] {
    const Points a = *lattice_points(), b = *lattice_points();
    Points again(a.rbegin(), a.rend());
    again.insert(again.end(), a.begin(), a.end());
    RC_ASSERT(depth::naive_depth(again, b) == depth::naive_depth(a, b));
  }));
}

}  // namespace
