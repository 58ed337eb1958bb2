// SPDX-License-Identifier: GPL-3.0-or-later
// Local depths against their twin, and the planes and lines that prove them.
#include "reference/patch/local_depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "fathom/depth.hpp"
#include "kernels/vector.hpp"
#include "reference/patch/patch.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom::patch {
namespace {

using families::Random;

/// A box along the axes, by its corners.
std::vector<Point> brick(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (const mpq_class& x : {low.x, high.x})
    for (const mpq_class& y : {low.y, high.y})
      for (const mpq_class& z : {low.z, high.z}) corners.push_back({x, y, z});
  return corners;
}

TEST(LocalDepth, OfTwoBoxes) {
  const std::vector<Point> a = brick({0, 0, 0}, {2, 2, 2}), b = brick({1, 0, 0}, {3, 1, 4});
  const LinesAlong lines(Vector{-2, 0, 0}, a, b);
  const Point inside{0, mpq_class(1, 2), 1}, above{7, mpq_class(1, 2), mpq_class(9, 4)};
  EXPECT_EQ(lines.at(inside)->factor, mpq_class(1, 2));  // A begins at x = 2, B ends at x = 1
  EXPECT_EQ(lines.at(inside)->a, (Point{2, mpq_class(1, 2), 1}));
  EXPECT_EQ(lines.at(inside)->b, (Point{1, mpq_class(1, 2), 1}));
  EXPECT_FALSE(lines.at(above));
  EXPECT_FALSE(lines.greatest(above, mpq_class(1, 5)).overlap);
  EXPECT_EQ(lines.greatest(above, mpq_class(1, 4)).overlap->factor, mpq_class(1, 2)) << "the border counts";
  EXPECT_EQ(lines.corners(above, mpq_class(1, 2)).size(), 4U);
  EXPECT_EQ(lines.corners(above, mpq_class(1, 4)).size(), 2U);
  const LinesAlong slanted(Vector{-1, -1, 0}, a, b);
  EXPECT_EQ(slanted.at({1, 1, 1})->factor, 1) << "from (2,2,1) to (1,1,1)";
}

std::vector<Point> random_body(Random& random, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({random.between(-4, 4), random.between(-4, 4), random.between(-4, 4)});
  return points;
}

/// Greatest and least factor, and that the planes and the lines prove them.
void expect_as_twin(const Vector& v, const std::vector<Point>& a, const std::vector<Point>& b, const Point& x,
                    const mpq_class& within) {
  const LinesAlong lines(v, a, b);
  const GreatestOverlap greatest = lines.greatest(x, within);
  const auto twin = overlaps_naive(v, a, b, x, within);
  ASSERT_EQ(greatest.overlap.has_value(), twin.has_value());
  const auto& [u, w] = greatest.planes;
  EXPECT_EQ(dot(v, u), dot(v, w));
  const mpq_class limit = bound(greatest.planes, a, b, x, within);
  const std::vector<LineOverlap> corners = lines.corners(x, within);
  if (!twin) {
    EXPECT_EQ(dot(v, u), 0);
    EXPECT_LT(limit, 0) << "law: the planes part all lines near x from the bodies";
    EXPECT_TRUE(corners.empty());
    return;
  }
  EXPECT_EQ(dot(v, u), 1);
  EXPECT_EQ(limit, (*twin)[1]) << "law: the planes prove the greatest";
  EXPECT_EQ(greatest.overlap->factor, (*twin)[1]);
  ASSERT_FALSE(corners.empty());
  const auto least = std::ranges::min_element(corners, {}, &LineOverlap::factor);
  EXPECT_EQ(least->factor, (*twin)[0]) << "law: the least is at a corner";
  for (const LineOverlap& corner : corners) {
    EXPECT_EQ(corner.b - corner.a, corner.factor * v);
    const auto there = overlaps_naive(v, a, b, corner.a, 0);
    ASSERT_TRUE(there);
    EXPECT_EQ((*there)[1], corner.factor);
    const auto near = overlaps_naive(v, std::vector{corner.a}, std::vector{corner.a}, x, within);
    EXPECT_TRUE(near) << "law: corners are lines near x";
  }
}

TEST(LocalDepth, IsThatOfTheTwin) {
  Random random(11);
  int empty = 0, flat = 0;
  for (int k = 0; k < 30; ++k) {
    const std::vector<Point> a = random_body(random, static_cast<std::size_t>(random.between(1, 5))),
                             b = random_body(random, static_cast<std::size_t>(random.between(2, 5)));
    Vector v{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
    if (is_zero(v)) v = {0, 0, 1};
    const Point x = mpq_class(1, 2) * (families::any_of(a, random) + families::any_of(b, random));
    const mpq_class within = families::any_of(std::vector<mpq_class>{0, mpq_class(1, 2), 2, 3}, random);
    empty += overlaps_naive(v, a, b, x, within) ? 0 : 1;
    flat += a.size() < 4 || b.size() < 4 ? 1 : 0;
    expect_as_twin(v, a, b, x, within);
  }
  EXPECT_GT(empty, 2);
  EXPECT_LT(empty, 20);
  EXPECT_GT(flat, 5);
}

/// Corners are lines of the twin's, in order around all of them.
void expect_set_of_twin(const Vector& v, const std::vector<Point>& a, const std::vector<Point>& b,
                        const mpq_class& least) {
  const std::vector<LineOverlap> corners = LinesAlong(v, a, b).at_least(least);
  const std::vector<Point> twin = at_least_naive(v, a, b, least);
  ASSERT_EQ(corners.empty(), twin.empty());
  const auto same_line = [&](const Point& p, const Point& q) { return cross(rational(v), p - q) == Point{}; };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point &p = corners[k].a, &q = corners[(k + 1) % corners.size()].a;
    EXPECT_GE(corners[k].factor, least);
    EXPECT_TRUE(std::ranges::any_of(twin, [&](const Point& x) { return same_line(x, p); }));
    const auto side = [&](const Point& x) { return mpq_class(dot(v, cross(q - p, x - p))); };
    const auto [low, high] = std::ranges::minmax(twin, {}, side);
    EXPECT_TRUE(side(low) >= 0 || side(high) <= 0) << "law: all lines are to one side of an edge";
    if (corners.size() == 1) EXPECT_TRUE(std::ranges::all_of(twin, [&](const Point& x) { return same_line(x, p); }));
  }
}

TEST(LocalDepth, ThatIsNotTooSmallIsThatOfTheTwin) {
  Random random(12);
  std::size_t polygons = 0, empty = 0;
  for (int k = 0; k < 60; ++k) {
    const std::vector<Point> a = random_body(random, static_cast<std::size_t>(random.between(1, 5))),
                             b = random_body(random, static_cast<std::size_t>(random.between(2, 5)));
    Vector v{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
    if (is_zero(v)) v = {0, 0, 1};
    const auto greatest = LinesAlong(v, a, b).greatest(a[0], 100).overlap;
    for (const mpq_class& slack : {mpq_class(0), mpq_class(1, 7), mpq_class(3), mpq_class(-1, 5)}) {
      const mpq_class least = greatest ? mpq_class(greatest->factor - slack) : slack;
      expect_set_of_twin(v, a, b, least);
      const std::size_t corners = LinesAlong(v, a, b).at_least(least).size();
      polygons += corners > 2 ? 1 : 0, empty += corners == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(polygons, 20U);
  EXPECT_GT(empty, 20U);
}

// Lemma D of proofs/judge.md: along an optimal direction the local depth is nowhere more than the
// depth, and it is the depth just on the patch.
TEST(LocalDepth, IsTheDepthOnThePatchAlone) {
  std::size_t patches = 0;
  for (const char* name :
       {"boxes_aligned", "random_lattice", "contact_facet_facet", "contact_facet_edge", "near_ties"}) {
    const families::Family& family = *families::find_family(name);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Case pair = family.make(seed, 8);
      const std::vector<Point>&a = pair.a.points.exact(), &b = pair.b.points.exact();
      const Depth depth = penetration_depth(a, b);
      if (depth.status() != Status::penetrating) continue;
      for (const Optimum& optimum : depth.optima()) {
        const Vector& n = optimum.direction;
        const LinesAlong lines(n, a, b);
        const mpq_class whole = optimum.support / mpq_class(dot(n, n));
        EXPECT_EQ(lines.greatest(a[0], 1'000'000'000).overlap->factor, whole) << name;
        const Patch patch =
            shared_inside({n, pair.a.points, optimum.contact.a, pair.b.points, optimum.contact.b}, optimum.support);
        const Point middle = patch.centroid().a.core;
        EXPECT_EQ(lines.at(middle)->factor, whole);
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
          const Point corner = patch.a(k).core;
          EXPECT_EQ(lines.at(corner)->a, corner);
          EXPECT_EQ(lines.at(corner)->b, patch.b(k).core);
          if (patch.rank() == 0) continue;
          const auto beyond = lines.at(corner + mpq_class(1, 1000) * (corner - middle));
          EXPECT_TRUE(!beyond || beyond->factor < whole) << "law: less beside the patch";
        }
        ++patches;
      }
    }
  }
  EXPECT_GT(patches, 10U);
}

}  // namespace
}  // namespace fathom::patch
