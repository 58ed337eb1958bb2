// SPDX-License-Identifier: GPL-3.0-or-later
// The depth along a direction, by one ray; and that by the gauge of a polytope, by a ray for each
// of its vertices.

#include <algorithm>

#include "fathom/approximate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::approximate {
namespace {

/// The primitive integer vector of the same direction; direction = `unit` times it.
Vector integral(const Point& direction, mpq_class& unit) {
  const mpz_class d = lcm(lcm(direction.x.get_den(), direction.y.get_den()), direction.z.get_den());
  const Vector v{mpq_class(d * direction.x).get_num(), mpq_class(d * direction.y).get_num(),
                 mpq_class(d * direction.z).get_num()};
  unit = kernels::ratio(gcd(gcd(v.x, v.y), v.z), d);
  return primitive(v);
}

void require_direction(const Point& direction) {
  for (const mpq_class* component : {&direction.x, &direction.y, &direction.z})
    kernels::require_lowest_terms(*component);
  if (direction == Point{0, 0, 0}) throw std::invalid_argument("the direction of a ray may not be zero");
}

bool contains_opposites(std::vector<Vector> vertices) {
  std::vector<Vector> opposites;
  for (const Vector& v : vertices) opposites.push_back(-v);
  std::sort(vertices.begin(), vertices.end(), lexicographically_less);
  std::sort(opposites.begin(), opposites.end(), lexicographically_less);
  return vertices == opposites;
}

void require_interior_origin(const polytope::PlacedPair& pair) {
  if (polytope::affine_rank(pair.a.points()) < 3)
    throw NoUnitBall("the unit ball is flat: its points lie in one plane");
  const polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
  if (origin.position == polytope::Position::outside)
    throw NoUnitBall("the unit ball does not contain O, which must lie inside it");
  if (origin.position == polytope::Position::boundary)
    throw NoUnitBall("the unit ball has O on its boundary, which must lie inside it");
}

}  // namespace

MetricDepth metric_depth(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                         const UnitBall& ball, const Vector& shift) {
  const kernels::DefaultFloatEnvironment environment;
  const RayShooter shooter(a, b);
  MetricDepth result;
  const auto count = static_cast<std::uint32_t>(ball.vertices.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % rays_between_reports == 0) context.report("rays", static_cast<double>(i) / count);
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

}  // namespace fathom::approximate

namespace fathom {

mpq_class DirectionalDepth::factor() const { return penetration() ? penetration()->factor : mpq_class(0); }

Point DirectionalDepth::translation() const { return penetration() ? penetration()->translation : Point(); }

mpq_class DirectionalDepth::squared() const {
  const Point t = translation();
  return dot(t, t);
}

const Vector& DirectionalDepth::normal() const { return penetration() ? penetration()->normal : separation()->normal; }

DirectionalDepth Hierarchies::directional_depth(const Point& direction, Monitor* monitor) const {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_direction(direction);
  const BodyPair& pair = *pair_;
  if (pair.separation()) return {{pair.facts(), *pair.separation()}};
  kernels::Context(monitor).report("ray");
  mpq_class unit;
  const Vector u = approximate::integral(direction, unit);
  const approximate::RayHit hit = approximate::shoot_ray(pair.a(), pair.b(), u);
  if (!hit.hits || sgn(hit.factor) <= 0)
    throw std::logic_error("a ray from the interior of P found it flat or missed it");
  const Point t = pair.translation(hit.factor, u);
  BodyPair::Meeting meeting = pair.meeting(hit.normal, t);
  if (!meeting.witness) throw std::logic_error("a ray leaves P beside the facet that it hits");
  const mpq_class factor = hit.factor / (unit * pair.placed().denominator);
  return {{pair.facts(), RayExit{factor, t, hit.normal, std::move(meeting.contact), *meeting.witness, hit.steps}}};
}

DirectionalDepth directional_depth(std::span<const Point> a, std::span<const Point> b, const Point& direction,
                                   Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  approximate::require_direction(direction);
  return Hierarchies(a, b, monitor).directional_depth(direction, monitor);
}

UnitBall unit_ball(std::span<const Point> points) {
  const kernels::DefaultFloatEnvironment environment;
  const Point origin{0, 0, 0};
  const polytope::PlacedPair pair =
      polytope::place(points, {&origin, 1});  // the lattice's origin is the first point of what stands second
  approximate::require_interior_origin(pair);
  polytope::Polytope hull = polytope::convex_hull(pair.a.points());
  UnitBall ball;
  ball.vertices = std::move(hull.vertices);
  ball.input_ids = std::move(hull.input_ids);
  ball.denominator = pair.denominator;
  ball.symmetric = approximate::contains_opposites(ball.vertices);
  return ball;
}

const std::vector<MetricOptimum>& MetricResult::optima() const {
  static const std::vector<MetricOptimum> none;
  return penetration() ? penetration()->optima : none;
}

MetricResult Hierarchies::metric_depth(const UnitBall& ball, Monitor* monitor) const {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(monitor);
  const BodyPair& pair = *pair_;
  if (pair.separation()) return {{pair.facts(), *pair.separation()}};
  const approximate::MetricDepth found = approximate::metric_depth(context, pair.a(), pair.b(), ball);
  if (found.deciding.empty()) throw std::logic_error("a ray from the interior of P found it flat or missed it");
  // found.depth vectors of the ball's lattice, each ball.denominator times a vertex, in units of 1
  // / denominator of the bodies.
  MetricPenetration result{found.depth * ball.denominator / pair.placed().denominator, {}, found.rays};
  for (const approximate::MetricDepth::Deciding& d : found.deciding) {
    const Point t = pair.translation(found.depth, ball.vertices[d.vertex]);
    BodyPair::Meeting meeting = pair.meeting(d.normal, t);
    if (!meeting.witness) throw std::logic_error("a ray leaves P beside the facet that it hits");
    result.optima.push_back({ball.input_ids[d.vertex], t, d.normal, std::move(meeting.contact), *meeting.witness});
  }
  return {{pair.facts(), std::move(result)}};
}

MetricResult metric_depth(std::span<const Point> a, std::span<const Point> b, const UnitBall& ball, Monitor* monitor) {
  return Hierarchies(a, b, monitor).metric_depth(ball, monitor);
}

}  // namespace fathom
