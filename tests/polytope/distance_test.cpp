// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of disjoint bodies against brute force, and one signed function across contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "kernels/number/rational.hpp"
#include "reference/polytope/position.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::polytope {
namespace {

using testing::random_vector;
using testing::text;

/// By definition: the nearest feature of P is a vertex, an edge or a facet, so the least distance
/// of O to the hulls of one, two or three differences is the answer, whether or not these lie on
/// the boundary of P.
mpq_class brute_force(std::span<const Vector> a, std::span<const Vector> b) {
  std::vector<Vector> p;
  for (const Vector& x : a)
    for (const Vector& y : b) p.push_back(y - x);
  mpq_class best = dot(p[0], p[0]);
  const auto offer = [&](const mpz_class& numerator, const mpz_class& denominator) {
    best = std::min(best, kernels::ratio(numerator, denominator));
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    offer(dot(p[i], p[i]), 1);
    for (std::size_t j = 0; j < i; ++j) {
      const Vector e = p[j] - p[i];
      const mpz_class square = dot(e, e), w = -dot(p[i], e);
      if (w <= 0 || w >= square) continue;
      const Vector moment = cross(p[i], e);
      offer(dot(moment, moment), square);
    }
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Vector e = p[j] - p[i], f = p[k] - p[i], n = cross(e, f);
        if (is_zero(n)) continue;
        const mpz_class v = det(-p[i], f, n), u = det(e, -p[i], n), whole = dot(n, n), height = dot(n, p[i]);
        if (v >= 0 && u >= 0 && v + u <= whole) offer(height * height, whole);
      }
    }
  }
  return best;
}

NearestPoints solve(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  const PlacedPair placed = place_integers(a, b);
  return nearest_points(placed.a, placed.b);
}

mpq_class squared(const NearestPoints& z) { return kernels::ratio(z.height * z.height, dot(z.normal, z.normal)); }

std::vector<Vector> random_points(std::mt19937_64& random, std::size_t n, unsigned bits, const Vector& shift) {
  std::vector<Vector> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(random_vector(random, bits) + shift);
  return points;
}

TEST(NearestPoints, EqualsBruteForceOnSmallBodies) {
  std::mt19937_64 random(5);
  std::size_t kinds[4] = {};
  for (int round = 0; round < 400; ++round) {
    const unsigned bits = round % 2 == 0 ? 2 : 40;  // a small lattice is full of ties
    mpz_class far = 1;
    far <<= bits;
    const std::vector<Vector> a = random_points(random, 1 + random() % 4, bits, {0, 0, 0});
    const std::vector<Vector> b =
        random_points(random, 1 + random() % 4, bits, random_vector(random, bits) + Vector{far, far, 0});
    const PlacedPair placed = place_integers(a, b);
    if (position_of_origin(placed.a, placed.b).position != Position::outside) {
      EXPECT_THROW(solve(a, b), std::invalid_argument);
      ++kinds[0];
      continue;
    }
    const NearestPoints z = solve(a, b);
    const kernels::Report report = validate(z, a, b);
    EXPECT_TRUE(report.ok()) << text(report);
    EXPECT_EQ(squared(z), brute_force(a, b)) << round;
    ++kinds[std::min<std::size_t>(3, std::max(z.a.size(), z.b.size()))];
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 3U);
}

TEST(NearestPoints, ManyPoints) {
  std::mt19937_64 random(6);
  for (const std::size_t n : {100U, 3000U}) {
    const std::vector<Vector> a = random_points(random, n, 30, {0, 0, 0});
    mpz_class far = 3;
    far <<= 30;
    const std::vector<Vector> b = random_points(random, n, 30, {far, 17, -far});
    const NearestPoints z = solve(a, b);
    const kernels::Report report = validate(z, a, b);
    EXPECT_TRUE(report.ok()) << text(report);
    EXPECT_LT(z.scans, 60U);
  }
}

// Every fault that an answer can have is found.
TEST(NearestPoints, ValidateHasTeeth) {
  const std::vector<Vector> a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, b{{1, 1, 5}, {2, 3, 9}};
  const NearestPoints good = solve(a, b);
  ASSERT_TRUE(validate(good, a, b).ok());
  const auto broken = [&](auto change) {
    NearestPoints wrong = good;
    change(wrong);
    return !validate(wrong, a, b).ok();
  };
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = -z.normal; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = {0, 0, 0}; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = {0, 0, -2}; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.normal = {0, 1, -9}; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.height += 1; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.a[0].weight += 1; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.a[0].index = 7; }));
  EXPECT_TRUE(broken([](NearestPoints& z) { z.b[0].index = 1; }));
}

Depth depth_of(const Case& pair) { return testing::exact_depth(pair.a.points, pair.b.points); }

Case moved(Case pair, const Point& t) {
  for (Point& p : pair.a.points.edit()) p = {p.x + t.x, p.y + t.y, p.z + t.z};
  return pair;
}

// Over all families, each body A moved away far enough: the laws of the result, and what moving A
// by the translation does.
TEST(Distance, TranslationBringsTheBodiesIntoTouch) {
  std::size_t disjoint = 0;
  for (Case input : testing::cases_of_all_families(2, 9)) {
    if (depth_of(input).status() != Status::disjoint) input = moved(input, {mpq_class(7, 3), 1, 40});
    const Depth depth = depth_of(input);
    EXPECT_EQ(depth.distance() != nullptr, depth.status() == Status::disjoint) << input.id;
    if (!depth.distance()) continue;
    ++disjoint;
    const Distance& d = *depth.distance();
    const Point& t = d.translation;
    EXPECT_EQ(t.x * t.x + t.y * t.y + t.z * t.z, d.squared) << input.id;
    EXPECT_EQ(signed_square(depth), -d.squared) << input.id;
    const mpq_class h = testing::support(input.a.points, input.b.points, d.direction);
    EXPECT_LT(h, 0) << input.id;
    EXPECT_EQ(h * h, d.squared * dot(d.direction, d.direction)) << input.id;
    const Point &a = d.witness.a, &b = d.witness.b;
    EXPECT_EQ((Point{b.x - a.x, b.y - a.y, b.z - a.z}), t) << input.id;
    EXPECT_TRUE(testing::in_hull(a, input.a.points, testing::all_of(input.a.points))) << input.id;
    EXPECT_TRUE(testing::in_hull(b, input.b.points, testing::all_of(input.b.points))) << input.id;
    EXPECT_EQ(depth_of(moved(input, t)).status(), Status::touching) << input.id;
    const mpq_class half(1, 2);
    EXPECT_EQ(signed_square(depth_of(moved(input, {half * t.x, half * t.y, half * t.z}))), -d.squared / 4) << input.id;
  }
  EXPECT_GT(disjoint, 60U);
}

// Two unit cubes on a line: the signed distance is linear all the way.
TEST(Distance, OneSignedFunctionAcrossContact) {
  std::vector<Point> a, b;
  for (int i = 0; i < 8; ++i) a.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  for (int step = -4; step <= 4; ++step) {
    const mpq_class gap = kernels::ratio(step, 9);
    b = a;
    for (Point& p : b) p.x += 1 + gap;
    const Depth depth = penetration_depth(a, b);
    EXPECT_EQ(signed_square(depth), step > 0 ? mpq_class(-gap * gap) : mpq_class(gap * gap));
    EXPECT_EQ(depth.status(), step > 0 ? Status::disjoint : step == 0 ? Status::touching : Status::penetrating);
    if (step > 0) {
      EXPECT_EQ(depth.distance()->direction, (Vector{-1, 0, 0}));
    }
  }
}

}  // namespace
}  // namespace fathom::polytope
