// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of convex bodies of the plane of several kinds, and what an answer about each must obey.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "fathom/answer.hpp"
#include "fathom/plane.hpp"
#include "kernels/number/rational.hpp"
#include "tests/plane/naive_plane.hpp"
#include "verify/families/random.hpp"

namespace fathom::plane {

using families::Random;

enum class PairKind { random, regular, ties, parallel, nearly_touching, far, flat };
inline constexpr std::array all_kinds{PairKind::random,          PairKind::regular, PairKind::ties, PairKind::parallel,
                                      PairKind::nearly_touching, PairKind::far,     PairKind::flat};

inline Points random_points(Random& random, long count, long size) {
  Points points;
  for (long i = 0; i < count; ++i) points.push_back({random.between(-size, size), random.between(-size, size), 0});
  return points;
}

inline Points moved(Points points, const Point& by) {
  for (Point& p : points) p = p + by;
  return points;
}

/// In space.
inline Points prism(const Points& points, long half) {
  Points result;
  for (const long z : {-half, half})
    for (const Point& p : points) result.push_back({p.x, p.y, z});
  return result;
}

/// With integer corners near those of a regular polygon, which is turned by some steps.
inline Points regular(long count, long turn, long radius) {
  Points points;
  for (long i = 0; i < count; ++i) {
    const double angle =
        2 * 3.14159265358979 * (static_cast<double>(i) + static_cast<double>(turn) / 7) / static_cast<double>(count);
    points.push_back({std::lround(static_cast<double>(radius) * std::cos(angle)),
                      std::lround(static_cast<double>(radius) * std::sin(angle)), 0});
  }
  return points;
}

/// A box with cut corners: its edges have eight directions at most.
inline Points cut_box(Random& random) {
  const long x = random.between(2, 9), y = random.between(2, 9), cut = random.between(0, 2);
  Points points;
  for (const long sx : {-1, 1})
    for (const long sy : {-1, 1}) {
      points.push_back({sx * (x - cut), sy * y, 0});
      points.push_back({sx * x, sy * (y - cut), 0});
    }
  return points;
}

struct PlanePair {
  Points a, b;
};

inline PlanePair plane_pair(PairKind kind, Random& random) {
  const auto some = [&](long size) { return random_points(random, random.between(3, 8), size); };
  const Point near{random.between(-6, 6), random.between(-6, 6), 0};
  switch (kind) {
    case PairKind::random: return {some(50), moved(some(50), {random.between(-60, 60), random.between(-60, 60), 0})};
    case PairKind::regular: {
      const long count = random.between(3, 12);
      return {regular(count, random.between(0, 6), 1000), moved(regular(count, random.between(0, 6), 700), near)};
    }
    case PairKind::ties: return {some(2), moved(some(2), {random.between(-1, 1), random.between(-1, 1), 0})};
    case PairKind::parallel: return {cut_box(random), moved(cut_box(random), near)};
    case PairKind::far: {
      const Point there{mpq_class(mpz_class(1) << 40), mpq_class(-(mpz_class(1) << 41)), 0};
      return {moved(some(9), there), moved(moved(some(9), there), near)};
    }
    case PairKind::flat: {
      const auto few = [&] { return random_points(random, random.between(1, 2), 3); };
      return random.between(0, 1) == 0 ? PlanePair{few(), random.between(0, 1) == 0 ? few() : some(4)}
                                       : PlanePair{some(4), few()};
    }
    default: {  // touching in a direction, but for a little
      PlanePair pair{some(20), some(20)};
      const Point n{random.between(-5, 5), random.between(1, 5), 0};
      const mpq_class h = height(n, pair.b[naive_face(pair.b, n).front()]) -
                          height(n, pair.a[naive_face(pair.a, {-n.x, -n.y, 0}).front()]);
      const mpq_class little = mpq_class(random.between(-1, 1)) / mpq_class(mpz_class(1) << 40);
      pair.a = moved(std::move(pair.a), (h / square(n) + little) * n);
      return pair;
    }
  }
}

inline Body body_of(const Points& points) { return in_plane(Body{points}); }

inline std::vector<Vector> ways_of(const Depth& depth) {
  std::vector<Vector> ways;
  for (const Optimum& optimum : depth.optima()) ways.push_back(optimum.direction);
  return ways;
}

/// Every field of the answer against the definitions.
inline void expect_right(const PlanePair& pair, const std::string& id) {
  const Answer answer = exact_answer(body_of(pair.a), body_of(pair.b));
  ASSERT_EQ(answer.dimension(), 2U) << id;
  const Depth& depth = std::get<Depth>(answer.found);
  const NaiveAnswer naive = naive_depth(pair.a, pair.b);
  ASSERT_EQ(depth.status(), naive.status) << id;
  EXPECT_EQ(abs(signed_square(depth)), naive.squared) << id;
  EXPECT_EQ(ways_of(depth), naive.ways) << id << ": each shortest way once, in their order";
  EXPECT_EQ(depth.flat_a, hull(pair.a).size() < 3) << id;
  EXPECT_EQ(depth.flat_b, hull(pair.b).size() < 3) << id;
  const Vector n = depth.direction();
  EXPECT_EQ(n.z, 0) << id;
  const Witness witness = depth.contact_points();
  EXPECT_EQ(witness.b - witness.a, depth.contact_translation()) << id;
  EXPECT_TRUE(witness.a.z == 0 && witness.b.z == 0) << id;
  const auto expect_faces = [&](const Contact& contact, const Vector& direction) {
    const Point u = rational(direction);
    EXPECT_EQ(contact.a, naive_face(pair.a, {-u.x, -u.y, 0})) << id;
    EXPECT_EQ(contact.b, naive_face(pair.b, u)) << id;
    const bool edge_a = contact.a.size() == 2, edge_b = contact.b.size() == 2;
    EXPECT_EQ(name(contact.kind), std::string(edge_a ? "edge" : "vertex") + (edge_b ? "-edge" : "-vertex")) << id;
  };
  for (const Optimum& optimum : depth.optima()) expect_faces(optimum.contact, optimum.direction);
  if (depth.distance()) expect_faces(depth.distance()->contact, n);
}

inline std::string text_of(const PlanePair& pair) {
  std::string text;
  for (const Points* points : {&pair.a, &pair.b}) {
    text += " |";
    for (const Point& p : *points) text += " " + p.x.get_str() + "," + p.y.get_str();
  }
  return text;
}

inline void expect_right_pairs(int count) {
  for (const PairKind kind : all_kinds) {
    Random random(1 + static_cast<std::uint64_t>(kind));
    for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
      const PlanePair pair = plane_pair(kind, random);
      expect_right(pair, std::to_string(static_cast<int>(kind)) + text_of(pair));
    }
  }
}

}  // namespace fathom::plane
