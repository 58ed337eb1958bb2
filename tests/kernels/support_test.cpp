// SPDX-License-Identifier: GPL-3.0-or-later
// The filtered scan against exact arithmetic, above all where values tie or differ by less than
// binary64 can see.

#include "kernels/filters/support.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <iostream>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "fathom/files.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"
#include "verify/families/families.hpp"

namespace fathom::kernels {
namespace {

using testing::power_of_two;
using testing::random_integer;
using testing::random_vector;

using Random = std::mt19937_64;

long below(Random& random, long n) { return static_cast<long>(random() % static_cast<std::uint64_t>(n)); }

Vec3<LazyInteger> lazy(const Vector& v) { return {LazyInteger(v.x), LazyInteger(v.y), LazyInteger(v.z)}; }

void expect_scans_agree(const PointCloud& cloud, const Vector& u, Random& random) {
  const std::vector<std::uint32_t> extreme = extreme_points_naive(cloud.points(), u);
  ASSERT_EQ(extreme_points(cloud, u), extreme);
  if (cloud.size() > 0 && !is_zero(u)) {
    const LazyCloud lazy_cloud(cloud);
    ASSERT_EQ(extreme_points(lazy_cloud, lazy(u)), extreme);
    ASSERT_EQ(extreme_points(lazy_cloud, lazy(u), extreme), extreme);
    // Of a product an enclosure may be all that is known.
    const LazyInteger factor(power_of_two(150) + 1);
    ASSERT_EQ(extreme_points(lazy_cloud, factor * lazy(u)), extreme);
  }
  for (int repeat = 0; repeat < 3 && cloud.size() > 0; ++repeat) {
    const auto k = static_cast<std::uint32_t>(below(random, static_cast<long>(cloud.size())));
    ASSERT_EQ(points_beyond(cloud, u, k), points_beyond_naive(cloud.points(), u, k));
  }
}

// Points of one plane <u, p> = c, up to a few units of <u, p>: closer together than the filter can
// tell.
std::vector<Vector> nearly_coplanar(Random& random, const Vector& u, unsigned long bits, std::size_t n) {
  std::vector<Vector> points;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector in_plane = cross(u, random_vector(random, bits));
    points.push_back(in_plane + Vector{mpz_class(below(random, 4)), 0, 0});
  }
  return points;
}

TEST(BinaryExponent, IsTheLeastThatCovers) {
  const auto of = [](const mpz_class& x) {
    const Vector p{0, x, 0};
    return binary_exponent(std::span(&p, 1));
  };
  EXPECT_EQ(binary_exponent(std::span<const Vector>{}), 0);
  EXPECT_EQ(of(0), 0);
  EXPECT_EQ(of(1), 0);
  EXPECT_EQ(of(-1), 0);
  EXPECT_EQ(of(2), 1);
  EXPECT_EQ(of(-3), 2);
  EXPECT_EQ(of(-4), 2);
  EXPECT_EQ(of(5), 3);
  EXPECT_EQ(of(power_of_two(4000)), 4000);
  EXPECT_EQ(of(-power_of_two(4000) - 1), 4001);
}

TEST(PointCloud, ImagesAreWithinTheStatedError) {
  Random random(1);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    std::vector<Vector> points;
    for (int i = 0; i < 3; ++i)
      points.push_back(random_vector(random, 1 + static_cast<unsigned long>(below(random, 3000))));
    const long exponent = binary_exponent(points) + below(random, 60);
    const PointCloud cloud(points, exponent);
    const auto unit = [](long e) { return mpq_class(1, power_of_two(static_cast<unsigned long>(e))); };
    const Vec3<long>& e = cloud.axis_exponents();
    const mpq_class bound = unit(52);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(abs(cloud.xs()[i] - points[i].x * unit(e.x)), bound);
      EXPECT_LE(abs(cloud.ys()[i] - points[i].y * unit(e.y)), bound);
      EXPECT_LE(abs(cloud.zs()[i] - points[i].z * unit(e.z)), bound);
      for (const double c : {cloud.xs()[i], cloud.ys()[i], cloud.zs()[i]}) {
        EXPECT_LE(std::abs(c), 1);
        EXPECT_NE(std::fpclassify(c), FP_SUBNORMAL);
      }
    }
  }
}

// 1 by 10^-300 by 10^300: seen by one power of two for all axes, two of them would be nothing.
TEST(PointCloud, EachAxisOfAStretchedBodyIsSeen) {
  Random random(2);
  std::vector<Vector> points;
  for (int i = 0; i < 10; ++i) {
    const Vector v = random_vector(random, 60);
    points.push_back({v.x * power_of_two(1000), v.y, v.z * power_of_two(2000)});
  }
  const PointCloud cloud(points);
  for (const std::span<const double> images : {cloud.xs(), cloud.ys(), cloud.zs()}) {
    double greatest = 0;
    for (const double c : images) greatest = std::max(greatest, std::abs(c));
    EXPECT_GE(greatest, 0.5);
  }
  for (int repeat = 0; repeat < 100; ++repeat) {
    const Vector u = random_vector(random, 50);
    for (const Vector& v : {u, Vector{u.x * power_of_two(1000), u.y * power_of_two(2000), u.z}}) {
      EXPECT_EQ(extreme_points(cloud, v), extreme_points_naive(points, v));
      EXPECT_EQ(points_beyond(cloud, v, 3), points_beyond_naive(points, v, 3));
    }
  }
}

TEST(PointCloud, RefusesAnExponentThatIsTooSmall) {
  EXPECT_NO_THROW(PointCloud({{4, 0, -4}}, 2));
  EXPECT_THROW(PointCloud({{5, 0, 0}}, 2), std::invalid_argument);
}

TEST(ExtremePoints, ZeroDirectionAndEmptyCloud) {
  const PointCloud cloud({{1, 2, 3}, {0, 0, 0}});
  EXPECT_EQ(extreme_points(cloud, {0, 0, 0}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(points_beyond(cloud, {0, 0, 0}, 1).empty());
  EXPECT_TRUE(extreme_points(PointCloud(), {1, 2, 3}).empty());
  EXPECT_TRUE(extreme_points(PointCloud(), {0, 0, 0}).empty());
}

TEST(ExtremePoints, TiesAreAllListed) {
  const PointCloud cube(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 1, 1}});
  EXPECT_EQ(extreme_points(cube, {1, 0, 0}), (std::vector<std::uint32_t>{1, 3, 5, 7, 8}));
  EXPECT_EQ(extreme_points(cube, {power_of_two(900), 0, 1}), (std::vector<std::uint32_t>{5, 7, 8}));
  EXPECT_EQ(extreme_points(cube, {-power_of_two(900), 0, -1}), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(points_beyond(cube, {-power_of_two(900), 0, -1}, 5), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 6}));
}

// Two points that no image can tell apart, since the exponent is that of another, far larger point.
/// Each coordinate has its own size, and all points have one large part in common: binary64 sees
/// one point, wide floats tell them apart.
TEST(ExtremePoints, AreFoundInWideFloatsWhereCoordinatesDifferInSize) {
  Random random(12);
  std::uint64_t computed = 0;
  for (int i = 0; i < 300; ++i) {
    const auto any_size = [&] { return mpz_class(random_integer(random, 20) << (random() % 1000)); };
    const auto any_vector = [&] { return Vector{any_size(), any_size(), any_size()}; };
    const Vector far{power_of_two(2000), 5 * power_of_two(1900), 3 * power_of_two(1990)};
    std::vector<Vector> points;
    for (int k = 0; k < 20; ++k) points.push_back(far + any_vector());
    const Vec3<LazyInteger> u = cross(lazy(any_vector()), lazy(any_vector()));
    if (is_zero(u)) continue;
    const PointCloud cloud(points, 2010);
    computed -= LazyInteger::computed();
    const std::vector<std::uint32_t> found = extreme_points(LazyCloud(cloud), u);
    computed += LazyInteger::computed();
    ASSERT_EQ(found, extreme_points_naive(points, {mpz_class(u.x.exact()), u.y.exact(), u.z.exact()}));
  }
  EXPECT_LT(computed, 30U);
}

TEST(ExtremePoints, DifferencesBelowEveryImageDecide) {
  const PointCloud cloud({{0, 0, -power_of_two(5000)}, {0, 0, 1}, {0, 0, 2}, {0, 0, 2}});
  EXPECT_EQ(extreme_points(cloud, {0, 0, 1}), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(extreme_points(cloud, {0, power_of_two(9000), 1}), (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(points_beyond(cloud, {0, 0, 1}, 1), (std::vector<std::uint32_t>{2, 3}));
}

TEST(ExtremePoints, AgreeWithTheNaiveTwinOnLattices) {
  EXPECT_TRUE(holds({.seed = 20240229, .runs = 3000}, [] {
    const auto coordinate = rc::gen::map(rc::gen::element(-2, -1, 0, 1, 2), [](int x) { return mpz_class(x); });
    const auto vector = rc::gen::map(rc::gen::tuple(coordinate, coordinate, coordinate), [](const auto& t) {
      return Vector{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
    });
    const auto points = *rc::gen::container<std::vector<Vector>>(vector);
    const Vector u = *vector;
    const PointCloud cloud(points), deep(points, 1000);
    const auto expected = extreme_points_naive(points, u);
    RC_ASSERT(extreme_points(cloud, u) == expected);
    RC_ASSERT(extreme_points(deep, u) == expected);
    if (points.empty()) return;
    const auto k = static_cast<std::uint32_t>(points.size() / 2);
    RC_ASSERT(points_beyond(cloud, u, k) == points_beyond_naive(points, u, k));
    RC_ASSERT(points_beyond(deep, u, k) == points_beyond_naive(points, u, k));
  }));
}

TEST(ExtremePoints, AgreeWithTheNaiveTwinOnRandomSetsOfEverySize) {
  Random random(2);
  for (std::size_t n = 0; n < 600; n += 1 + n / 8) {
    for (const unsigned long bits : {3UL, 20UL, 53UL, 60UL, 2000UL}) {
      std::vector<Vector> points;
      for (std::size_t i = 0; i < n; ++i) points.push_back(random_vector(random, bits));
      const PointCloud cloud(points);
      for (const unsigned long u_bits : {2UL, 30UL, 100UL, 3000UL})
        expect_scans_agree(cloud, random_vector(random, u_bits), random);
    }
  }
}

// Values that differ by 2^-40 to 2^-60 of the greatest possible one: the filter's error bound is
// what separates right from wrong.
TEST(ExtremePoints, AgreeWithTheNaiveTwinOnNearTies) {
  Random random(3);
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const unsigned long u_bits = 10 + static_cast<unsigned long>(below(random, 40));
    const Vector u = random_vector(random, u_bits);
    const auto n = static_cast<std::size_t>(1 + below(random, 40));
    const unsigned long bits = 4 + static_cast<unsigned long>(below(random, 40));
    expect_scans_agree(PointCloud(nearly_coplanar(random, u, bits, n)), u, random);
    if (HasFatalFailure()) return;
  }
}

TEST(ExtremePoints, AgreeWithTheNaiveTwinWhenTheExponentsAreAtTheLimitOfExactImages) {
  Random random(4);
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const unsigned long u_bits = 1 + static_cast<unsigned long>(below(random, 50));
    const Vector u = random_vector(random, u_bits);
    std::vector<Vector> points;
    const unsigned long bits = 53 - u_bits;  // around the last pair of lengths that is computed without error
    for (int i = 0; i < 30; ++i) points.push_back(random_vector(random, bits));
    const Vector along = cross(u, random_vector(random, 3));
    for (int i = 0; i < 30; ++i) points.push_back(points[static_cast<std::size_t>(i)] + along);
    expect_scans_agree(PointCloud(points), u, random);
    if (HasFatalFailure()) return;
  }
}

TEST(ExtremePoints, DoNotDependOnTheRoundingMode) {
  Random random(5);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    for (int repeat = 0; repeat < 1000 && !HasFatalFailure(); ++repeat) {
      const Vector u = random_vector(random, 40);
      expect_scans_agree(PointCloud(nearly_coplanar(random, u, 13, 20)), u, random);
    }
    std::fesetround(FE_TONEAREST);
  }
}

// Every answer against integers, above all on points that are level or parallel in the view, or
// nearly so.

using testing::directions;
using testing::smallest_steps;
using testing::vectors;

/// The middle one of points o, p, q is turned about by lexicographic comparison of two
/// determinants: the axis after the greatest component of u, in cyclic order, then the one after
/// that.
int turn_naive(const Vector& u, const Vector& op, const Vector& oq) {
  const mpz_class sizes[3] = {abs(u.x), abs(u.y), abs(u.z)};
  int up = 0;
  for (int i = 1; i < 3; ++i)
    if (sizes[i] > sizes[up]) up = i;
  const auto at = [](const Vector& v, int i) -> mpz_class { return i % 3 == 0 ? v.x : i % 3 == 1 ? v.y : v.z; };
  for (const int axis : {up + 1, up + 2}) {
    const mpz_class t = at(op, axis) * dot(u, oq) - at(oq, axis) * dot(u, op);
    if (t != 0) return sgn(t);
  }
  return 0;
}

void check_view(const Vector& u, std::vector<Vector> points) {
  const PointCloud cloud(std::move(points));
  const PlanarView view(cloud, u);
  for (std::uint32_t p = 0; p < cloud.size(); ++p) {
    for (std::uint32_t q = 0; q < cloud.size(); ++q) {
      RC_ASSERT(to_int(view.rise(p, q)) == sgn(dot(u, Vector(cloud[q] - cloud[p]))));
      RC_ASSERT(to_int(view.turn(0, p, q)) == turn_naive(u, cloud[p] - cloud[0], cloud[q] - cloud[0]));
    }
  }
}

TEST(PlanarView, EveryAnswerIsExact) {
  for (const testing::Size size : testing::all_sizes) {
    SCOPED_TRACE(testing::name(size));
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [size] {
      check_view(*directions(size), {*vectors(size), *vectors(size), *vectors(size), *vectors(size)});
    }));
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [size] {
      const Vector u = *directions(size), o = *vectors(size), v = *vectors(size), level = cross(u, v);
      check_view(u, {o, o + level + *smallest_steps(), o + v, o + v + v + *smallest_steps(),
                     o + v + u + *smallest_steps(), o + mpz_class(3) * v + mpz_class(3) * u});
    }));
  }
}

TEST(PlanarView, ZeroTurnsMeanParallelOrLevel) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Vector u = *directions(testing::Size::small), p = *directions(testing::Size::small),
                 q = *directions(testing::Size::small);
    const PointCloud cloud({Vector{0, 0, 0}, p, q});
    const bool level = dot(u, p) == 0 && dot(u, q) == 0;
    RC_ASSERT((PlanarView(cloud, u).turn(0, 1, 2) == Sign::zero) == (level || is_zero(cross(p, q))));
  }));
}

std::vector<std::uint32_t> greatest_of(const std::vector<int>& values, std::vector<std::uint32_t> listed) {
  keep_greatest<mpz_class>(listed, [&](mpz_class& value, std::uint32_t i) { value = values[i]; });
  return listed;
}

TEST(Greatest, KeepsAllTiesInTheirOrder) {
  EXPECT_EQ(greatest_of({3, 7, 7, -1, 7}, {4, 0, 1, 3, 2}), (std::vector<std::uint32_t>{4, 1, 2}));
}

TEST(Greatest, LooksAtListedOnesAlone) { EXPECT_EQ(greatest_of({3, 7, -5}, {2, 0}), std::vector<std::uint32_t>{0}); }

TEST(Greatest, IsTheFirstOneIfAllAreNegative) {
  EXPECT_EQ(greatest_of({-3, -7}, {0, 1}), std::vector<std::uint32_t>{0});
}

TEST(Greatest, OfNothingIsNothing) { EXPECT_TRUE(greatest_of({1}, {}).empty()); }

// Its promise, that "true" is never said where the hull has fewer vertices, and that it is said
// where it should be, or it saves nothing.

std::size_t distinct(std::vector<Vector> points) {
  std::ranges::sort(points, lexicographically_less);
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

bool all_extreme_naive(const std::vector<Point>& points) {
  const polytope::PlacedPair pair = polytope::place(points, std::span(points).first(1));
  return polytope::convex_hull(pair.a.points()).vertices.size() == distinct(pair.a.points());
}

/// The corners of [0, 2] x [0, 1] x [0, 1], times `scale`, moved.
std::vector<Point> box(const mpq_class& scale = 1, const mpq_class& moved = 0) {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({scale * (2 * (i & 1)) + moved, scale * (i >> 1 & 1) + moved, scale * (i >> 2) + moved});
  return points;
}

TEST(AllExtreme, NeverSaysMoreThanTheHull) {
  std::size_t seen = 0, extreme = 0;
  for (const families::Family& family : families::families()) {
    for (const unsigned size : {6U, 20U, 90U}) {
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const Case pair = family.make(seed, size);
        for (const Body* body : {&pair.a, &pair.b}) {
          const bool said = all_seen_extreme(body->points), truth = all_extreme_naive(body->points);
          EXPECT_TRUE(truth || !said) << pair.id;
          seen += said;
          extreme += truth;
        }
      }
    }
  }
  EXPECT_GT(4 * seen, 3 * extreme) << "too shy to be of use: " << seen << " of " << extreme;
}

TEST(AllExtreme, SeesWhatIsPlain) {
  EXPECT_TRUE(all_seen_extreme(box()));
  EXPECT_TRUE(all_seen_extreme(box(mpq_class("1/1000000000"), 1))) << "far from the origin";
  const mpq_class huge(mpz_class(1) << 800), tiny = 1 / huge;
  EXPECT_TRUE(all_seen_extreme(box(huge)));
  std::vector<Point> twice = box(), uneven = box();
  for (const Point& p : box()) twice.push_back(p);
  for (Point& p : uneven) p = {p.x * huge, p.y, p.z * tiny};
  EXPECT_TRUE(all_seen_extreme(twice)) << "equal points count as one";
  EXPECT_TRUE(all_seen_extreme(uneven));
  EXPECT_TRUE(all_seen_extreme(std::vector<Point>{{0, 0, 0}, {3, 3, 3}, {1, 0, 2}, {4, 3, 5}})) << "a parallelogram";
  std::vector<Point> sphere;
  for (int i = 1; i < 3000; ++i) {
    const double z = 2.0 * i / 3000 - 1, around = 2.4 * i, r = std::sqrt(1 - z * z);
    sphere.push_back({mpq_class(r * std::cos(around)), mpq_class(r * std::sin(around)), mpq_class(z)});
  }
  EXPECT_TRUE(all_seen_extreme(sphere));
  sphere.push_back({0, 0, mpq_class("99/100")});
  EXPECT_FALSE(all_seen_extreme(sphere)) << "just below the cap";
}

/// One more point on an edge, in a facet, or off them by less than doubles can tell: it must not be
/// called extreme.
TEST(AllExtreme, IsNotDeceivedByAHair) {
  for (const unsigned bits : {40U, 52U, 60U, 200U}) {
    const mpq_class hair(1, mpz_class(1) << bits), half(1, 2);
    const std::vector<Point> hidden{{1, 0, 0},          {1, hair, hair},  {1, half, hair},
                                    {hair, hair, hair}, {2, 1 - hair, 1}, {2, half, 1}};
    for (const Point& point : hidden) {
      for (const mpq_class& moved : {mpq_class(0), mpq_class(1000), mpq_class(-1, 3)}) {
        std::vector<Point> points = box(1, moved);
        points.insert(points.begin() + 3, Point{point.x + moved, point.y + moved, point.z + moved});
        ASSERT_FALSE(all_extreme_naive(points));
        EXPECT_FALSE(all_seen_extreme(points)) << bits << " bits, moved by " << moved;
      }
    }
  }
}

TEST(AllExtreme, StandsOutsideOfDoubles) {
  EXPECT_FALSE(all_seen_extreme(std::vector<Point>{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}))
      << "the middle of three on a line";
  const mpq_class beyond(mpz_class(1) << 5000);  // no double
  EXPECT_FALSE(all_seen_extreme(std::vector<Point>{{0, 0, 0}, {beyond, 0, 0}, {2 * beyond, 0, 0}}));
  EXPECT_FALSE(all_seen_extreme(std::vector<Point>{{0, 0, 0}, {1 / beyond, 0, 0}, {2 / beyond, 0, 0}}));
}

}  // namespace
}  // namespace fathom::kernels
