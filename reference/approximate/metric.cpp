// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/metric.hpp"

#include <algorithm>

#include "kernels/float_environment.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {
namespace {

constexpr std::uint64_t rays_between_reports = 64;

bool contains_opposites(std::vector<Vector> vertices) {
  std::vector<Vector> opposites;
  for (const Vector& v : vertices) opposites.push_back(-v);
  std::sort(vertices.begin(), vertices.end(), lexicographically_less);
  std::sort(opposites.begin(), opposites.end(), lexicographically_less);
  return vertices == opposites;
}

// O and the points on one lattice. Its origin is the first point of what stands second, which is O.
Lattice around_origin(std::span<const Point> points) {
  const Point origin{0, 0, 0};
  return common_lattice(points, {&origin, 1});
}

void require_interior_origin(const Lattice& lattice) {
  if (affine_rank(lattice.a) < 3) throw NoUnitBall("the unit ball is flat: its points lie in one plane");
  const long exponent = binary_exponent(lattice.a);
  const PositionOfOrigin origin = position_of_origin(PointCloud(lattice.a, exponent), PointCloud(lattice.b, exponent));
  if (origin.position == Position::outside) throw NoUnitBall("the unit ball does not contain O, which must lie inside it");
  if (origin.position == Position::boundary) throw NoUnitBall("the unit ball has O on its boundary, which must lie inside it");
}

}  // namespace

UnitBall unit_ball(std::span<const Point> points) {
  const DefaultFloatEnvironment environment;
  const Lattice lattice = around_origin(points);
  require_interior_origin(lattice);
  Polytope hull = convex_hull(lattice.a);
  UnitBall ball;
  ball.vertices = std::move(hull.vertices);
  ball.input_ids = std::move(hull.input_ids);
  ball.denominator = lattice.denominator;
  ball.symmetric = contains_opposites(ball.vertices);
  return ball;
}

MetricDepth metric_depth(const Hierarchy& a, const Hierarchy& b, const UnitBall& ball, const Vector& shift,
                         const std::function<bool(double)>& progress) {
  const DefaultFloatEnvironment environment;
  const RayShooter shooter(a, b);
  MetricDepth result;
  const auto count = static_cast<std::uint32_t>(ball.vertices.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (progress && i % rays_between_reports == 0 && !progress(static_cast<double>(i) / count)) throw Interrupted();
    const RayHit hit = shooter.shoot(ball.vertices[i], shift);
    ++result.rays;
    result.inside = hit.hits;
    if (!hit.hits || sgn(hit.factor) == 0) {
      result.depth = 0;
      result.deciding.clear();
      return result;
    }
    if (result.deciding.empty() || hit.factor < result.depth) {
      result.depth = hit.factor;
      result.deciding.clear();
    }
    if (hit.factor == result.depth) result.deciding.push_back({i, hit.normal});
  }
  return result;
}

MetricResult metric_depth(std::span<const Point> a, std::span<const Point> b, const UnitBall& ball, const ReportProgress& progress) {
  const DefaultFloatEnvironment environment;
  const BodyPair pair(a, b, progress);
  MetricResult result;
  result.status = pair.status();
  result.direction = pair.separating();
  result.flat_a = pair.flat_a();
  result.flat_b = pair.flat_b();
  if (pair.status() != Status::penetrating) return result;
  const MetricDepth found = metric_depth(pair.a(), pair.b(), ball, {0, 0, 0}, [&](double share) {
    report(progress, "rays", share);
    return true;
  });
  if (found.deciding.empty()) throw std::logic_error("a ray from the interior of P found it flat or missed it");
  result.rays = found.rays;
  // found.depth vectors of the ball's lattice, each ball.denominator times a vertex, in units of 1 / denominator of the bodies.
  result.depth = found.depth * ball.denominator / pair.lattice().denominator;
  for (const MetricDepth::Deciding& d : found.deciding) {
    const Point t = pair.translation(found.depth, ball.vertices[d.vertex]);
    result.optima.push_back({ball.input_ids[d.vertex], t, d.normal, pair.contact(d.normal), pair.witness(d.normal, t)});
  }
  result.direction = result.optima.front().direction;
  return result;
}

}  // namespace fathom
