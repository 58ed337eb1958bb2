// SPDX-License-Identifier: GPL-3.0-or-later
// The growth distance: one ray through P - c, c = center_b - center_a, from O along -c. P - c is
// the P of A moved by c, so this is the depth of that body along -c.    [proofs/ray.md, "Growth"]

#include <algorithm>

#include "fathom/approximate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {
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
