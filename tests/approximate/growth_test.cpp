// SPDX-License-Identifier: GPL-3.0-or-later
// The growth distance against the hull of all differences, its proof by the definitions, and what
// it promises: bodies that grow by it touch.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fathom/approximate.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"

namespace fathom {
namespace {

using PointList = std::vector<Point>;

const Point nowhere{0, 0, 0};

PointList cube(const mpq_class& x, const mpq_class& half = 1) {
  PointList corners;
  const mpq_class sides[] = {-half, half};
  for (int i = 0; i < 8; ++i) corners.push_back({x + sides[i & 1], sides[i >> 1 & 1], sides[i >> 2]});
  return corners;
}

/// By all differences of points from their centers; nullopt if O is not inside.
std::optional<mpq_class> growth_naive(PointList a, PointList b, const Point& center_a, const Point& center_b) {
  a.push_back(center_a);
  b.push_back(center_b);
  const polytope::PlacedPair placed = polytope::place(a, b);
  const std::span<const Vector> of_a = placed.a.points(), of_b = placed.b.points();
  std::vector<Vector> all;
  for (const Vector& p : of_a.first(a.size() - 1))
    for (const Vector& q : of_b.first(b.size() - 1)) all.push_back((q - of_b.back()) - (p - of_a.back()));
  const polytope::Polytope p = polytope::convex_hull(all);
  if (!testing::holds_origin(p)) return std::nullopt;
  const Vector way = of_a.back() - of_b.back();
  return is_zero(way) ? mpq_class(0) : mpq_class(1 / testing::factor_naive(p, way));
}

PointList grown(const PointList& points, const Point& center, const mpq_class& g) {
  PointList result;
  for (const Point& p : points) result.push_back(center + g * (p - center));
  return result;
}

Status status_of_grown(const PointList& a, const PointList& b, const GrowthDistance& found, const mpq_class& g) {
  return penetration_depth(grown(a, found.center_a, g), grown(b, found.center_b, g)).status();
}

/// A rotation by the angle of a 3-4-5 triangle, a reflection, a scaling and a translation.
Point carried(const Point& p) {
  const mpq_class s(3, 5), t(4, 5), k(7, 2);
  return {k * (s * p.x - t * p.z) + 1, k * -p.y - 9, k * (t * p.x + s * p.z) + mpq_class(1, 3)};
}

PointList carried(const PointList& points) {
  PointList result;
  for (const Point& p : points) result.push_back(carried(p));
  return result;
}

Point mean(const PointList& points) {
  Point sum = nowhere;
  for (const Point& p : points) sum = sum + p;
  return mpq_class(1, points.size()) * sum;
}

/// All laws about one pair with these centers, or the means of the corners. Returns whether there
/// is a growth.
bool expect_growth(const PointList& a, const PointList& b, const std::optional<Point>& center_a = {},
                   const std::optional<Point>& center_b = {}) {
  std::optional<GrowthDistance> found;
  try {
    found = growth_distance(a, b, center_a, center_b);
  } catch (const NoGrowth&) {  // for means, only because P is flat
    EXPECT_EQ(growth_naive(a, b, center_a.value_or(mean(a)), center_b.value_or(mean(b))), std::nullopt);
    return false;
  }
  const mpq_class& g = found->growth;
  EXPECT_EQ(growth_naive(a, b, found->center_a, found->center_b), g);
  EXPECT_EQ(testing::text(validate(*found, a, b)), "");
  EXPECT_EQ(found->status(), penetration_depth(a, b).status());
  const GrowthDistance swapped = growth_distance(b, a, center_b, center_a);
  EXPECT_EQ(swapped.growth, g);
  EXPECT_EQ(testing::text(validate(swapped, b, a)), "");
  const GrowthDistance moved =
      growth_distance(carried(a), carried(b), carried(found->center_a), carried(found->center_b));
  EXPECT_EQ(moved.growth, g);
  if (g == 0) return true;
  EXPECT_EQ(status_of_grown(a, b, *found, g), Status::touching);
  EXPECT_EQ(status_of_grown(a, b, *found, g * mpq_class(999, 1000)), Status::disjoint);
  EXPECT_EQ(status_of_grown(a, b, *found, g * mpq_class(1001, 1000)), Status::penetrating);
  return true;
}

TEST(GrowthDistance, AgreesWithTheHullOfDifferencesOnAllFamilies) {
  int answered = 0, refused = 0;
  for (const Case& input : testing::cases_of_all_families(1, 8)) {
    SCOPED_TRACE(input.id);
    const PointList a = input.a.points, b = input.b.points;
    ++(expect_growth(a, b) ? answered : refused);
    ++(expect_growth(a, b, a.front()) ? answered : refused);  // on the boundary of A, and inside P
    ++(expect_growth(a, b, mpq_class(2) * a.back() - a.front(), b.back()) ? answered : refused);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(answered, 100);
  EXPECT_GT(refused, 20);
}

TEST(GrowthDistance, AgreesWithTheHullOfDifferencesOnSmallLattices) {
  int answered = 0, refused = 0;
  EXPECT_TRUE(holds({.seed = 17, .runs = 300}, [&] {
    const auto point = [](int size) {
      return Point{*rc::gen::inRange(-size, size + 1), *rc::gen::inRange(-size, size + 1),
                   *rc::gen::inRange(-size, size + 1)};
    };
    const auto body = [&](int x) {
      PointList points;
      for (int count = *rc::gen::inRange(1, 8); count > 0; --count) points.push_back(point(3) + Point{x, 0, 0});
      return points;
    };
    const PointList a = body(0), b = body(*rc::gen::inRange(0, 8));
    ++(expect_growth(a, b) ? answered : refused);
    ++(expect_growth(a, b, point(2), mpq_class(1, 2) * (b.front() + b.back())) ? answered : refused);
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
  EXPECT_GT(answered, 150);
  EXPECT_GT(refused, 50);
}

TEST(GrowthDistance, CentersAreMeansOfTheCornersWhateverElseIsGiven) {
  PointList a = cube(0), b = cube(3);
  const GrowthDistance found = growth_distance(a, b);
  EXPECT_EQ(found.center_a, nowhere);
  EXPECT_EQ(found.center_b, (Point{3, 0, 0}));
  EXPECT_EQ(found.growth, mpq_class(3, 2));
  EXPECT_EQ(found.touch->normal, (Vector{-1, 0, 0}));
  EXPECT_EQ(found.touch->contact.kind, ContactKind::facet_facet);
  a.insert(a.end(), {{1, 0, mpq_class(1, 2)}, {1, 1, 1}, {1, 1, 1}});  // in a facet, and a corner again
  EXPECT_EQ(growth_distance(a, b).growth, found.growth);
  EXPECT_EQ(growth_distance(a, b, nowhere, Point{mpq_class(5, 2), 0, 0}).growth, mpq_class(5, 3));
}

TEST(GrowthDistance, CoincidingCentersNeedNone) {
  const GrowthDistance found = growth_distance(cube(0), cube(0, 2));
  EXPECT_EQ(found.growth, 0);
  EXPECT_EQ(found.status(), Status::penetrating);
  EXPECT_FALSE(found.touch);
  EXPECT_EQ(testing::text(validate(found, cube(0), cube(0, 2))), "");
}

std::string refusal(const PointList& a, const PointList& b, const std::optional<Point>& center_a = {}) {
  try {
    growth_distance(a, b, center_a);
  } catch (const NoGrowth& error) {
    return error.what();
  }
  return "";
}

TEST(GrowthDistance, RefusesCentersWithoutRoom) {
  const std::string expected = "expected centers with center_b - center_a inside B - A, found ";
  EXPECT_EQ(refusal(cube(0), cube(3), Point{-2, 0, 0}), expected + "it on the boundary");
  EXPECT_EQ(refusal(cube(0), cube(3), Point{-3, 0, 0}), expected + "it outside");
  const PointList square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(refusal(square, square), expected + "that B - A is flat, without an inside");
  EXPECT_EQ(refusal(square, square, Point{0, 0, 5}), expected + "that B - A is flat, without an inside");
  EXPECT_EQ(refusal(square, {{0, 0, 5}, {0, 0, 6}}), "");
  EXPECT_THROW(growth_distance({}, square), std::invalid_argument);
  EXPECT_THROW(growth_distance(square, {}), std::invalid_argument);
}

TEST(GrowthDistance, TheProofHasTeeth) {
  const PointList a = cube(0), b = cube(mpq_class(5, 2), mpq_class(1, 2));
  const GrowthDistance good = growth_distance(a, b, std::nullopt, Point{mpq_class(9, 4), mpq_class(1, 8), 0});
  ASSERT_EQ(testing::text(validate(good, a, b)), "");
  const auto refused = [&](const auto& change) {
    GrowthDistance bad = good;
    change(bad);
    return !validate(bad, a, b).ok();
  };
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.growth *= mpq_class(1001, 1000); }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.growth = 0; }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.center_a.y += 1; }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.touch.reset(); }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.touch->normal = -g.touch->normal; }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.touch->normal = {-8, 1, 0}; }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.touch->normal = {0, 0, 0}; }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.touch->weights_a.pop_back(); }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { g.touch->weights_b.front().index = 8; }));
  EXPECT_TRUE(refused([](GrowthDistance& g) {
    g.touch->weights_a.push_back({0, -1});
    g.touch->weights_a.push_back({0, 1});
  }));
  EXPECT_TRUE(refused([](GrowthDistance& g) { std::swap(g.touch->witness.a, g.touch->witness.b); }));
}

}  // namespace
}  // namespace fathom
