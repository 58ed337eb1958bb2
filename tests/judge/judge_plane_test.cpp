// SPDX-License-Identifier: GPL-3.0-or-later
// Answers about bodies of the plane: judged by what stands for these in space, and held against the
// edges of the polygons, one after another, in a second way.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fathom/plane.hpp"
#include "tests/judge/pairs.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/protocol.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::judging {
namespace {

using Polygon = std::vector<Point>;

Body polygon(Polygon points) { return in_plane(Body{std::move(points)}); }
Polygon box(const mpq_class& x, const mpq_class& y) {
  return {{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}};
}

Judgement judged_in_plane(const Body& a, const Body& b, const Reply& reply, const Tolerance& tolerance = {}) {
  return judged(truth_of(a, b), reply, {}, {}, tolerance);
}

mpq_class across(const Point& n, const Point& p) { return n.x * p.x + n.y * p.y; }

/// max_b <n,b> - min_a <n,a>: how far A must move along n, times |n|.
mpq_class height(const Point& n, const Polygon& a, const Polygon& b) {
  std::optional<mpq_class> low, high;
  for (const Point& p : a)
    if (!low || across(n, p) < *low) low = across(n, p);
  for (const Point& p : b)
    if (!high || across(n, p) > *high) high = across(n, p);
  return *high - *low;
}

/// The squared depth of two polygons with interiors, at most 0 if none: the least over both ways
/// across each line through two points of one body.
mpq_class squared_depth_naive(const Polygon& a, const Polygon& b, Point& way) {
  std::optional<mpq_class> least;
  for (const Polygon* body : {&a, &b})
    for (const Point& p : *body)
      for (const Point& q : *body) {
        const Point n{p.y - q.y, q.x - p.x, 0};
        if (n.x == 0 && n.y == 0) continue;
        const mpq_class h = height(n, a, b), squared = h * abs(h) / (n.x * n.x + n.y * n.y);
        if (!least || squared < *least) least = squared, way = n;
      }
  return *least;
}

TEST(JudgePlane, TolerancesAreThoseOfThePlane) {
  const mpq_class shallow(1, 1 << 16);
  const Body a = polygon(box(0, 0)), b = polygon(box(1 - shallow, 0));
  const Tolerance of_extent{0, mpq_class(1, 1 << 20), 0};  // the extent is 1, the prisms are 4 high or more
  for (const int sign : {1, -1}) {
    const auto claim = [&](const mpq_class& off) {
      return testing::overlap(mpq_class(shallow + sign * off).get_d(), Triple{-1, 0, 0});
    };
    EXPECT_EQ(judged_in_plane(a, b, claim(mpq_class(1, 1 << 20)), of_extent).verdict, Verdict::pass);
    EXPECT_EQ(judged_in_plane(a, b, claim(mpq_class(5, 1 << 22)), of_extent).verdict,
              sign > 0 ? Verdict::too_deep : Verdict::too_shallow);
  }
  // So are the classes, by u R.
  EXPECT_EQ(judged_in_plane(a, b, testing::overlap(shallow.get_d() + 0x1p-50, Triple{-1, 0, 0})).accuracy,
            Accuracy::u_r_16);
}

TEST(JudgePlane, LikeOneEdgeAfterAnother) {
  std::size_t deep = 0;
  for (const families::Family& family : families::families(families::Kind::plane)) {
    if (family.name == "plane_rounded" || family.name == "plane_flat") continue;
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const Case pair = family.make(seed, 7);
      const Polygon &a = pair.a.points.exact(), &b = pair.b.points.exact();
      Point way;
      const mpq_class squared = squared_depth_naive(a, b, way);
      const AnyTruth any = truth_of(pair.a, pair.b);
      const Truth& truth = std::get<Truth>(any);
      EXPECT_EQ(truth.depth.squared(), std::max(squared, mpq_class(0))) << pair.id;
      EXPECT_EQ(truth.depth.status() == Status::penetrating, squared > 0) << pair.id;
      if (squared <= 0) continue;
      ++deep;
      const Triple u = testing::unit(primitive_along(way));
      const double depth = root_binary64(squared, Rounding::rn);
      const Judgement right = judge(truth, testing::overlap(depth, u));
      EXPECT_EQ(right.verdict, Verdict::pass) << pair.id << ": " << right.sentence;
      EXPECT_EQ(right.accuracy, Accuracy::correctly_rounded) << pair.id;
      const Point claimed = exact_point(u), other{-claimed.y, claimed.x, 0};
      const mpq_class h = height(claimed, a, b);
      EXPECT_EQ(right.separating_distance_squared, h * abs(h) / across(claimed, claimed)) << pair.id;
      const Judgement aside = judge(truth, testing::overlap(depth, Triple{-u[1], u[0], 0}));
      const mpq_class beside = height(other, a, b);
      EXPECT_EQ(aside.separating_distance_squared, beside * abs(beside) / across(other, other)) << pair.id;
      const Tolerance of_depth{mpq_class(1, 1000), 0, 0};
      const auto wrong = [&](const Reply& reply) { return judge(truth, reply, {}, {}, of_depth).verdict; };
      EXPECT_EQ(wrong(testing::overlap(1.01 * depth)), Verdict::too_deep) << pair.id;
      EXPECT_EQ(wrong(testing::overlap(0.99 * depth)), Verdict::too_shallow) << pair.id;
      EXPECT_EQ(wrong({}), Verdict::false_separation) << pair.id;
    }
  }
  EXPECT_GT(deep, 30U);
}

TEST(JudgePlane, RoundedBodiesByTheirRadii) {
  const auto grown = [](Polygon core, const mpq_class& radius) {
    Body body;
    body.shape = with_margin(hull(core), radius);
    return in_plane(std::move(body));
  };
  const Body disc = grown({{0, 0, 0}}, 1), bar = grown({{3, -5, 0}, {3, 5, 0}}, mpq_class(5, 2));
  EXPECT_EQ(judged_in_plane(disc, bar, testing::overlap(0.5, Triple{-1, 0, 0})).verdict, Verdict::pass);
  EXPECT_EQ(judged_in_plane(disc, bar, testing::overlap(0.51, Triple{-1, 0, 0})).verdict, Verdict::too_deep);
  const Body far = grown({{0, 9, 0}}, 1);
  EXPECT_EQ(judged_in_plane(disc, far, testing::apart(7)).verdict, Verdict::pass);
  EXPECT_EQ(judged_in_plane(disc, far, testing::apart(7.1)).verdict, Verdict::too_far);
}

TEST(JudgePlane, WitnessesInThePlane) {
  const Body a = polygon(box(0, 0)), b = polygon(box(mpq_class(1, 2), mpq_class(1, 4)));
  Reply reply = testing::overlap(0.5, Triple{-1, 0, 0});
  reply.witness_a = Triple{1, 0.5, 0}, reply.witness_b = Triple{0.5, 0.5, 0};
  EXPECT_EQ(judged_in_plane(a, b, reply).verdict, Verdict::pass);
  reply.witness_a = Triple{1.25, 0.5, 0}, reply.witness_b = Triple{0.75, 0.5, 0};
  EXPECT_EQ(judged_in_plane(a, b, reply).verdict, Verdict::witness_off);
}

}  // namespace
}  // namespace fathom::judging
