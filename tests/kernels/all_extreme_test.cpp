// SPDX-License-Identifier: GPL-3.0-or-later
// Its promise, that "true" is never said where the hull has fewer vertices, and that it is said
// where it should be, or it saves nothing.
#include "kernels/filters/all_extreme.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "fathom/files.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/families.hpp"

namespace fathom::kernels {
namespace {

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
