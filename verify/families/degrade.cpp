// SPDX-License-Identifier: GPL-3.0-or-later
// The ways of breaking general position, each a function on a pair of bodies; then pairs that are
// nearly broken.

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/random.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {
namespace {

/// Edges and facets in no particular order. A polygon has two facets, one with each of its normals.
struct Features {
  std::vector<Point> vertices;
  std::vector<std::pair<Point, Point>> edges;  ///< ends
  std::vector<Point> edge_directions;          ///< of each edge
  std::vector<Point> normals;                  ///< of each facet
  std::vector<std::vector<Point>> facets;      ///< corners of each facet
  std::vector<std::pair<Point, Point>> arcs;   ///< the two normals beside each edge that has two facets
};

template <class Map>
Body points_mapped(Body body, Map map) {
  for (Point& p : body.points.edit()) p = map(p);
  return body;
}

Features features(const Body& body) {
  const polytope::Polytope hull = polytope::hull_of(body.points);
  const auto vertex = [&](polytope::VertexId v) { return body.points[hull.input_ids[v]]; };
  Features result;
  for (const polytope::VertexId v : hull.vertices.ids()) result.vertices.push_back(vertex(v));
  for (const polytope::Facet& facet : hull.facets) {
    result.normals.push_back(rational(facet.normal));
    std::vector<Point>& corners = result.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(vertex(hull.corners[i]));
  }
  for (const polytope::Edge& edge : hull.edges) {
    result.edges.emplace_back(vertex(edge.from), vertex(edge.to));
    result.edge_directions.push_back(result.edges.back().second - result.edges.back().first);
    if (hull.rank == 3)
      result.arcs.emplace_back(rational(hull.facets[edge.left].normal), rational(hull.facets[edge.right].normal));
  }
  return result;
}

/// The projection of p on the line along `direction`; and into the plane across `normal`.
Point along(const Point& p, const Point& direction) {
  return (dot(p, direction) / dot(direction, direction)) * direction;
}
Point across(const Point& p, const Point& normal) { return p - along(p, normal); }

/// The linear map that takes the direction `from` to its projection on the line of `to`, and is the
/// identity across `from`: edges with direction `from` become parallel to `to`. <from, to> must not
/// be 0.
// x + (to' - from) <from, x> / <from, from>, where to' is the projection of `from` on `to`: takes
// `from` to to', and its determinant is cos^2 of the angle between the two.
Body edge_aligned(const Body& body, const Point& from, const Point& to) {
  const Point step = along(from, to) - from;
  const mpq_class square = dot(from, from);
  return points_mapped(body, [&](const Point& p) { return p + (dot(from, p) / square) * step; });
}

/// The linear map after which facets with the outward normal `from` have one along `to`, or against
/// it if <from, to> < 0. <from, to> must not be 0.
// The normals' map is the one of edge_aligned; the points' map is its inverse transposed: x - from
// <to' - from, x> / <from, to'>.
Body normal_aligned(const Body& body, const Point& from, const Point& to) {
  const Point target = along(from, to), step = target - from;
  const mpq_class scale = dot(from, target);
  return points_mapped(body, [&](const Point& p) { return p - (dot(step, p) / scale) * from; });
}

/// How well two directions agree: cos^2 of their angle with the sign of the cosine. Neither may be
/// 0.
mpq_class agreement(const Point& p, const Point& q) {
  const mpq_class cosine = dot(p, q);
  const mpq_class squared = cosine * cosine / (dot(p, p) * dot(q, q));
  return sgn(cosine) < 0 ? mpq_class(-squared) : squared;
}

// ---- ways that add, move or drop points ----

Point between(const Point& p, const Point& q, const mpq_class& share) { return (1 - share) * p + share * q; }

Point centre(const Body& body) {
  Point sum;
  for (const Point& p : body.points) sum = sum + p;
  return ratio(1, mpz_class(body.points.size())) * sum;
}

Body flattened(const Body& body, Random& random) {
  const Features shape = features(body);
  if (shape.facets.empty()) return body;
  const std::size_t chosen =
      static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(shape.facets.size()) - 1));
  const Point normal = shape.normals[chosen], foot = shape.facets[chosen].front();
  Body result;
  for (const Point& p : body.points) result.points.push_back(foot + across(p - foot, normal));
  return result;
}

Body reflected_half(const Body& body) {
  Body result = body;
  const std::size_t half = (body.points.size() + 1) / 2;
  result.points.edit().resize(std::min(body.points.size(), std::max<std::size_t>(3, half)));
  for (std::size_t i = 0, given = result.points.size(); i < given; ++i) {
    const Point p = result.points[i];
    result.points.push_back(-p);
  }
  return result;
}

/// The largest difference of two x, of two y or of two z.
mpq_class extent(const Bodies& bodies) {
  mpq_class most = 0;
  for (mpq_class Point::*axis : {&Point::x, &Point::y, &Point::z}) {
    mpq_class low = bodies.a.points.front().*axis, high = low;
    for (const Body* body : {&bodies.a, &bodies.b})
      for (const Point& p : body->points) {
        low = std::min(low, p.*axis);
        high = std::max(high, p.*axis);
      }
    most = std::max(most, mpq_class(high - low));
  }
  return most;
}

/// Returns the nearest multiple of 2^exponent, of two the higher one.
mpq_class snapped(const mpq_class& x, long exponent) {
  const mpq_class steps = times_power_of_two(x, -exponent) + ratio(1, 2);
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  return times_power_of_two(whole, exponent);
}

void duplicate_points(Bodies& bodies, Random& random) {
  for (Body* body : {&bodies.a, &bodies.b}) {
    const std::vector<Point> given = body->points;
    body->points.push_back(any_of(given, random));
    for (const Point& p : given)
      if (random.between(0, 3) == 0) body->points.push_back(p);
  }
}

void collinear_points(Bodies& bodies, Random& random) {
  for (Body* body : {&bodies.a, &bodies.b}) {
    const Features shape = features(*body);
    for (int i = 0; i < 2 && !shape.edges.empty(); ++i) {
      const auto& [from, to] = any_of(shape.edges, random);
      body->points.push_back(between(from, to, ratio(random.between(1, 7), 8)));
    }
  }
}

// A triangle p q r gets the fourth corner of a parallelogram: in the facet's plane, so it stays a
// facet.
void coplanar_points(Bodies& bodies, Random& random) {
  for (Body* body : {&bodies.a, &bodies.b}) {
    const Features shape = features(*body);
    if (shape.facets.empty()) continue;
    const std::vector<Point>& corners = any_of(shape.facets, random);
    if (corners.size() == 3) body->points.push_back(corners[0] + corners[2] - corners[1]);
    body->points.push_back(
        between(between(corners[0], corners[1], ratio(random.between(1, 3), 4)), corners[2], ratio(1, 2)));
  }
}

void flattened_body(Bodies& bodies, Random& random) {
  const std::int64_t which = random.between(0, 2);
  if (which != 1) bodies.a = flattened(bodies.a, random);
  if (which != 0) bodies.b = flattened(bodies.b, random);
}

void identical_bodies(Bodies& bodies, Random&) { bodies.b = bodies.a; }

void tie_by_reflection(Bodies& bodies, Random&) {
  bodies.a = reflected_half(bodies.a);
  bodies.b = reflected_half(bodies.b);
}

// Bodies that do not meet get a common centre first.
void touching_translation(Bodies& bodies, Random&) {
  Depth depth = penetration_depth(bodies.a.points, bodies.b.points);
  if (depth.status() == Status::disjoint) {
    bodies.a = translated(bodies.a, centre(bodies.b) - centre(bodies.a));
    depth = penetration_depth(bodies.a.points, bodies.b.points);
  }
  bodies.a = translated(bodies.a, depth.translation());
}

void snapped_to_lattice(Bodies& bodies, Random&) {
  const mpq_class size = extent(bodies);
  if (sgn(size) == 0) return;
  const long unit = kernels::binary_order(size) - 3;
  for (Body* body : {&bodies.a, &bodies.b})
    for (Point& p : body->points.edit()) p = {snapped(p.x, unit), snapped(p.y, unit), snapped(p.z, unit)};
}

// ---- ways that turn a feature of a body until it coincides with another one, or with the chart's
// frame ----

constexpr std::size_t window =
    24;  // at most this many features of a body are searched, since pairs of them are compared

const Point pole{0, 0, 1}, y_axis{0, 1, 0};

/// Returns `window` successive members from a random place on; a short list whole, rotated.
template <class T>
std::vector<T> some(std::vector<T> list, Random& random) {
  if (list.empty()) return list;
  const auto start = random.between(0, static_cast<std::int64_t>(list.size()) - 1);
  std::rotate(list.begin(), list.begin() + start, list.end());
  list.resize(std::min(list.size(), window));
  return list;
}

std::vector<Point> with_negatives(std::vector<Point> list) {
  for (std::size_t i = 0, given = list.size(); i < given; ++i) {
    const Point p = list[i];
    list.push_back(-p);
  }
  return list;
}

std::vector<Point> negated(const std::vector<Point>& list) {
  std::vector<Point> result;
  for (const Point& p : list) result.push_back(-p);
  return result;
}

/// A direction, and the direction to turn it to.
struct Turn {
  Point from, to;
};

/// Returns the direction that is closest to its target, or nullopt if no target is in reach.
template <class Target>
std::optional<Turn> smallest_turn(const std::vector<Point>& directions, Target target) {
  std::optional<Turn> best;
  mpq_class most = 0;
  for (const Point& from : directions) {
    const Point to = target(from);
    if (to == Point{}) continue;
    if (const mpq_class here = agreement(from, to); here > most) {
      most = here;
      best = Turn{from, to};
    }
  }
  return best;
}

/// The pair of directions, one of A and one of B, that agrees best, as a turn of A's; nullopt if no
/// agreement is positive.
// Agreements depend on no length: those of primitive integers are compared without a division.
std::optional<Turn> smallest_turn(const std::vector<Point>& of_a, const std::vector<Point>& of_b) {
  std::vector<Vector> primitive_of_b;
  for (const Point& to : of_b) primitive_of_b.push_back(primitive_along(to));
  std::optional<Turn> best;
  mpz_class most = 0, least = 1;  // cos^2 is a fraction of these
  for (const Point& from : of_a) {
    const Vector u = primitive_along(from);
    const mpz_class square = dot(u, u);
    for (std::size_t k = 0; k < of_b.size(); ++k) {
      const Vector& v = primitive_of_b[k];
      mpz_class cosine = dot(u, v);
      if (cosine <= 0) continue;
      cosine *= cosine;
      const mpz_class squares = square * dot(v, v);
      if (cosine * least <= most * squares) continue;
      most = cosine;
      least = squares;
      best = Turn{from, of_b[k]};
    }
  }
  return best;
}

template <class Target>
void turn_normals(Bodies& bodies, Random& random, Target target) {
  for (Body* body : {&bodies.a, &bodies.b})
    if (const auto turn = smallest_turn(some(features(*body).normals, random), target))
      *body = normal_aligned(*body, turn->from, turn->to);
}

template <class Target>
void turn_edges(Bodies& bodies, Random& random, Target target) {
  for (Body* body : {&bodies.a, &bodies.b})
    if (const auto turn = smallest_turn(some(features(*body).edge_directions, random), target))
      *body = edge_aligned(*body, turn->from, turn->to);
}

/// Turns A, and returns B's direction.
std::optional<Point> turn_normal_of_a(Bodies& bodies, const std::vector<Point>& of_a, const std::vector<Point>& of_b) {
  const auto turn = smallest_turn(of_a, of_b);
  if (!turn) return std::nullopt;
  bodies.a = normal_aligned(bodies.a, turn->from, turn->to);
  return turn->to;
}

std::vector<Point> normals(const Body& body, Random& random) { return some(features(body).normals, random); }

mpq_class reach(const Body& body, const Point& u) {
  mpq_class most = dot(u, body.points.front());
  for (const Point& p : body.points) most = std::max(most, dot(u, p));
  return most;
}

/// The axis nearest to p, with its sign.
Point nearest_axis(const Point& p) {
  const mpq_class x = abs(p.x), y = abs(p.y), z = abs(p.z);
  if (x >= y && x >= z) return {sgn(p.x), 0, 0};
  return y >= z ? Point{0, sgn(p.y), 0} : Point{0, 0, sgn(p.z)};
}

void shared_vertex(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = some(features(bodies.a).vertices, random),
                           of_b = some(features(bodies.b).vertices, random);
  bodies.a = translated(bodies.a, of_b.front() - of_a.front());
}

void shared_edge_direction(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = some(features(bodies.a).edge_directions, random);
  const std::vector<Point> of_b = with_negatives(some(features(bodies.b).edge_directions, random));
  if (const auto turn = smallest_turn(of_a, of_b)) bodies.a = edge_aligned(bodies.a, turn->from, turn->to);
}

void shared_facet_normal(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random), of_b = normals(bodies.b, random);
  turn_normal_of_a(bodies, of_a, of_b);
}

void opposite_facet_normals(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random), of_b = negated(normals(bodies.b, random));
  turn_normal_of_a(bodies, of_a, of_b);
}

void coplanar_facets(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random), of_b = normals(bodies.b, random);
  const std::optional<Point> normal = turn_normal_of_a(bodies, of_a, of_b);
  if (!normal) return;
  const mpq_class missing = reach(bodies.b, *normal) - reach(bodies.a, *normal);
  bodies.a = translated(bodies.a, (missing / dot(*normal, *normal)) * (*normal));
}

void axis_aligned_facet(Bodies& bodies, Random& random) { turn_normals(bodies, random, nearest_axis); }

void normal_at_pole(Bodies& bodies, Random& random) {
  turn_normals(bodies, random, [](const Point& n) { return along(n, pole); });
}

void normal_on_equator(Bodies& bodies, Random& random) {
  turn_normals(bodies, random, [](const Point& n) { return across(n, pole); });
}

void arc_on_equator(Bodies& bodies, Random& random) {
  turn_edges(bodies, random, [](const Point& d) { return along(d, pole); });
}

void vertical_edge(Bodies& bodies, Random& random) {
  turn_edges(bodies, random, [](const Point& d) { return across(d, y_axis); });
}

// The great circle through v and a node m of B has the normal m x v; -A's node -n lies on it if n
// does.
void nodes_on_one_vertical(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random);
  std::optional<Turn> best;
  for (const Point& m : normals(bodies.b, random)) {
    const Point circle = cross(m, y_axis);
    if (circle == Point{}) continue;
    const auto turn = smallest_turn(of_a, [&](const Point& n) { return across(n, circle); });
    if (turn && (!best || agreement(turn->from, turn->to) > agreement(best->from, best->to))) best = turn;
  }
  if (best) bodies.a = normal_aligned(bodies.a, best->from, best->to);
}

void normal_on_arc(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random);
  std::vector<Point> middles;
  for (const auto& [left, right] : some(features(bodies.b).arcs, random)) middles.push_back(-left - right);
  turn_normal_of_a(bodies, of_a, middles);
}

// ---- the table of all ways ----

constexpr DegradationName names[] = {
    {Degradation::duplicate_points, "duplicate_points", "some points are given again"},
    {Degradation::collinear_points, "collinear_points", "points inside edges"},
    {Degradation::coplanar_points, "coplanar_points", "a facet with four corners or more, and a point inside it"},
    {Degradation::shared_vertex, "shared_vertex", "a vertex of A is a vertex of B"},
    {Degradation::shared_edge_direction, "shared_edge_direction", "an edge of A is parallel to an edge of B"},
    {Degradation::shared_facet_normal, "shared_facet_normal", "a facet of A and one of B have the same normal"},
    {Degradation::opposite_facet_normals, "opposite_facet_normals", "a facet of A and one of B have opposite normals"},
    {Degradation::coplanar_facets, "coplanar_facets",
     "a facet of A and one of B lie in one plane, on the same side of it"},
    {Degradation::axis_aligned_facet, "axis_aligned_facet", "each body has a facet across a coordinate axis"},
    {Degradation::normal_at_pole, "normal_at_pole", "each body has a facet with the normal (0, 0, 1) or (0, 0, -1)"},
    {Degradation::normal_on_equator, "normal_on_equator", "each body has a facet whose normal has z = 0"},
    {Degradation::arc_on_equator, "arc_on_equator", "each body has an edge parallel to the z-axis"},
    {Degradation::vertical_edge, "vertical_edge",
     "each body has an edge with y = 0 in its direction: its arc stands upright in the chart"},
    {Degradation::nodes_on_one_vertical, "nodes_on_one_vertical",
     "a node of each Gaussian diagram on one vertical of the chart"},
    {Degradation::normal_on_arc, "normal_on_arc", "a node of -A in the middle of an arc of B"},
    {Degradation::flattened_body, "flattened_body", "A, B or both are projected into the plane of a facet"},
    {Degradation::identical_bodies, "identical_bodies", "B = A"},
    {Degradation::tie_by_reflection, "tie_by_reflection",
     "both bodies are symmetric about O: every optimum has an opposite one"},
    {Degradation::touching_translation, "touching_translation",
     "A is moved by its exact translation: the bodies touch"},
    {Degradation::snapped_to_lattice, "snapped_to_lattice", "coordinates are rounded to a coarse grid"},
};

/// In the order of the enumeration.
constexpr void (*ways[])(Bodies& bodies, Random& random) = {
    duplicate_points,    collinear_points,       coplanar_points,   shared_vertex,         shared_edge_direction,
    shared_facet_normal, opposite_facet_normals, coplanar_facets,   axis_aligned_facet,    normal_at_pole,
    normal_on_equator,   arc_on_equator,         vertical_edge,     nodes_on_one_vertical, normal_on_arc,
    flattened_body,      identical_bodies,       tie_by_reflection, touching_translation,  snapped_to_lattice,
};
static_assert(std::size(ways) == std::size(names));

}  // namespace

std::span<const DegradationName> degradations() { return names; }

Case degrade(const Case& generic, Degradation way, std::uint64_t seed) {
  Random random(seed);
  Bodies bodies{generic.a, generic.b};
  const auto index = static_cast<std::size_t>(way);
  ways[index](bodies, random);
  return {generic.id + "-" + std::string(names[index].name), std::move(bodies.a), std::move(bodies.b)};
}

// ---- pairs that are nearly broken, and families of broken ones ----

Case approach(const Case& degenerate, unsigned k, std::uint64_t seed) {
  Case result = degenerate;
  result.id += "-k" + std::to_string(k) + "-s" + std::to_string(seed);
  Random random(seed);
  for (Body* body : {&result.a, &result.b})
    for (Point& p : body->points.edit())
      for (mpq_class* x : {&p.x, &p.y, &p.z})
        *x += times_power_of_two(random_dyadic(random, -1, 1, 20), -static_cast<long>(k));
  return result;
}

Bodies from_catalogue(Random& random, unsigned) {
  const Case& pair = any_of(catalogue(), random).pair;
  return {pair.a, pair.b};
}

Bodies approaching_catalogue(Random& random, unsigned) {
  constexpr std::size_t small = 16;
  const auto any_entry = [&random] { return &any_of(catalogue(), random).pair; };
  const Case* pair = any_entry();
  while (pair->a.points.size() > small || pair->b.points.size() > small) pair = any_entry();
  const auto k = static_cast<unsigned>(random.between(4, 200));
  Case near = approach(*pair, k, random.next());
  return {std::move(near.a), std::move(near.b)};
}

Bodies degraded(Degradation way, Random& random, unsigned n) {
  Bodies generic = random_sphere(random, std::max(4u, n));
  Case broken = degrade({"", std::move(generic.a), std::move(generic.b)}, way, random.next());
  return {std::move(broken.a), std::move(broken.b)};
}

Bodies approaching_degraded(Random& random, unsigned n) {
  const Degradation way = any_of(degradations(), random).way;
  const Bodies broken = degraded(way, random, n);
  const auto k = static_cast<unsigned>(random.between(4, 200));
  Case near = approach({"", broken.a, broken.b}, k, random.next());
  return {std::move(near.a), std::move(near.b)};
}

}  // namespace fathom::families
