// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where bodies of the plane are raised, and where answers come back.
#include "reference/answer/plane.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/approximate.hpp"
#include "fathom/plane.hpp"
#include "fathom/union.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/depth/contact.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::answer {
namespace {

// ---- raising ----

mpq_class extent_along_x(const Body& body) {
  std::optional<mpq_class> low, high;
  for_each_hull(body, [&](const std::vector<Point>& points) {
    for (const Point& p : points) {
      if (!low || p.x < *low) low = p.x;
      if (!high || p.x > *high) high = p.x;
    }
  });
  return low ? mpq_class(*high - *low) : mpq_class(0);
}

std::vector<Point> raised(const std::vector<Point>& points, const mpq_class& height) {
  std::vector<Point> result;
  result.reserve(2 * points.size());
  for (const mpq_class& z : {mpq_class(-height), height})
    for (const Point& p : points) result.push_back({p.x, p.y, z});
  return result;
}

GivenPoints raised(const GivenPoints& points, const mpq_class& height) {
  const std::optional<double> h = kernels::in_binary64(height);
  if (!points.in_binary64() || !h) return raised(points.exact(), height);
  std::vector<std::array<double, 3>> result;
  result.reserve(2 * points.size());
  for (const double z : {-*h, *h})
    for (const std::array<double, 3>& p : points.binary64()) result.push_back({p[0], p[1], z});
  return GivenPoints(std::move(result));
}

Body raised(const Body& body, const mpq_class& height) {
  Body result;
  if (body.pieces) {
    Pieces pieces;
    for (const std::vector<Point>& piece : *body.pieces) pieces.push_back(raised(piece, height));
    result.pieces = std::make_shared<const Pieces>(std::move(pieces));
  } else if (body.shape) {
    result.shape = Shape{hull(raised(*files::points_of(*body.shape), height)).core, body.shape->radius};
  } else {
    result.points = raised(body.points, height);
  }
  return result;
}

Body flat_in_space(const Body& body) {
  Body result = body;
  result.dimension = 3;
  return result;
}

// ---- coming back: what is left of points and faces of the prisms ----

std::vector<std::uint32_t> mapped(const std::vector<std::uint32_t>& ids, std::size_t count) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t id : ids) result.push_back(id % static_cast<std::uint32_t>(count));
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Contact mapped(const Contact& contact, std::size_t count_a, std::size_t count_b) {
  Contact result{{}, mapped(contact.a, count_a), mapped(contact.b, count_b)};
  result.kind = kind_in_plane(result.a.size() > 1, result.b.size() > 1);
  return result;
}

/// How many points the body has, or a piece of it.
std::size_t count_of(const Body& body, std::uint32_t piece = 0) {
  if (body.pieces) return (*body.pieces)[piece].size();
  return body.shape ? files::points_of(*body.shape).value_or(std::vector<Point>()).size() : body.points.size();
}

/// Where the second body was raised.
void map_facts(const Body& a, const Body& b, BodyFacts& facts) {
  facts.flat_a = is_flat_body(a);
  facts.flat_b = is_flat_body(b);
  facts.extreme_b /= 2;
}

Depth mapped(const Body& a, const Body& b, const Depth& of_prisms) {
  const auto of_plane = [&, count_a = count_of(a), count_b = count_of(b)](const Contact& contact) {
    return mapped(contact, count_a, count_b);
  };
  Depth depth{of_prisms, {}, {}, {}};
  map_facts(a, b, depth);
  depth.method = of_prisms.method;
  depth.counters = of_prisms.counters;
  if (const Touch* const touch = of_prisms.touch()) {
    depth.outcome = *touch;
  } else if (const Distance* const distance = of_prisms.distance()) {
    Distance& mapped_distance = depth.outcome.emplace<Distance>(*distance);
    mapped_distance.contact = of_plane(distance->contact);
  } else {
    const Penetration& penetration = *of_prisms.penetration();
    Penetration result{{}, penetration.unlisted, penetration.meeting, std::nullopt};
    for (const Optimum& optimum : penetration.optima)
      result.optima.push_back({optimum.direction, optimum.support, of_plane(optimum.contact)});
    depth.outcome = std::move(result);
  }
  return depth;
}

SignedDepth mapped(const Body& a, const Body& b, SignedDepth depth) {
  if (const Depth* const cores = std::get_if<Depth>(&depth.core)) depth.core = mapped(a, b, *cores);
  if (depth.cone) depth.cone = cone_in_plane(*std::move(depth.cone));
  if (depth.touching) depth.touching = mapped(*depth.touching, count_of(a), count_of(b));
  return depth;
}

UnionDepth mapped(const Body& a, const Body& b, UnionDepth depth) {
  for (UnionOptimum& optimum : depth.optima)
    for (PieceContact& met : optimum.contacts)
      met.contact = mapped(met.contact, count_of(a, met.a), count_of(b, met.b));
  if (depth.apart) {
    Distance& distance = depth.apart->distance;
    distance.contact = mapped(distance.contact, count_of(a, depth.apart->a), count_of(b, depth.apart->b));
    distance.witness.a.z = distance.witness.b.z = 0;
  }
  return depth;
}

/// A plane that leaves the bodies on its two sides does so without its slope.
template <class Penetrating>
void map(const Body& a, const Body& b, SeparationOr<Penetrating>& found) {
  map_facts(a, b, found);
  if (Separation* const plane = std::get_if<Separation>(&found.outcome)) {
    plane->normal = primitive(Vector{plane->normal.x, plane->normal.y, 0});
    return;
  }
  const auto map_contact = [&](auto& met) { met.contact = mapped(met.contact, count_of(a), count_of(b)); };
  Penetrating& inside = std::get<Penetrating>(found.outcome);
  if constexpr (requires { inside.optima; }) std::ranges::for_each(inside.optima, map_contact);
  else map_contact(inside);
}

std::vector<Weight> mapped(const std::vector<Weight>& weights, std::size_t count) {
  std::map<std::uint32_t, mpq_class> sums;
  for (const Weight& w : weights) sums[w.index % static_cast<std::uint32_t>(count)] += w.weight;
  std::vector<Weight> result;
  for (const auto& [index, weight] : sums) result.push_back({index, weight});
  return result;
}

void map(const Body& a, const Body& b, GrowthDistance& found) {
  map_facts(a, b, found);
  if (!found.touch) return;
  found.touch->contact = mapped(found.touch->contact, count_of(a), count_of(b));
  found.touch->weights_b = mapped(found.touch->weights_b, count_of(b));
}

void require_z_0(const std::vector<Point>& points) {
  if (std::ranges::any_of(points, [](const Point& p) { return p.z != 0; }))
    throw std::invalid_argument("a point of a body of the plane has the z 0, found another");
}

/// By a lattice if the points have a narrow one.
bool is_flat_polytope(const Body& body) {
  polytope::NarrowMemory placed;
  kernels::ScanMemory scans;
  const polytope::Points points(body.points);
  if (!polytope::place_narrow(points, points, placed)) return is_flat(files::shape_of(body));
  return polytope::with_pair(placed, points, points, scans,
                             [](const auto& pair) { return depth::facts_of(pair).flat_a; });
}

// ---- rays ----

void require_points(const Body& body) {
  if (body.shape || body.pieces)
    throw std::invalid_argument("rays are shot through hulls of points, found a shape or a union");
}

using PointSpan = std::span<const Point>;

/// Asks about the points of two polytopes; in the plane about those that stand for them.
template <class Ask>
auto asked_of_points(const Body& a, const Body& b, const Ask& ask) {
  require_points(a);
  require_points(b);
  if (a.dimension == 3 && b.dimension == 3) return ask(PointSpan(a.points), PointSpan(b.points));
  const Prisms prisms = prisms_of(a, b);
  auto found = ask(PointSpan(prisms.a.points), PointSpan(prisms.b.points));
  map(a, b, found);
  return found;
}

void require_in(unsigned dimension, const std::optional<Point>& p) {
  if (dimension == 2 && p) require_z_0({*p});
}

/// The ball between two further vertices, above and below O, which no body is so near as to reach.
UnitBall raised(UnitBall ball) {
  Vector top{0, 0, 0};
  std::uint32_t next = 0;
  for (const Vector& v : ball.vertices) top.z = std::max<mpz_class>(top.z, abs(v.x));
  for (const std::uint32_t id : ball.input_ids) next = std::max(next, id + 1);
  ball.vertices.insert(ball.vertices.end(), {top, -top});
  ball.input_ids.insert(ball.input_ids.end(), {next, next + 1});
  return ball;
}

}  // namespace

mpq_class height_above(const Body& a, const Body& b) {
  const mpq_class sum = extent_along_x(a) + extent_along_x(b);
  // 2^(bits of the numerator - those of the denominator) is more than half of the sum.
  const auto bits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const long exponent = bits(sum.get_num()) - bits(sum.get_den());
  mpq_class power = 1;
  if (exponent >= 0) mpz_mul_2exp(power.get_num_mpz_t(), power.get_num_mpz_t(), static_cast<unsigned long>(exponent));
  else mpz_mul_2exp(power.get_den_mpz_t(), power.get_den_mpz_t(), static_cast<unsigned long>(-exponent));
  while (power <= sum) power *= 2;
  return power;
}

Prisms prisms_of(const Body& a, const Body& b) {
  if (a.dimension != 2 || b.dimension != 2)
    throw std::invalid_argument("a body of the plane and one of space are given: both must be of one of them");
  if (shapes::is_halfspace(a) || shapes::is_halfspace(b)) return {flat_in_space(a), flat_in_space(b), 0};
  mpq_class height = height_above(a, b);
  Body raised_b = raised(b, height);
  return {a.pieces || b.pieces ? raised(a, height) : flat_in_space(a), std::move(raised_b), std::move(height)};
}

// Prisms that are made higher have the same ways out and the same proof, as all else moves away
// from O.
mpq_class proving_height(const Prisms& prisms, const Answer& of_prisms) {
  mpq_class height = prisms.height > 0 ? prisms.height : mpq_class(1);
  const auto* const depth = std::get_if<SignedDepth>(&of_prisms.found);
  if (depth == nullptr) return height;
  while (height <= depth->radius_a + depth->radius_b || compare(*depth->exact(), height) >= 0) height *= 2;
  return height;
}

std::string certificate_in_plane(const Body& a, const Body& b, const Answer& answer, std::string_view id,
                                 ShapeFormat format, Monitor* monitor) {
  const Prisms prisms = prisms_of(a, b);
  const auto* const shapes = std::get_if<SignedDepth>(&answer.prisms->found);
  const std::string text =
      shapes ? certificate_text(files::shape_of(prisms.a), files::shape_of(prisms.b), *shapes, id, format, monitor)
             : certificate_text(prisms.a, prisms.b, *answer.prisms, id, monitor);
  return certificate::in_plane(text, proving_height(prisms, *answer.prisms), prisms.height > 0);
}

OptimalCone cone_in_plane(OptimalCone cone) {
  if (cone.lineality == Lineality::plane) cone = {Lineality::all, {}, {}};
  return cone;
}

Answer in_plane(const Body& a, const Body& b, Answer of_prisms) {
  auto prisms = std::make_shared<const Answer>(std::move(of_prisms));
  return std::visit([&](const auto& found) { return Answer{mapped(a, b, found), std::move(prisms)}; }, prisms->found);
}

bool is_flat_body(const Body& body) {
  if (body.dimension == 3 && !body.pieces && !body.shape) return is_flat_polytope(body);
  if (body.dimension == 3) return !body.pieces && is_flat(*body.shape);
  if (body.pieces || (body.shape && (body.shape->radius > 0 || shapes::is_halfspace(*body.shape)))) return false;
  bool flat = true;
  for_each_hull(body, [&](const std::vector<Point>& points) {
    const Point& o = points.front();
    const auto other = std::ranges::find_if(points, [&](const Point& p) { return p != o; });
    if (other == points.end()) return;
    const mpq_class x = other->x - o.x, y = other->y - o.y;
    flat = std::ranges::all_of(points, [&](const Point& p) { return x * (p.y - o.y) == y * (p.x - o.x); });
  });
  return flat;
}

}  // namespace fathom::answer

namespace fathom {

using answer::asked_of_points;
using answer::PointSpan;

DirectionalDepth directional_depth(const Body& a, const Body& b, const Point& direction, Monitor* monitor) {
  answer::require_in(a.dimension, direction);
  return asked_of_points(
      a, b, [&](PointSpan of_a, PointSpan of_b) { return directional_depth(of_a, of_b, direction, monitor); });
}

GrowthDistance growth_distance(const Body& a, const Body& b, const std::optional<Point>& center_a,
                               const std::optional<Point>& center_b, Monitor* monitor) {
  answer::require_in(a.dimension, center_a);
  answer::require_in(a.dimension, center_b);
  return asked_of_points(
      a, b, [&](PointSpan of_a, PointSpan of_b) { return growth_distance(of_a, of_b, center_a, center_b, monitor); });
}

// Of the vertices of a prism those that stand first are at its lower end.
UnitBall unit_ball(const Body& body) {
  answer::require_points(body);
  if (body.dimension == 3) return unit_ball(PointSpan(body.points));
  if (answer::is_flat_body(body)) throw NoUnitBall("the unit ball is flat: its points lie on one line");
  UnitBall ball = unit_ball(PointSpan(answer::raised(body, 1).points));
  ball.vertices.resize(ball.vertices.size() / 2);
  ball.input_ids.resize(ball.vertices.size());
  for (Vector& v : ball.vertices) v.z = 0;
  ball.dimension = 2;
  return ball;
}

MetricResult metric_depth(const Body& a, const Body& b, const UnitBall& ball, Monitor* monitor) {
  if (ball.dimension != a.dimension)
    throw std::invalid_argument("the bodies and the unit ball must be all of the plane, or all of space");
  const UnitBall in_space = ball.dimension == 2 ? answer::raised(ball) : ball;
  return asked_of_points(a, b,
                         [&](PointSpan of_a, PointSpan of_b) { return metric_depth(of_a, of_b, in_space, monitor); });
}

ApproxDepth approx_depth(const Body& a, const Body& b, const mpq_class& delta, Monitor* monitor) {
  return asked_of_points(a, b,
                         [&](PointSpan of_a, PointSpan of_b) { return approx_depth(of_a, of_b, delta, monitor); });
}

// Half of the rays suffice for a prism and itself.
ApproxDepth approx_width(const Body& body, const mpq_class& delta, Monitor* monitor) {
  ApproxDepth found =
      asked_of_points(body, body, [&](PointSpan, PointSpan of_b) { return approx_width(of_b, delta, monitor); });
  found.extreme_a = found.extreme_b;
  ApproxPenetration* const inside = std::get_if<ApproxPenetration>(&found.outcome);
  if (body.dimension == 2 && inside && inside->witness) inside->witness->a.z = inside->witness->b.z = 0;
  return found;
}

Body in_plane(Body body) {
  if (body.solid) throw std::invalid_argument("the solid of a mesh is no body of the plane");
  if (body.shape) {
    shapes::require_shape(*body.shape);
    Shape shape = shapes::simplified(*body.shape);
    if (const HalfSpace* const half = std::get_if<HalfSpace>(&shape.core)) {
      answer::require_z_0({half->normal});
    } else {
      const auto points = shapes::polytope_points(shape, most_expanded_points);
      if (!points) throw std::invalid_argument("the core of a body of the plane is a polygon, found a curved one");
      shape.core = hull(*points).core;
    }
    body.shape = std::move(shape);
  }
  answer::for_each_hull(body, answer::require_z_0);
  body.words = nullptr;
  body.faces = nullptr;
  body.dimension = 2;
  return body;
}

}  // namespace fathom
