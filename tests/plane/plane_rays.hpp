// SPDX-License-Identifier: GPL-3.0-or-later
// What answers by rays in the plane must obey: naive twins look at each edge of B - A.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "fathom/approximate.hpp"
#include "kernels/vector.hpp"
#include "tests/plane/pairs.hpp"

namespace fathom::plane {

/// The edges of B - A: their primitive outward normals, and h(n).
struct NaiveEdge {
  Vector normal;
  mpq_class height;
};

inline std::vector<NaiveEdge> naive_edges(const Points& a, const Points& b) {
  Points differences;
  for (const Point& p : a)
    for (const Point& q : b) differences.push_back(q - p);
  const Points sum = hull(std::move(differences));
  std::vector<NaiveEdge> edges;
  for (std::size_t i = 0; i < sum.size() && sum.size() > 2; ++i) {
    const Point &p = sum[i], edge = sum[(i + 1) % sum.size()] - p;
    const Vector n = primitive_along({edge.y, -edge.x, 0});
    edges.push_back({n, height(rational(n), p)});
  }
  return edges;
}

/// The factor after which the ray from a point inside leaves the edges' polygon.
inline mpq_class naive_exit(const std::vector<NaiveEdge>& edges, const Point& from, const Point& direction) {
  std::optional<mpq_class> least;
  for (const NaiveEdge& edge : edges) {
    const Point n = rational(edge.normal);
    const mpq_class along = height(n, direction);
    if (along <= 0) continue;
    const mpq_class factor = (edge.height - height(n, from)) / along;
    if (!least || factor < *least) least = factor;
  }
  return *least;
}

/// Which is naive itself, and exact.
inline mpq_class naive_squared_width(const Points& points) { return naive_depth(points, points).squared; }

inline mpq_class naive_support(const PlanePair& pair, const Vector& direction) {
  const Point n = rational(direction), m{-n.x, -n.y, 0};
  return height(n, pair.b[naive_face(pair.b, n).front()]) - height(n, pair.a[naive_face(pair.a, m).front()]);
}

/// Everything about one pair, in one direction and one ball that the stream of numbers gives.
class RayLaws {
 public:
  RayLaws(const PlanePair& pair, std::string id)
      : pair_(pair),
        id_(std::move(id)),
        a_(body_of(pair.a)),
        b_(body_of(pair.b)),
        naive_(naive_depth(pair.a, pair.b)),
        edges_(naive_edges(pair.a, pair.b)) {}

  void expect_ray(const Point& direction) const {
    const DirectionalDepth found = directional_depth(a_, b_, direction);
    expect_plane_between(found);
    const RayExit* const exit = found.penetration();
    if (!exit) return;
    EXPECT_EQ(exit->factor, naive_exit(edges_, {0, 0, 0}, direction)) << id_;
    EXPECT_EQ(exit->translation, exit->factor * direction) << id_;
    expect_met(*exit, exit->normal, exit->translation);
    EXPECT_EQ(exit->witness.b - exit->witness.a, exit->translation) << id_;
    EXPECT_TRUE(exit->witness.a.z == 0 && exit->witness.b.z == 0) << id_;
  }

  /// About the means of corners, and about two points of the bodies.
  void expect_growth() const {
    const Points corners_a = hull(pair_.a), corners_b = hull(pair_.b);
    expect_growth(mean(corners_a), mean(corners_b), std::nullopt, std::nullopt);
    const Point p = pair_.a.front(), q = pair_.b.back();
    expect_growth(p, q, p, q);
  }

  void expect_metric(const Points& points) const {
    const UnitBall ball = unit_ball(body_of(points));
    ASSERT_EQ(ball.vertices.size(), hull(points).size()) << id_;
    const MetricResult found = metric_depth(a_, b_, ball);
    expect_plane_between(found);
    if (!found.penetration()) return;
    std::optional<mpq_class> least;
    std::vector<std::uint32_t> deciding, told;
    for (const std::uint32_t i : ball.input_ids) {
      const mpq_class factor = naive_exit(edges_, {0, 0, 0}, points[i]);
      if (!least || factor < *least) (least = factor, deciding.clear());
      if (factor == *least) deciding.push_back(i);
    }
    EXPECT_EQ(found.depth(), *least) << id_;
    for (const MetricOptimum& optimum : found.optima()) {
      told.push_back(optimum.vertex);
      EXPECT_EQ(optimum.translation, *least * points[optimum.vertex]) << id_;
      expect_met(optimum, optimum.direction, optimum.translation);
      EXPECT_EQ(optimum.witness.b - optimum.witness.a, optimum.translation) << id_;
    }
    EXPECT_EQ(told, deciding) << id_;
  }

  void expect_approximation(const mpq_class& delta) const {
    const ApproxDepth found = approx_depth(a_, b_, delta);
    expect_plane_between(found);
    if (found.penetration()) expect_within(found, naive_.squared);
  }

  void expect_widths(const mpq_class& delta) const {
    const Depth exact = std::get<Depth>(exact_answer(b_, b_).found);
    const mpq_class squared = hull(pair_.b).size() > 2 ? naive_squared_width(pair_.b) : mpq_class(0);
    EXPECT_EQ(exact.squared(), squared) << id_;
    const ApproxDepth found = approx_width(b_, delta);
    EXPECT_EQ(found.status(), exact.status()) << id_;
    EXPECT_EQ(found.direction().z, 0) << id_;
    EXPECT_EQ(found.squared() == 0, squared == 0) << id_;
    if (found.penetration()) expect_within(found, squared);
  }

 private:
  static Point mean(const Points& points) {
    Point sum{0, 0, 0};
    for (const Point& p : points) sum = sum + p;
    return mpq_class(1, static_cast<unsigned long>(points.size())) * sum;
  }

  /// The facts of every answer; if the bodies do not penetrate, a line between them.
  template <class Penetrating>
  void expect_plane_between(const SeparationOr<Penetrating>& found) const {
    ASSERT_EQ(found.status(), naive_.status) << id_;
    EXPECT_EQ(found.flat_a, hull(pair_.a).size() < 3) << id_;
    EXPECT_EQ(found.flat_b, hull(pair_.b).size() < 3) << id_;
    if (!found.separation()) return;
    const Vector n = found.separation()->normal;
    EXPECT_EQ(n.z, 0) << id_;
    EXPECT_EQ(n, primitive(n)) << id_;
    EXPECT_EQ(sgn(naive_support(pair_, n)), naive_.status == Status::touching ? 0 : -1) << id_;
  }

  /// The faces in a direction, which is normal to an edge of B - A through the translation.
  void expect_met(const auto& met, const Vector& direction, const Point& translation) const {
    const Point n = rational(direction);
    EXPECT_EQ(direction.z, 0) << id_;
    EXPECT_EQ(met.contact.a, naive_face(pair_.a, {-n.x, -n.y, 0})) << id_;
    EXPECT_EQ(met.contact.b, naive_face(pair_.b, n)) << id_;
    const bool edge_a = met.contact.a.size() == 2, edge_b = met.contact.b.size() == 2;
    EXPECT_EQ(name(met.contact.kind), std::string(edge_a ? "edge" : "vertex") + (edge_b ? "-edge" : "-vertex")) << id_;
    EXPECT_TRUE(edge_a || edge_b) << id_;
    EXPECT_EQ(height(n, translation), naive_support(pair_, direction)) << id_;
  }

  void expect_within(const ApproxDepth& found, const mpq_class& squared) const {
    const mpq_class factor = 1 + found.delta;
    EXPECT_LE(found.bound_squared(), squared) << id_;
    EXPECT_LE(squared, found.squared()) << id_;
    EXPECT_LE(found.squared(), factor * factor * found.bound_squared()) << id_;
    EXPECT_EQ(found.direction().z, 0) << id_;
    EXPECT_EQ(square(found.translation()), found.squared()) << id_;
    const auto& witness = found.penetration()->witness;
    if (!witness) return;
    EXPECT_EQ(witness->b - witness->a, found.translation()) << id_;
    EXPECT_TRUE(witness->a.z == 0 && witness->b.z == 0) << id_;
  }

  void expect_growth(const Point& center_a, const Point& center_b, const std::optional<Point>& given_a,
                     const std::optional<Point>& given_b) const {
    const Point between = center_b - center_a;
    bool inside = !edges_.empty();
    for (const NaiveEdge& edge : edges_) inside = inside && height(rational(edge.normal), between) < edge.height;
    if (!inside) {
      EXPECT_THROW(growth_distance(a_, b_, given_a, given_b), NoGrowth) << id_;
      return;
    }
    const GrowthDistance found = growth_distance(a_, b_, given_a, given_b);
    EXPECT_EQ(found.center_a, center_a) << id_;
    EXPECT_EQ(found.center_b, center_b) << id_;
    EXPECT_EQ(found.status(), naive_.status) << id_;
    if (square(between) == 0) {
      EXPECT_EQ(found.growth, 0) << id_;
      EXPECT_FALSE(found.touch) << id_;
      return;
    }
    EXPECT_EQ(found.growth, 1 / naive_exit(edges_, between, -1 * between)) << id_;
    const GrownTouch& touch = found.touch.value();
    const Vector n = touch.normal;
    EXPECT_EQ(n.z, 0) << id_;
    EXPECT_EQ(touch.contact.a, naive_face(pair_.a, rational(-n))) << id_;
    EXPECT_EQ(touch.contact.b, naive_face(pair_.b, rational(n))) << id_;
    EXPECT_EQ(combined(touch.weights_a, touch.contact.a, pair_.a), touch.witness.a) << id_;
    EXPECT_EQ(combined(touch.weights_b, touch.contact.b, pair_.b), touch.witness.b) << id_;
    EXPECT_EQ(center_a + found.growth * (touch.witness.a - center_a),
              center_b + found.growth * (touch.witness.b - center_b))
        << id_;
  }

  /// What the weights make of points of a face.
  [[nodiscard]] Point combined(const std::vector<Weight>& weights, const std::vector<std::uint32_t>& face,
                               const Points& points) const {
    mpq_class sum;
    Point place{0, 0, 0};
    for (const Weight& w : weights) {
      EXPECT_TRUE(w.weight > 0 && std::ranges::find(face, w.index) != face.end()) << id_;
      sum += w.weight;
      place = place + w.weight * points.at(w.index);
    }
    EXPECT_EQ(sum, 1) << id_;
    return place;
  }

  PlanePair pair_;
  std::string id_;
  Body a_, b_;
  NaiveAnswer naive_;
  std::vector<NaiveEdge> edges_;
};

/// A polygon around O, with a point on an edge.
inline Points some_ball(Random& random) {
  const long slope = random.between(-2, 2);
  Points points;
  const auto add = [&](long x, long y) { points.push_back({x + slope * y, y, 0}); };
  add(random.between(1, 5), 0);
  add(random.between(-5, -1), random.between(1, 5));
  add(random.between(-5, -1), random.between(-5, -1));
  if (random.between(0, 1) == 0)
    for (const std::size_t i : {0, 1, 2}) points.push_back(-1 * points[i]);
  points.push_back(mpq_class(1, 2) * (points[0] + points[1]));
  return points;
}

inline void expect_right_rays(int count) {
  const std::vector<mpq_class> deltas{mpq_class(1, 10), mpq_class(2, 5), 3};
  for (const PairKind kind : all_kinds) {
    Random random(11 + static_cast<std::uint64_t>(kind));
    for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
      const PlanePair pair = plane_pair(kind, random);
      const Points ball = some_ball(random);
      const RayLaws laws(pair, std::to_string(static_cast<int>(kind)) + text_of(pair));
      laws.expect_ray({random.between(-9, 9), mpq_class(random.between(1, 9)) / 7, 0});
      laws.expect_growth();
      laws.expect_metric(ball);
      const mpq_class& delta = deltas[static_cast<std::size_t>(i) % deltas.size()];
      laws.expect_approximation(delta);
      laws.expect_widths(delta);
    }
  }
}

}  // namespace fathom::plane
