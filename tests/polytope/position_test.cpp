// SPDX-License-Identifier: GPL-3.0-or-later
// The position of O against a brute-force twin on small lattices, under exact linear maps, in every
// kind of touching; growth.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>

#include "tests/polytope/position_twin.hpp"
#include "tests/support/property.hpp"

namespace fathom::polytope::position_test {
namespace {

TEST(PositionOfOrigin, AgreesWithTheNaiveTwinOnSmallLattices) {
  std::array<int, 3> seen{};
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 6000}, [&seen] {
    const SmallSet a = *lattice_set(), b = *lattice_set();
    const Position expected = position_naive(a, b);
    ++seen[static_cast<std::size_t>(expected)];
    RC_ASSERT(position(a, b) == expected);
  }));
  for (const int count : seen) EXPECT_GT(count, 300) << "every position must have been met often";
}

// Bodies shifted so that a random pair of points coincides: O is never outside, and on the boundary
// in every dimension of face.
TEST(PositionOfOrigin, AgreesWithTheNaiveTwinOnSharedPoints) {
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 3000}, [] {
    SmallSet a = *lattice_set();
    const SmallSet b = *lattice_set();
    const Small shift = b[*rc::gen::inRange<std::size_t>(0, b.size())] - a[*rc::gen::inRange<std::size_t>(0, a.size())];
    for (Small& p : a) p = p + shift;
    RC_ASSERT(position(a, b) == position_naive(a, b));
  }));
}

struct Affine {
  std::array<Vector, 3> rows;
  Vector shift;
  Vector operator()(const Small& s) const {
    const Vector p = exact(s);
    return Vector{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} + shift;
  }
};

mpz_class wild(std::mt19937_64& random, unsigned long bits) {
  mpz_class r = static_cast<unsigned long>(random() % 1000);
  r <<= random() % bits;
  r += static_cast<unsigned long>(random() % 1000);
  return random() & 1 ? r : mpz_class(-r);
}

// An invertible affine map keeps the position; its entries have up to thousands of bits, so images
// in binary64 decide nothing.
TEST(PositionOfOrigin, IsInvariantUnderExactAffineMaps) {
  std::mt19937_64 random(1);
  int repeat = 0;
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 600}, [&] {
    const SmallSet a = *lattice_set(), b = *lattice_set();
    const unsigned long bits = ++repeat % 10 == 0 ? 3000 : 60;
    Affine map;
    do {
      for (Vector& row : map.rows) row = {wild(random, bits), wild(random, bits), wild(random, bits)};
    } while (det(map.rows[0], map.rows[1], map.rows[2]) == 0);
    map.shift = {wild(random, bits), wild(random, bits), wild(random, bits)};
    std::vector<Vector> mapped_a, mapped_b;
    for (const Small& p : a) mapped_a.push_back(map(p));
    for (const Small& p : b) mapped_b.push_back(map(p));
    RC_ASSERT(proved(mapped_a, mapped_b).position == position_naive(a, b));
    RC_ASSERT(proved(mapped_b, mapped_a).position == position_naive(a, b));
  }));
}

TEST(PositionOfOrigin, AllNineKindsOfTouching) {
  for (const std::string a : {"vertex", "edge", "facet"}) {
    for (const std::string b : {"vertex", "edge", "facet"}) {
      EXPECT_EQ(position(solid_with(a), mirrored(solid_with(b), 0)), Position::boundary) << a << " against " << b;
      EXPECT_EQ(position(solid_with(a), mirrored(solid_with(b), 1)), Position::outside) << a << " against " << b;
      EXPECT_EQ(position(solid_with(a), mirrored(solid_with(b), -1)), Position::inside) << a << " against " << b;
    }
  }
}

TEST(PositionOfOrigin, HairThinGapsAndOverlaps) {
  mpz_class scale = 1;
  scale <<= 3000;
  for (const std::string a : {"vertex", "edge", "facet"}) {
    for (const std::string b : {"vertex", "edge", "facet"}) {
      for (const int gap : {-1, 0, 1}) {
        std::vector<Vector> points_a, points_b;
        for (const Small& p : solid_with(a)) points_a.push_back({scale * p.x, scale * p.y, scale * p.z});
        for (const Small& p : mirrored(solid_with(b), 0))
          points_b.push_back({scale * p.x, scale * p.y, scale * p.z + gap});
        const Position expected = gap < 0 ? Position::inside : gap == 0 ? Position::boundary : Position::outside;
        EXPECT_EQ(proved(points_a, points_b).position, expected) << a << " against " << b << ", gap " << gap;
      }
    }
  }
}

TEST(PositionOfOrigin, FlatBodies) {
  const SmallSet point{{0, 0, 0}}, segment{{-1, 0, 0}, {1, 0, 0}}, across{{0, -1, 0}, {0, 1, 0}};
  const SmallSet upright{{0, 0, -1}, {0, 0, 1}}, square{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const SmallSet cube{{-2, -2, -2}, {2, -2, -2}, {-2, 2, -2}, {2, 2, -2},
                      {-2, -2, 2},  {2, -2, 2},  {-2, 2, 2},  {2, 2, 2}};
  const SmallSet apart{{9, 0, 0}}, far_segment{{5, 1, 0}, {6, 2, 0}};
  for (const SmallSet& s : {point, segment, across, upright, square}) {
    EXPECT_EQ(position(s, s), Position::boundary);
    EXPECT_EQ(position(point, s), Position::boundary);
    EXPECT_EQ(position(s, point), Position::boundary);
    EXPECT_EQ(position(s, cube), Position::inside);
    EXPECT_EQ(position(cube, s), Position::inside);
    EXPECT_EQ(position(s, apart), Position::outside);
    EXPECT_EQ(position(far_segment, s), Position::outside);
  }
  EXPECT_EQ(position(segment, across), Position::boundary);
  EXPECT_EQ(position(square, segment), Position::boundary);
  EXPECT_EQ(position(square, upright), Position::inside) << "P is solid though both bodies are flat";
  EXPECT_EQ(position(square, {{0, 0, 0}, {0, 0, 1}}), Position::boundary);
  EXPECT_EQ(position({{2, 2, 2}}, cube), Position::boundary);
  EXPECT_EQ(position({{2, 2, 0}}, cube), Position::boundary);
  EXPECT_EQ(position({{2, 0, 0}}, cube), Position::boundary);
  EXPECT_EQ(position(cube, cube), Position::inside) << "identical bodies";
}

TEST(PositionOfOrigin, RefusesWhatItCannotAnswer) {
  const std::vector<Vector> some{{1, 2, 3}};
  EXPECT_THROW(position_of_origin(kernels::PointCloud(), kernels::PointCloud(some)), std::invalid_argument);
  EXPECT_THROW(position_of_origin(kernels::PointCloud(some), kernels::PointCloud()), std::invalid_argument);
  EXPECT_THROW(position_of_origin(kernels::PointCloud(some, 5), kernels::PointCloud(some, 6)), std::invalid_argument);
}

TEST(PositionOfOrigin, IsDeterministic) {
  const std::vector<Vector> a = exact(solid_with("edge")), b = exact(mirrored(solid_with("facet"), -1));
  EXPECT_EQ(proved(a, b).surrounding, proved(a, b).surrounding);
}

enum class Shape { ball, lattice, paraboloid };

// Points of a body that lies in z <= 0 and touches z = 0 in O. lattice: heavy ties; paraboloid:
// every point extreme.
std::vector<Vector> hanging(std::mt19937_64& random, std::size_t n, Shape shape) {
  const double unit = shape == Shape::lattice ? 8 : std::ldexp(1.0, 40);
  const auto coordinate = [&random] { return std::ldexp(static_cast<double>(random() >> 11), -52) - 1; };
  std::vector<Vector> points{{0, 0, 0}};
  while (points.size() < n) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    const double square = x * x + y * y;
    if (shape == Shape::ball && square + z * z > 1) continue;
    const double height = shape == Shape::paraboloid ? -square : z - 1;
    points.push_back(
        {mpz_class(std::round(unit * x)), mpz_class(std::round(unit * y)), mpz_class(std::round(unit * height))});
  }
  return points;
}

// B: the same kind of body, standing on z = 0, raised by `lift`.
std::vector<Vector> standing(std::mt19937_64& random, std::size_t n, Shape shape, long lift) {
  std::vector<Vector> points = hanging(random, n, shape);
  for (Vector& p : points) p.z = lift - p.z;
  return points;
}

// Linear expected time, in its machine-independent part: scans do not grow with the number of
// points.
TEST(PositionOfOrigin, ScansStayFewOnLargeInput) {
  std::mt19937_64 random(7);
  const std::array<std::pair<long, Position>, 3> cases{
      {{1, Position::outside}, {0, Position::boundary}, {-1, Position::inside}}};
  for (const Shape shape : {Shape::ball, Shape::lattice, Shape::paraboloid}) {
    for (const std::size_t n : {500UL, 3000UL, 20000UL}) {
      for (const auto& [lift, expected] : cases) {
        const PositionOfOrigin answer = proved(hanging(random, n, shape), standing(random, n, shape, lift));
        EXPECT_EQ(answer.position, expected)
            << n << " points a side of shape " << static_cast<int>(shape) << ", lift " << lift;
        EXPECT_LE(answer.scans, 30U);
      }
    }
  }
}

TEST(PositionOfOrigin, ScansStayFewOnAMillionPointsASide) {
  std::mt19937_64 random(8);
  constexpr std::size_t n = 1000000;
  constexpr long exponent = 41;
  const kernels::PointCloud a(hanging(random, n, Shape::ball), exponent),
      b(standing(random, n, Shape::ball, 0), exponent);
  const PositionOfOrigin touching = position_of_origin(a, b);
  EXPECT_EQ(touching.position, Position::boundary);
  EXPECT_LE(touching.scans, 30U);
  const PositionOfOrigin overlapping = position_of_origin(a, a);
  EXPECT_EQ(overlapping.position, Position::inside);
  EXPECT_LE(overlapping.scans, 30U);
  std::cerr << "scans of a million points a side: " << touching.scans << " touching, " << overlapping.scans
            << " inside\n";
}

}  // namespace
}  // namespace fathom::polytope::position_test
