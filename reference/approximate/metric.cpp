// SPDX-License-Identifier: GPL-3.0-or-later
// The depth along a direction, by one ray; and that by the gauge of a polytope, by a ray for each
// of its vertices.
#include <algorithm>

#include "fathom/approximate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/depth/contact.hpp"
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

// The growth distance: one ray through P - c, c = center_b - center_a, from O along -c. P - c is
// the P of A moved by c, so this is the depth of that body along -c.    [proofs/ray.md, "Growth"]

namespace {

const Point no_point{0, 0, 0};

Point mean_of_corners(std::span<const Point> points) {
  const polytope::PlacedPair placed = polytope::place(points, points);
  const polytope::Polytope hull = polytope::convex_hull(placed.a.points());
  Vector sum{0, 0, 0};
  for (const Vector& corner : hull.vertices) sum = sum + corner;
  return placed.position(sum, hull.vertices.size());
}

Point center_of(std::span<const Point> points, const std::optional<Point>& given) {
  if (!given) return mean_of_corners(points);
  for (const mpq_class* component : {&given->x, &given->y, &given->z}) kernels::require_lowest_terms(*component);
  return *given;
}

std::vector<Point> moved(std::span<const Point> points, const Point& by) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back(p + by);
  return result;
}

/// Whether all differences of the bodies lie in a plane.
bool is_sum_flat(std::span<const Point> a, std::span<const Point> b) {
  const polytope::PlacedPair placed = polytope::place(a, b);
  std::vector<Vector> directions;
  for (const kernels::PointCloud* body : {&placed.a, &placed.b})
    for (std::size_t i = 0; i < body->size(); ++i) directions.push_back((*body)[i] - (*body)[0]);
  return polytope::affine_rank(directions) < 3;
}

[[noreturn]] void refuse(std::span<const Point> a, std::span<const Point> b, const Separation& separation) {
  const std::string expected = "expected centers with center_b - center_a inside B - A, ";
  if (is_sum_flat(a, b)) throw NoGrowth(expected + "found that B - A is flat, without an inside");
  throw NoGrowth(expected + (separation.touching ? "found it on the boundary" : "found it outside"));
}

/// Convex weights of corners of the faces, and the points that they combine to, with b - a = t.
void meet(GrownTouch& touch, std::span<const Point> a, std::span<const Point> b, const Point& t) {
  std::vector<Point> of_a, of_b;
  for (const std::uint32_t i : touch.contact.a) of_a.push_back(a[i] + t);
  for (const std::uint32_t i : touch.contact.b) of_b.push_back(b[i]);
  const polytope::PlacedPair faces = polytope::place(of_a, of_b);
  polytope::PositionOfOrigin met = polytope::position_of_origin(faces.a, faces.b);
  if (met.position != polytope::Position::boundary)
    throw std::logic_error("a ray leaves P beside the facet that it hits");
  const auto by_input = [](std::vector<Weight> weights, const std::vector<std::uint32_t>& ids) {
    for (Weight& w : weights) w.index = ids[w.index];
    std::ranges::sort(weights, {}, &Weight::index);
    return weights;
  };
  touch.weights_a = by_input(std::move(met.a), touch.contact.a);
  touch.weights_b = by_input(std::move(met.b), touch.contact.b);
  touch.witness = {depth::combination(touch.weights_a, [&](std::uint32_t i) { return a[i]; }),
                   depth::combination(touch.weights_b, [&](std::uint32_t i) { return b[i]; })};
}

/// The point that convex weights combine; what is wrong with them goes to the report.
Point weighed(kernels::Report& report, std::span<const Point> points, const std::vector<Weight>& weights) {
  mpq_class sum;
  for (const Weight& w : weights) {
    if (!report.expect(w.index < points.size(), "a weight of no point")) return {};
    report.expect(w.weight > 0, "a weight is not positive");
    sum += w.weight;
  }
  report.expect(sum == 1, "weights do not sum to 1");
  return depth::combination(weights, [&](std::uint32_t i) { return points[i]; });
}

/// max <n,p> - <n,center> of a body about its center.
mpq_class reach(std::span<const Point> points, const Point& center, const Point& n) {
  mpq_class most = dot(n, points[0] - center);
  for (const Point& p : points) most = std::max(most, dot(n, p - center));
  return most;
}

}  // namespace

GrowthDistance growth_distance(std::span<const Point> a, std::span<const Point> b, const std::optional<Point>& center_a,
                               const std::optional<Point>& center_b, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  polytope::require_bodies(a, b);
  GrowthDistance result;
  result.center_a = center_of(a, center_a);
  result.center_b = center_of(b, center_b);
  const Point c = result.center_b - result.center_a;
  const bool coincide = c == no_point;  // then any ray tells whether O is inside
  const DirectionalDepth found = directional_depth(moved(a, c), b, coincide ? Point{1, 0, 0} : -c, monitor);
  if (const Separation* separation = found.separation()) refuse(a, b, *separation);
  static_cast<BodyFacts&>(result) = found;
  if (coincide) return result;
  const RayExit& exit = *found.penetration();
  result.growth = 1 / exit.factor;
  result.touch = GrownTouch{exit.normal, exit.contact, {}, {}, {}, exit.steps};
  meet(*result.touch, a, b, (1 - exit.factor) * c);
  return result;
}

kernels::Report validate(const GrowthDistance& found, std::span<const Point> a, std::span<const Point> b) {
  kernels::Report report;
  const mpq_class& g = found.growth;
  const auto &center_a = found.center_a, &center_b = found.center_b;
  report.expect((g == 0) == (center_a == center_b), "the growth is 0 iff the centers coincide");
  if (!report.expect(found.touch.has_value() == (g != 0), "there is a touch iff the growth is not 0") || !found.touch)
    return report;
  const GrownTouch& touch = *found.touch;
  const Point n{touch.normal.x, touch.normal.y, touch.normal.z};
  const mpq_class room = reach(b, center_b, n) + reach(a, center_a, -n);  // h(n) - <n,c>
  report.expect(room > 0, "the normal has no room");
  report.expect(dot(n, center_a - center_b) == g * room, "less growth would have room for the centers");
  const Point of_a = weighed(report, a, touch.weights_a), of_b = weighed(report, b, touch.weights_b);
  report.expect(touch.witness == Witness{of_a, of_b}, "the weights combine other points");
  report.expect(center_a + g * (of_a - center_a) == center_b + g * (of_b - center_b), "the grown bodies do not touch");
  return report;
}

}  // namespace fathom
