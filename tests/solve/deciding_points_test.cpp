// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose denominators share few factors. The oracle is the same pair times a common
// denominator: integers, which are placed directly.
#include "reference/solve/deciding_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/check/check.hpp"

namespace fathom::solve {
namespace {

/// Numbers near those that are asked for, over random odd denominators of 32 bits.
class Unlike {
 public:
  explicit Unlike(std::uint64_t seed) : random_(seed) {}

  mpq_class near(double x) {
    const mpz_class denominator = static_cast<unsigned long>(random_() >> 32 | std::uint64_t{1} << 31 | 1);
    mpq_class q(mpz_class(mpf_class(x, 64) * denominator), denominator);
    q.canonicalize();
    return q;
  }
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }

  /// Points near the sphere of radius 1 about (x, 0, 0).
  std::vector<Point> sphere(int n, double x) {
    std::vector<Point> points;
    while (static_cast<int>(points.size()) < n) {
      const double p = unit(), q = unit(), r = unit(), length = std::sqrt(p * p + q * q + r * r);
      if (length < 0.1 || length > 1) continue;
      points.push_back({near(p / length + x), near(q / length), near(r / length)});
    }
    return points;
  }
  /// Points of a square of side 2 parallel to the plane of y and z, at one x.
  std::vector<Point> square(int n, const mpq_class& x) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) points.push_back({x, near(unit()), near(unit())});
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) points.push_back({x, y, z});
    return points;
  }

 private:
  std::mt19937_64 random_;
};

using Points = std::vector<Point>;

Points times(const Points& points, const mpq_class& factor) {
  Points result;
  for (const Point& p : points) result.push_back({p.x * factor, p.y * factor, p.z * factor});
  return result;
}

Point times(const Point& p, const mpq_class& factor) { return times(Points{p}, factor).front(); }

void expect_same(const Depth& depth, const Depth& large, const mpq_class& factor) {
  EXPECT_EQ(depth.status(), large.status());
  EXPECT_EQ(depth.squared() * factor * factor, large.squared());
  EXPECT_EQ(depth.flat_a, large.flat_a);
  EXPECT_EQ(depth.flat_b, large.flat_b);
  EXPECT_EQ(times(depth.translation(), factor), large.translation());
  ASSERT_EQ(depth.optima().size(), large.optima().size());
  for (std::size_t i = 0; i < depth.optima().size(); ++i) {
    EXPECT_EQ(depth.optima()[i].direction, large.optima()[i].direction);
    EXPECT_EQ(times(depth.optima()[i].translation(), factor), large.optima()[i].translation());
    EXPECT_EQ(depth.optima()[i].contact, large.optima()[i].contact);
  }
  if (depth.status() == Status::penetrating) {
    EXPECT_EQ(depth.direction(), large.direction());
    EXPECT_EQ(times(depth.witness()->a, factor), large.witness()->a);
    EXPECT_EQ(times(depth.witness()->b, factor), large.witness()->b);
  }
  ASSERT_EQ(!depth.distance(), !large.distance());
  if (!depth.distance()) return;
  EXPECT_EQ(depth.distance()->squared * factor * factor, large.distance()->squared);
  EXPECT_EQ(depth.distance()->direction, large.distance()->direction);
  EXPECT_EQ(times(depth.distance()->translation, factor), large.distance()->translation);
}

/// By every method, against integers; with the proof.
void expect_right(const Points& a, const Points& b, Status status) {
  ASSERT_FALSE(polytope::place_if_slim(a, b));
  const mpz_class factor = polytope::place(a, b).denominator * b[0].x.get_den() * b[0].y.get_den() * b[0].z.get_den();
  const Depth large = penetration_depth(times(a, factor), times(b, factor));
  EXPECT_EQ(large.status(), status);
  for (const Method method : {Method::automatic, Method::exact, Method::certificate, Method::naive}) {
    const Depth depth = penetration_depth(a, b, {.method = method, .validate = true});
    expect_same(depth, large, factor);
    const fathom_check::Verdict verdict = fathom_check::verify(certificate_text(make_certificate(a, b, depth)));
    EXPECT_TRUE(verdict.accepted()) << verdict.reason;
  }
}

TEST(DecidingPoints, SpheresThatPenetrate) {
  for (std::uint64_t seed = 1; seed < 3; ++seed) {
    Unlike some(seed);
    expect_right(some.sphere(100, 0), some.sphere(100, 1.3), Status::penetrating);
  }
}

TEST(DecidingPoints, SpheresApart) {
  Unlike some(5);
  expect_right(some.sphere(100, 0), some.sphere(100, 2.5), Status::disjoint);
}

TEST(DecidingPoints, ABodyAgainstItselfTies) {
  Unlike some(6);
  const Points a = some.sphere(200, 0);
  expect_right(a, a, Status::penetrating);
}

TEST(DecidingPoints, AFaceOfManyPointsIsListedWhole) {
  Unlike some(7);
  Points a = some.sphere(100, 0), b = some.square(30, mpq_class(1, 3));
  expect_right(a, b, Status::penetrating);
  const Points far = some.square(100, mpq_class(7, 3));
  b.insert(b.end(), far.begin(), far.end());
  expect_right(a, b, Status::penetrating);
}

TEST(DecidingPoints, FlatBodiesAndBodiesThatTouch) {
  Unlike some(8);
  const Points flat = some.square(100, mpq_class(1, 7));
  expect_right(flat, some.sphere(100, 0.2), Status::penetrating);
  Points a = some.sphere(100, 3);
  a.push_back({mpq_class(1, 7), 0, 0});
  expect_right(flat, a, Status::touching);
}

// Seen from the grid, the bodies are needles.
TEST(DecidingPoints, WhatTheGridDoesNotShowIsFoundAllTheSame) {
  Unlike some(9);
  Points a = some.sphere(100, 0), b = some.sphere(100, 0.3);
  for (Points* body : {&a, &b})
    for (Point& p : *body) p.y /= mpq_class(mpz_class(1) << 150);
  expect_right(a, b, Status::penetrating);
}

TEST(DecidingPoints, MostPointsNeverMeetTheOthersDenominators) {
  Unlike some(10);
  const Points a = some.sphere(1000, 0), b = some.sphere(1000, 1.3);
  const Counters counters = testing::exact_depth(a, b).counters;
  EXPECT_GT(counters.vertices_a + counters.vertices_b, 8U);
  EXPECT_LT(counters.vertices_a + counters.vertices_b, 200U);  // of 2000
}

TEST(DecidingPoints, DenominatorsThatRepeatAreNoReason) {
  std::vector<Point> a, b;
  for (int i = 0; i < 2000; ++i) {
    a.push_back({mpq_class(i, 101), mpq_class(i * i, 103), mpq_class(1, i % 10 + 1)});
    for (mpq_class* c : {&a.back().x, &a.back().y}) c->canonicalize();
  }
  b = a;
  EXPECT_TRUE(polytope::place_if_slim(a, b));
}

TEST(DecidingPoints, ALatticeBeyondAllBoundsIsRefused) {
  Unlike some(11);
  const Points a = some.sphere(9000, 0);
  try {
    static_cast<void>(polytope::place(a, a));
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "input: the denominators of the 18000 points share too little: over a common one all coordinates "
                 "together would pass 256 MB");
  }
}

}  // namespace
}  // namespace fathom::solve
