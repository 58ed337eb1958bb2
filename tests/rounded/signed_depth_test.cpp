// SPDX-License-Identifier: GPL-3.0-or-later
// Signed depths of rounded polytopes and half-spaces: against closed forms, against polytopes
// inside and outside, and by their laws.
#include "fathom/signed_depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/rounded/coordinates.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/random.hpp"

namespace fathom::rounded {
namespace {

Point random_point(families::Random& random, long size) {
  return {mpq_class(random.between(-size, size)), mpq_class(random.between(-size, size)),
          mpq_class(random.between(-size, size))};
}

bool same_value(const Surd& x, const Surd& y) { return compare(x, y) == 0; }

/// What translations and witness points of any exact answer obey.
void expect_laws(const SignedDepth& depth, const std::string& id) {
  ASSERT_TRUE(depth.exact()) << id;
  const std::vector<AlongNormal> ways = depth.translations();
  ASSERT_FALSE(ways.empty()) << id;
  for (const AlongNormal& way : ways) {
    const Point n = rational(way.normal);
    const mpq_class square = dot(n, n);
    // alpha |n| + beta is the value, as alpha |n| = h(n)/|n|.
    EXPECT_TRUE(same_value({way.beta, way.alpha * abs(way.alpha) * square}, *depth.exact()))
        << id << ": a translation of another length";
  }
  EXPECT_EQ(ways.front().normal, depth.direction()) << id;
  const RoundedWitness witness = depth.witness().value();
  const AlongNormal& first = ways.front();
  EXPECT_EQ(witness.b.core - witness.a.core, first.alpha * rational(first.normal))
      << id << ": b - a is not the translation";
  EXPECT_EQ(witness.b.distance - witness.a.distance, first.beta) << id;
  EXPECT_EQ(witness.a.distance, -depth.radius_a) << id;
  EXPECT_LE(depth.low_binary64(), depth.high_binary64()) << id;
  EXPECT_LE(compare(*depth.exact(), exact_value(depth.high_binary64())), 0) << id;
  EXPECT_GE(compare(*depth.exact(), exact_value(depth.low_binary64())), 0) << id;
}

TEST(NearestUnit, RoundsTheCoordinatesOfTheUnitVector) {
  families::Random random(7);
  for (int run = 0; run < 500; ++run) {
    const auto coordinate = [&] { return mpz_class(mpz_class(random.between(-9, 9)) << random.between(0, 600)); };
    const Vector n = random.between(0, 1) == 0
                         ? Vector{random.between(-9, 9), random.between(-9, 9), random.between(1, 9)}
                         : Vector{coordinate(), coordinate(), mpz_class(1) << random.between(0, 1200)};
    EXPECT_EQ(nearest_unit(n), nearest_binary64(unit(n)));
  }
}

TEST(SignedDepth, IsThatOfTheCoresAndBothRadii) {
  int statuses[3] = {};
  for (const Case& input : testing::cases_of_all_families(2, 10)) {
    const Depth cores = penetration_depth(input.a.points, input.b.points);
    const mpq_class r(1, 3), s(2, 7);
    const SignedDepth depth = signed_depth(with_margin(hull(input.a.points), r), with_margin(hull(input.b.points), s));
    expect_laws(depth, input.id);
    EXPECT_TRUE(same_value(*depth.exact(), {r + s, signed_square(cores)})) << input.id;
    EXPECT_EQ(depth.translations().size(), std::max<std::size_t>(1, cores.optima().size())) << input.id;
    EXPECT_EQ(depth.cone.has_value(), cores.status() == Status::touching) << input.id;
    ++statuses[static_cast<int>(cores.status())];
    const SignedDepth bare = signed_depth(hull(input.a.points), hull(input.b.points));
    EXPECT_EQ(bare.status(), cores.status()) << input.id;
    expect_laws(bare, input.id);
  }
  for (const int count : statuses) EXPECT_GT(count, 3);
}

// ---- capsules ----

/// The squared distance of p from the segment from q to q + d.
mpq_class point_segment(const Point& p, const Point& q, const Point& d) {
  const mpq_class square = dot(d, d);
  mpq_class t = square == 0 ? mpq_class(0) : mpq_class(dot(p - q, d) / square);
  t = std::clamp<mpq_class>(t, 0, 1);
  const Point gap = p - (q + t * d);
  return dot(gap, gap);
}

/// Of segments from p to p + d and from q to q + e: an end of one against the other, or the feet of
/// the common perpendicular.
mpq_class segment_segment(const Point& p, const Point& d, const Point& q, const Point& e) {
  mpq_class least = std::min(
      {point_segment(p, q, e), point_segment(p + d, q, e), point_segment(q, p, d), point_segment(q + e, p, d)});
  const mpq_class dd = dot(d, d), ee = dot(e, e), de = dot(d, e), determinant = dd * ee - de * de;
  if (determinant == 0) return least;
  const Point w = p - q;
  const mpq_class s = (de * dot(e, w) - ee * dot(d, w)) / determinant,
                  t = (dd * dot(e, w) - de * dot(d, w)) / determinant;
  if (s < 0 || s > 1 || t < 0 || t > 1) return least;
  const Point gap = p + s * d - (q + t * e);
  return std::min(least, dot(gap, gap));
}

TEST(SignedDepth, OfCapsulesIsTheClosedForm) {
  families::Random random(4);
  int crossing = 0;
  for (int i = 0; i < 1000; ++i) {
    const long size = i % 3 == 0 ? 1 : 20;
    const Point p = random_point(random, size), d = random_point(random, size), e = random_point(random, size),
                other = random_point(random, size);
    const Point q = i % 5 == 0 ? p + mpq_class(1, 3) * d : other;  // on the first segment, or anywhere
    const mpq_class r = families::ratio(random.between(0, 20), 7), s = families::ratio(random.between(0, 20), 5);
    const Shape a = with_margin(hull(std::vector{p, p + d}), r), b = with_margin(hull(std::vector{q, q + e}), s);
    const mpq_class square = segment_segment(p, d, q, e);
    const SignedDepth depth = signed_depth(a, b);
    EXPECT_TRUE(same_value(*depth.exact(), {r + s, -square})) << i;
    const int order = cmp(mpq_class((r + s) * (r + s)), square);
    EXPECT_EQ(depth.status(), order > 0 ? Status::penetrating : order < 0 ? Status::disjoint : Status::touching) << i;
    expect_laws(depth, std::to_string(i));
    crossing += square == 0 ? 1 : 0;
  }
  EXPECT_GE(crossing, 200);
}

TEST(SignedDepth, ChangesItsSignWhereTheRadiiAddUpToTheDistance) {
  const Shape a = hull(std::vector<Point>{{0, 0, 0}, {0, 0, 9}}), b = hull(std::vector<Point>{{3, 4, 2}, {3, 4, -5}});
  const mpq_class hair = families::times_power_of_two(1, -400);
  const auto status = [&](const mpq_class& r, const mpq_class& s) {
    return signed_depth(with_margin(a, r), with_margin(b, s)).status();
  };
  EXPECT_EQ(status(2, 3), Status::touching);
  EXPECT_EQ(status(2, 3 - hair), Status::disjoint);
  EXPECT_EQ(status(2 + hair, 3), Status::penetrating);
  // At the distance sqrt(2), between convergents of it.
  mpq_class low = 1, high = mpq_class(3, 2);
  const Shape c = hull(std::vector<Point>{{1, 1, 0}});
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(signed_depth(sphere(low), c).status(), Status::disjoint);
    EXPECT_EQ(signed_depth(sphere(high), c).status(), Status::penetrating);
    high = (high + 2 / high) / 2;  // Newton's step from above
    low = 2 / high;
  }
}

// ---- spheres ----

TEST(SignedDepth, OfSpheresIsExactHoweverTheyAreGiven) {
  const Pose pose = rigid_pose({1, 2, mpq_class(1, 3), 4}, {3, 4, 12});
  const SignedDepth depth = signed_depth(moved(ellipsoid({2, 2, 2}), pose), sphere(5));
  EXPECT_TRUE(same_value(*depth.exact(), {7, -169}));
  EXPECT_EQ(depth.direction(), (Vector{3, 4, 12}));
  expect_laws(depth, "spheres");
  const SignedDepth concentric = signed_depth(sphere(2), sphere(5));
  EXPECT_EQ(concentric.cone->lineality, Lineality::all);
  EXPECT_TRUE(same_value(*concentric.exact(), {7, 0}));
  EXPECT_EQ(concentric.translations(), (std::vector<AlongNormal>{{{-1, 0, 0}, 0, 7}}));
  EXPECT_EQ(concentric.low_binary64(), 7);
  EXPECT_EQ(concentric.high_binary64(), 7);
}

TEST(SignedDepth, OfCoordinatesBeyondBinary64) {
  for (const long exponent : {-1100L, 1030L}) {
    const mpq_class x = families::times_power_of_two(3, exponent);
    const Shape point = hull(std::vector<Point>{{x, 0, 0}, {2 * x, 0, 0}});
    EXPECT_EQ(signed_depth(sphere(x), point).status(), Status::touching) << exponent;
    EXPECT_EQ(signed_depth(point, sphere(x + families::times_power_of_two(x, -60))).status(), Status::penetrating)
        << exponent;
  }
}

// ---- half-spaces ----

TEST(SignedDepth, OfAHalfSpaceIsThatOfALargeBox) {
  families::Random random(5);
  // {z <= offset} as a box: its other faces are far away.
  for (int i = 0; i < 60; ++i) {
    std::vector<Point> body;
    for (int k = 0; k < 6; ++k) body.push_back(random_point(random, 9));
    const mpq_class offset = families::ratio(random.between(-30, 30), 3), r(1, 2), s(1, 5);
    const Pose pose = rigid_pose({1, mpq_class(random.between(-3, 3)), mpq_class(random.between(-3, 3)), 2}, {1, 2, 3});
    const Shape half = with_margin(moved(halfspace({0, 0, 3}, 3 * offset), pose), s),
                convex = with_margin(moved(hull(body), pose), r);
    const Shape large = with_margin(moved(box({1000, 1000, 1000}), rigid_pose({1, 0, 0, 0}, {0, 0, offset - 1000})), s);
    const Surd expected = *signed_depth(with_margin(hull(body), r), large).exact();
    const SignedDepth as_b = signed_depth(convex, half), as_a = signed_depth(half, convex);
    for (const SignedDepth* depth : {&as_b, &as_a}) {
      EXPECT_TRUE(same_value(*depth->exact(), expected)) << i;
      expect_laws(*depth, std::to_string(i));
    }
    const std::vector<Atom>& corners = std::get<std::vector<Term>>(convex.core)[0].atoms;
    const HalfSpace& plane = std::get<HalfSpace>(half.core);
    for (const auto& [corner, foot] : {std::pair(as_b.witness()->a.core, as_b.witness()->b.core),
                                       {as_a.witness()->b.core, as_a.witness()->a.core}}) {
      EXPECT_EQ(dot(plane.normal, foot), plane.offset) << i;
      EXPECT_NE(std::find(corners.begin(), corners.end(), Atom{corner, {}}), corners.end()) << i;
    }
    EXPECT_EQ(as_a.direction(), (Vector{-as_b.direction().x, -as_b.direction().y, -as_b.direction().z}));
  }
}

TEST(SignedDepth, OfAHalfSpaceWithASumAndAtContact) {
  const Shape boxes = minkowski_sum(box({1, 1, 1}), box({2, 2, 2}));
  const SignedDepth resting = signed_depth(boxes, halfspace({0, 0, 2}, -6));
  EXPECT_EQ(resting.status(), Status::touching);
  EXPECT_EQ(resting.cone, (OptimalCone{Lineality::none, {}, {{0, 0, 1}}}));
  EXPECT_EQ(signed_depth(halfspace({0, 0, 2}, -6), boxes).cone, (OptimalCone{Lineality::none, {}, {{0, 0, -1}}}));
  EXPECT_TRUE(same_value(*signed_depth(with_margin(boxes, mpq_class(1, 10)), halfspace({0, 0, 2}, -6)).exact(),
                         {mpq_class(1, 10), 0}));
  EXPECT_TRUE(same_value(*signed_depth(sphere(1), halfspace({1, 1, 1}, 0)).exact(), {1, 0}));
  EXPECT_TRUE(same_value(*signed_depth(sphere(1), halfspace({1, 1, 1}, -1)).exact(), {1, mpq_class(-1, 3)}));
}

// ---- sums, and balls between polytopes ----

TEST(SignedDepth, OfSumsOfBoxes) {
  const Pose aside{{{1, 0, 0, 5}, {0, 1, 0, 1}, {0, 0, 1, 0}}};
  const Shape sum = minkowski_sum(minkowski_sum(box({1, 1, 1}), box({1, 2, 3})), sphere(1));
  EXPECT_TRUE(same_value(*signed_depth(sum, moved(box({4, 4, 4}), aside)).exact(),
                         *signed_depth(with_margin(box({2, 3, 4}), 1), moved(box({4, 4, 4}), aside)).exact()));
}

/// Points of the unit sphere.
std::vector<Point> ball_points() {
  std::vector<Point> points;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      const mpq_class u(i, 4), v(j, 4), s = 1 + u * u + v * v;
      for (const int sign : {-1, 1}) points.push_back({2 * u / s, 2 * v / s, sign * (2 / s - 1)});
    }
  }
  for (Point& p : points)
    for (mpq_class* x : {&p.x, &p.y, &p.z}) x->canonicalize();
  return points;
}

std::vector<Point> scaled(std::vector<Point> points, const mpq_class& factor) {
  for (Point& p : points) p = factor * p;
  return points;
}

TEST(SignedDepth, LiesBetweenThoseOfPolytopesInsideAndOutside) {
  const std::vector<Point> inner = ball_points();
  const std::vector<Point> origin{{0, 0, 0}};
  const mpq_class inradius = exact_value(root_binary64(penetration_depth(inner, origin).squared(), Rounding::rd));
  ASSERT_GT(inradius, mpq_class(9, 10));
  const std::vector<Point> outer = scaled(inner, 1 / inradius);
  int open = 0;
  for (const Case& input : testing::cases_of_all_families(1, 8)) {
    const Shape a = hull(input.a.points), b = hull(input.b.points);
    const mpq_class r = 2;
    const Surd exact = *signed_depth(a, with_margin(b, r)).exact();
    const Surd below = *signed_depth(a, minkowski_sum(b, hull(scaled(inner, r)))).exact();
    const Surd above = *signed_depth(a, minkowski_sum(b, hull(scaled(outer, r)))).exact();
    EXPECT_LE(compare(below, exact), 0) << input.id;
    EXPECT_GE(compare(above, exact), 0) << input.id;
    open += compare(above, below) > 0 ? 1 : 0;
  }
  EXPECT_GT(open, 10);
}

// ---- options and errors ----

TEST(SignedDepth, ListsAsManyOptimaAsAsked) {
  SignedDepthOptions options;
  options.cores.optima = 2;
  options.cores.validate = true;
  const Shape cube = with_margin(box({1, 1, 1}), 1);
  EXPECT_EQ(signed_depth(cube, cube).translations().size(), 6U);
  EXPECT_EQ(signed_depth(cube, cube, options).translations().size(), 2U);
  EXPECT_EQ(signed_depth(cube, moved(cube, {{{1, 0, 0, 2}, {0, 1, 0, 0}, {0, 0, 1, 0}}}), options).direction(),
            (Vector{-1, 0, 0}));
}

TEST(SignedDepth, RefusesWhatIsNoBody) {
  const Shape plane = halfspace({1, 0, 0}, 0), ball = sphere(1);
  EXPECT_THROW(signed_depth(plane, plane), std::invalid_argument);
  EXPECT_THROW(signed_depth(ball, Shape{}), std::invalid_argument);
  EXPECT_THROW(signed_depth(Shape{std::vector<Term>{{{{}}}}, -1}, ball), std::invalid_argument);
  EXPECT_THROW(signed_depth(Shape{HalfSpace{}, 0}, ball), std::invalid_argument);
}

TEST(SignedDepth, OfBoundsIsDecidedWhereTheyHaveOneSign) {
  const auto status = [](const mpq_class& low, const mpq_class& high) {
    SignedDepth depth;
    depth.value = Bounds{low, high};
    depth.core = Bracket{};
    EXPECT_TRUE(depth.translations().empty());
    EXPECT_FALSE(depth.witness());
    return depth.status();
  };
  EXPECT_EQ(status(mpq_class(1, 10), 1), Status::penetrating);
  EXPECT_EQ(status(-2, mpq_class(-1, 3)), Status::disjoint);
  EXPECT_EQ(status(-2, 1), std::nullopt);
  EXPECT_EQ(status(0, 1), std::nullopt);
  SignedDepth third;
  third.value = Bounds{mpq_class(-1, 3), mpq_class(1, 3)};
  EXPECT_EQ(third.low_binary64(), round_binary64(mpq_class(-1, 3), Rounding::rd));
  EXPECT_EQ(third.high_binary64(), round_binary64(mpq_class(1, 3), Rounding::ru));
}

}  // namespace
}  // namespace fathom::rounded
