// SPDX-License-Identifier: GPL-3.0-or-later
// The running minimum against a twin that remembers all offers and sorts them when asked.
#include "kernels/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

struct Plane {
  Vector normal;
  mpz_class height;
  friend std::ostream& operator<<(std::ostream& out, const Plane& p) {
    return out << '<' << p.normal << ", x> = " << p.height;
  }
};

/// Squared distance of a plane from O.
mpq_class squared_distance(const Plane& p) {
  mpq_class r(p.height * p.height, dot(p.normal, p.normal));
  r.canonicalize();
  return r;
}

mpq_class squared_distance(const NearestPlanes& nearest) {
  mpq_class r(nearest.numerator(), nearest.denominator());
  r.canonicalize();
  return r;
}

std::vector<Vector> directions_of(const NearestPlanes& nearest) {
  return {nearest.directions().begin(), nearest.directions().end()};
}

/// The twin: least distance, and the primitive normals at that distance, sorted, each once.
std::pair<mpq_class, std::vector<Vector>> naive(const std::vector<Plane>& planes) {
  std::pair<mpq_class, std::vector<Vector>> result;
  auto& [least, normals] = result;
  for (const Plane& p : planes) {
    if (p.height > 0 && (normals.empty() || squared_distance(p) < least)) {
      least = squared_distance(p);
      normals.assign(1, Vector{});
    }
  }
  normals.clear();
  for (const Plane& p : planes) {
    if (p.height > 0 && squared_distance(p) == least) normals.push_back(primitive(p.normal));
  }
  std::sort(normals.begin(), normals.end(), lexicographically_less);
  normals.erase(std::unique(normals.begin(), normals.end()), normals.end());
  return result;
}

void expect_as_naive(const std::vector<Plane>& planes) {
  NearestPlanes nearest;
  std::vector<Plane> so_far;
  for (const Plane& p : planes) {
    const bool among = nearest.offer(p.normal, p.height);
    so_far.push_back(p);
    const auto [least, normals] = naive(so_far);
    ASSERT_EQ(nearest.empty(), normals.empty());
    ASSERT_EQ(among, p.height > 0 && squared_distance(p) == least) << p;
    if (normals.empty()) continue;
    ASSERT_EQ(squared_distance(nearest), least) << p;
    ASSERT_EQ(directions_of(nearest), normals) << p;
  }
}

TEST(NearestPlanes, IsTheMinimumOfAllOffers) {
  for (const Size size : all_sizes) {
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] {
      std::vector<Plane> planes;
      const int count = *rc::gen::inRange(0, 12);
      for (int i = 0; i < count; ++i) planes.push_back({*directions(size), *integers(size)});
      expect_as_naive(planes);
    }));
  }
}

// The same distance in many directions: permuted components, multiples, and neighbours by one unit.
TEST(NearestPlanes, KeepsTiesOfLargeNumbers) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Size size = *rc::gen::element(Size::word, Size::long_);
    const Vector n = *directions(size);
    const mpz_class h = abs(*integers(size)) + 1;
    std::vector<Plane> planes{{n, h}};
    const int count = *rc::gen::inRange(1, 8);
    for (int i = 0; i < count; ++i) {
      const mpz_class s = *rc::gen::element(mpz_class(1), mpz_class(7), power_of_two(90));
      const Vector turned = *rc::gen::element(n, -n, Vector{n.y, n.z, n.x}, Vector{n.y, n.x, mpz_class(-n.z)});
      const int off = *rc::gen::element(0, 0, 0, 1, -1);
      planes.push_back({s * turned, mpz_class(s * h + off)});
    }
    expect_as_naive(planes);
  }));
}

TEST(NearestPlanes, IgnoresPlanesThroughOAndBeyond) {
  NearestPlanes nearest;
  EXPECT_FALSE(nearest.offer(Vector{1, 0, 0}, 0));
  EXPECT_FALSE(nearest.offer(Vector{1, 0, 0}, -1));
  EXPECT_TRUE(nearest.empty());
  EXPECT_TRUE(nearest.offer(Vector{0, 0, 5}, 10));
  EXPECT_FALSE(nearest.offer(Vector{0, 0, 1}, -2));
  EXPECT_FALSE(nearest.offer(Vector{1, 0, 0}, 0));
  EXPECT_EQ(squared_distance(nearest), 4);
}

TEST(NearestPlanes, ListsEachDirectionOnceAndInOrder) {
  NearestPlanes nearest;
  EXPECT_TRUE(nearest.offer(Vector{0, 0, 3}, 6));
  EXPECT_TRUE(nearest.offer(Vector{0, 0, 1}, 2));
  EXPECT_TRUE(nearest.offer(Vector{0, -2, 0}, 4));
  EXPECT_TRUE(nearest.offer(Vector{-1, 0, 0}, 2));
  EXPECT_TRUE(nearest.offer(Vector{4, 0, 0}, 8));
  EXPECT_TRUE(nearest.offer(Vector{0, 1, 0}, 2));
  EXPECT_EQ(directions_of(nearest), (std::vector<Vector>{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_FALSE(nearest.offer(Vector{3, 4, 0}, 11));
  EXPECT_EQ(nearest.directions().size(), 5U);
  EXPECT_TRUE(nearest.offer(Vector{3, 4, 0}, 9));
  EXPECT_EQ(directions_of(nearest), (std::vector<Vector>{{3, 4, 0}}));
}

}  // namespace
}  // namespace fathom::kernels
