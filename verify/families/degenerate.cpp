// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs made from their contact, and degenerate pairs.

#include <algorithm>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

// ---- contacts ----

namespace {

/// A direction in the plane with rational components: the angle 2 atan(t).
struct PlaneDirection {
  mpq_class x, y;
};

PlaneDirection plane_direction(const mpq_class& t) {
  const mpq_class norm = 1 + t * t;
  return {mpq_class((1 - t * t) / norm), mpq_class(2 * t / norm)};
}

/// In [1/2, 2].
mpq_class random_reach(Random& random) { return ratio(random.between(16, 64), 32); }

void add(Body& body, const PlaneDirection& direction, const mpq_class& length) {
  body.points.push_back({mpq_class(length * direction.x), mpq_class(length * direction.y), 0});
}

/// A vertex at O, an edge with O inside, or a polygon of 3 to 6 corners with O inside; in z = 0,
/// within a distance of 2.
Body feature_body(FeatureKind feature, const PlaneDirection& edge, Random& random) {
  Body body;
  if (feature == FeatureKind::vertex) body.points.push_back({0, 0, 0});
  if (feature == FeatureKind::edge) {
    add(body, edge, random_reach(random));
    add(body, edge, mpq_class(-random_reach(random)));
  }
  if (feature == FeatureKind::face) {
    // Angles of 0 and about +-120 degrees: O is inside whatever the lengths, and more corners do no
    // harm.
    const PlaneDirection first = plane_direction(0), second = plane_direction(ratio(7, 4)),
                         third = plane_direction(ratio(-7, 4));
    for (const PlaneDirection* direction : {&first, &second, &third}) add(body, *direction, random_reach(random));
    for (std::int64_t more = random.between(0, 3); more > 0; --more) {
      const mpq_class t = ratio(random.between(-32, 32), 8);
      add(body, plane_direction(t), random_reach(random));
    }
  }
  return body;
}

/// Adds a base around z = -4 that is wider than any feature.
void add_base(Body& body, Random& random, unsigned n) {
  for (unsigned i = 0; i < std::max(4u, n); ++i) {
    const int x = i % 2 ? 1 : -1, y = i / 2 % 2 ? 1 : -1;  // the four quadrants in turn
    const mpq_class across = random_reach(random), along = random_reach(random), down = random_reach(random);
    body.points.push_back({mpq_class(x * (3 + across)), mpq_class(y * (3 + along)), mpq_class(-3 - down)});
  }
}

/// B below z = 0, A above z = -overlap.
Bodies facing(FeatureKind a, FeatureKind b, const PlaneDirection& edge_a, const PlaneDirection& edge_b,
              const mpq_class& overlap, Random& random, unsigned n) {
  Body upper = feature_body(a, edge_a, random);
  add_base(upper, random, n);
  upper = translated(scaled(upper, 1, 1, -1), {0, 0, mpq_class(-overlap)});
  Body lower = feature_body(b, edge_b, random);
  add_base(lower, random, n);
  return {upper, lower};
}

/// Turns both bodies by a random rotation; sometimes by none, so that features lie in coordinate
/// planes.
Bodies turned(const Bodies& bodies, Random& random) {
  const bool stays = random.between(0, 3) == 0;
  return stays ? bodies : rotated(bodies, random_rotation(random));
}

Bodies apart(FeatureKind a, FeatureKind b, const mpq_class& overlap, Random& random, unsigned n) {
  const PlaneDirection edge_a =
      plane_direction(ratio(random.between(-4, 4), 16));  // within about 28 degrees of the x-axis
  const PlaneDirection edge_b = plane_direction(ratio(random.between(12, 20), 16));  // and of the y-axis
  return turned(facing(a, b, edge_a, edge_b, overlap, random, n), random);
}

}  // namespace

Bodies touching(FeatureKind a, FeatureKind b, Random& random, unsigned n) { return apart(a, b, 0, random, n); }

Bodies touching_parallel_edges(Random& random, unsigned n) {
  const PlaneDirection edge = plane_direction(ratio(random.between(-16, 16), 16));
  return turned(facing(FeatureKind::edge, FeatureKind::edge, edge, edge, 0, random, n), random);
}

Bodies overlapping(FeatureKind a, FeatureKind b, Random& random, unsigned n) {
  const mpq_class overlap = times_power_of_two(1, -random.between(4, 40));
  return apart(a, b, overlap, random, n);
}

Bodies nearly_touching(Random& random, unsigned n) {
  constexpr FeatureKind kinds[] = {FeatureKind::vertex, FeatureKind::edge, FeatureKind::face};
  const FeatureKind a = kinds[random.between(0, 2)], b = kinds[random.between(0, 2)];
  const mpq_class size = times_power_of_two(1, -random.between(4, 60));
  const bool overlap = random.coin();
  return apart(a, b, overlap ? size : mpq_class(-size), random, n);
}

// ---- faces on faces, in doubles ----

namespace {

/// A box, a prism or a hull below z = 0, with a face in z = 0 and O inside it.
Body under_a_face(Random& random, unsigned n) {
  const std::int64_t kind = random.between(0, 2);
  if (kind == 0) {
    Body hull = feature_body(FeatureKind::face, plane_direction(0), random);
    add_base(hull, random, n);
    return hull;
  }
  const mpq_class x = random_reach(random), y = random_reach(random), z = random_reach(random);
  const Body solid = kind == 1 ? box(x, y, z) : scaled(prism(std::max(3u, n / 2), z), x, y, 1);
  return translated(solid, {0, 0, mpq_class(-z)});
}

/// A point inside the face of such a body, which is convex: at most 3/4 of the way from O to one of
/// its corners, and as far again towards another.
Point inside_face(const Body& body, Random& random) {
  std::vector<Point> corners;
  for (const Point& p : body.points)
    if (p.z == 0) corners.push_back(p);
  const Point& first = any_of(corners, random);
  const Point& second = any_of(corners, random);
  return ratio(random.between(0, 12), 32) * (first + second);
}

/// Turned about the line through O along a unit vector in z = 0, by the angle 2 atan(t / 2).
Body tilted(const Body& body, const PlaneDirection& axis, const mpq_class& t) {
  const mpq_class half = t / 2, norm = 1 + half * half, cosine = (1 - half * half) / norm, sine = t / norm;
  const Point u{axis.x, axis.y, 0};
  Body result;
  for (const Point& p : body.points.exact())
    result.points.push_back(cosine * p + sine * cross(u, p) + mpq_class((1 - cosine) * dot(u, p)) * u);
  return result;
}

Body in_doubles(const Body& body) {
  const auto nearest = [](const mpq_class& x) { return exact_value(round_binary64(x)); };
  Body result;
  for (const Point& p : body.points.exact()) result.points.push_back({nearest(p.x), nearest(p.y), nearest(p.z)});
  return result;
}

}  // namespace

Bodies faces(const mpq_class& tilt, Random& random, unsigned n) {
  const Body lower = under_a_face(random, n);
  const Body upper = scaled(under_a_face(random, n), 1, 1, -1);
  const mpq_class depth = times_power_of_two(1, -random.between(5, 10));
  const Point place = inside_face(lower, random) - Point{0, 0, depth};
  const PlaneDirection axis = plane_direction(ratio(random.between(-16, 16), 16));
  const mpq_class angle = random.coin() ? tilt : mpq_class(-tilt);
  Bodies bodies{translated(tilted(upper, axis, angle), place), lower};
  // Along the axes of coordinates parallel faces stay parallel, in doubles too.
  const std::int64_t turn = random.between(0, 2);
  if (turn > 0) bodies = rotated(bodies, turn == 1 ? rotation(1, 1, 0, 0) : rotation(1, 0, 1, 0));
  if (random.coin()) bodies = rotated(bodies, rotation(0, 1, 1, 0));
  const Point origin = random_shift(random, 4);
  return {in_doubles(translated(bodies.a, origin)), in_doubles(translated(bodies.b, origin))};
}

// ---- ties, shared features, flat bodies, extreme coordinates ----

namespace {

/// Returns a vector whose components are at most 1 / divisor.
Point small_shift(Random& random, long divisor) { return ratio(1, divisor) * random_shift(random, 1); }

Body random_box(Random& random) {
  const std::int64_t x = random.between(1, 3), y = random.between(1, 3), z = random.between(1, 3);
  return box(x, y, z);
}

/// A platonic solid, a prism, an antiprism or a box, turned.
Body symmetric_solid(Random& random, unsigned n) {
  const std::int64_t kind = random.between(0, 7);
  const unsigned corners = std::max(3u, n / 2);
  Body body;
  if (kind < 5) body = platonic(static_cast<unsigned>(kind));
  else if (kind == 5) body = prism(corners, ratio(random.between(1, 8), 4));
  else if (kind == 6) body = antiprism(corners, ratio(random.between(1, 8), 4));
  else body = random_box(random);
  return random.coin() ? body : rotated(body, random_rotation(random));
}

Point small_lattice_point(Random& random) {
  return {random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
}

bool parallel(const Point& p, const Point& q) {
  return p.x * q.y == p.y * q.x && p.y * q.z == p.z * q.y && p.z * q.x == p.x * q.z;
}

/// Two independent integer directions.
std::vector<Point> two_directions(Random& random) {
  std::vector<Point> chosen;
  while (chosen.size() < 2) {
    const Point d = small_lattice_point(random);
    const bool independent = d != Point{} && (chosen.empty() || !parallel(d, chosen.front()));
    if (independent) chosen.push_back(d);
  }
  return chosen;
}

/// At least rank + 1 points, the first ones affinely independent. A segment runs along the first of
/// the two axes, a polygon along both.
Body flat_body(int rank, std::vector<Point> axes, Random& random, unsigned n) {
  if (rank == 3) {
    Body body = random_lattice_body(random, n);
    for (Point corner : {Point{0, 0, 0}, Point{3, 0, 0}, Point{0, 3, 0}, Point{0, 0, 3}}) body.points.push_back(corner);
    return body;
  }
  const Point origin{random.between(0, 3), random.between(0, 3), random.between(0, 3)};
  axes.resize(static_cast<std::size_t>(rank));
  Body body{{origin}};
  for (const Point& axis : axes) body.points.push_back(origin + axis);
  const unsigned total =
      rank == 0 ? 1 + static_cast<unsigned>(random.between(0, 1)) : std::max(n, static_cast<unsigned>(rank) + 1);
  while (body.points.size() < total) {
    Point p = origin;
    for (const Point& axis : axes) p = p + random.between(-2, 2) * axis;
    body.points.push_back(p);
  }
  return body;
}

/// A point of the body, or halfway between two of them.
Point some_point(const Body& body, Random& random) {
  const std::int64_t last = static_cast<std::int64_t>(body.points.size()) - 1;
  const Point& p = body.points[static_cast<std::size_t>(random.between(0, last))];
  const Point& q = body.points[static_cast<std::size_t>(random.between(0, last))];
  return random.coin() ? p : p + ratio(1, 2) * (q - p);
}

constexpr long far = 996;  // 2^996 is just below 1e300

}  // namespace

Bodies exact_ties(Random& random, unsigned n) {
  const Body body = symmetric_solid(random, n);
  return {body, body};
}

Bodies near_ties(Random& random, unsigned n) {
  const Body body = symmetric_solid(random, n);
  const mpq_class gap = times_power_of_two(1, -random.between(10, 200));
  Point direction = small_lattice_point(random);
  while (direction == Point{}) direction = small_lattice_point(random);
  return {body, translated(body, gap * direction)};
}

Bodies near_tie_boxes(Random& random, unsigned) {
  const mpq_class y_gap = times_power_of_two(1, -random.between(10, 60)),
                  z_gap = times_power_of_two(1, -random.between(10, 60));
  const Body a = box(2, 2, 2);
  const Body b = random_box(random);
  // B's lowest corner (b starts at minus its half extents) goes to A's highest, less the wanted
  // depths.
  const Point lowest = b.points.front();
  const Point shift{mpq_class(2 - 1 - lowest.x), mpq_class(2 - 1 - y_gap - lowest.y),
                    mpq_class(2 - 1 - z_gap - lowest.z)};
  return rotated(Bodies{a, translated(b, shift)}, random_rotation(random));
}

Bodies identical(Random& random, unsigned n) {
  const Body body = random_ball_body(random, n);
  return {body, body};
}

Bodies mirrored(Random& random, unsigned n) {
  const Body ball = random_ball_body(random, n);
  const Body body = translated(ball, small_shift(random, 4));
  return {body, scaled(body, -1)};
}

Bodies nested(Random& random, unsigned n) {
  const Body body = random_sphere_body(random, n);
  const Body inner = scaled(body, ratio(random.between(4, 12), 16));
  return {body, translated(inner, small_shift(random, 8))};
}

Bodies common_normals(Random& random, unsigned n) {
  const Body body = random_sphere_body(random, n);
  const mpq_class factor = ratio(random.between(4, 32), 16);
  const Body copy = scaled(body, random.coin() ? factor : mpq_class(-factor));
  return {body, translated(copy, small_shift(random, 2))};
}

Bodies parallel_edges(Random& random, unsigned n) {
  const unsigned corners = std::max(3u, n / 2);
  const Body a = prism(corners, ratio(random.between(2, 8), 4));
  const mpq_class half_height = ratio(random.between(2, 8), 4);
  const unsigned phase = static_cast<unsigned>(random.between(0, 3));
  const Body b = prism(random.coin() ? corners : corners + 1, half_height, phase);
  const Point shift = random_shift(random, 1);
  return rotated(Bodies{a, translated(b, shift)}, random_rotation(random));
}

Bodies redundant_points(Random& random, unsigned n) {
  Bodies bodies = random_lattice(random, n);
  for (Body* body : {&bodies.a, &bodies.b}) {
    const std::size_t given = body->points.size();
    const auto any = [&] {
      return body->points[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(given) - 1))];
    };
    for (std::size_t i = 0; i < given; ++i) {
      const Point p = any(), q = any(), r = any();
      const Point middle = p + ratio(1, 2) * (q - p);
      const Point deeper = middle + ratio(1, 3) * (r - middle);
      body->points.push_back(i % 3 == 0 ? p : i % 3 == 1 ? middle : deeper);
    }
    std::ranges::reverse(body->points.edit());
  }
  return bodies;
}

Bodies flat(int rank_a, int rank_b, Random& random, unsigned n) {
  const std::vector<Point> axes = two_directions(random), others = two_directions(random);
  const Body a = flat_body(rank_a, axes, random, n);
  const Body b = flat_body(rank_b, random.coin() ? axes : others, random, n);
  if (random.between(0, 3) == 0) return {a, b};
  const Point meet = some_point(a, random), at = some_point(b, random);
  return {a, translated(b, meet - at)};
}

Bodies tiny_coordinates(Random& random, unsigned n) {
  const Bodies bodies = random_sphere(random, n);
  const mpq_class unit = times_power_of_two(1, -far);
  return {scaled(bodies.a, unit), scaled(bodies.b, unit)};
}

Bodies huge_coordinates(Random& random, unsigned n) {
  const Bodies bodies = random_sphere(random, n);
  const mpq_class unit = times_power_of_two(1, far - 1);  // coordinates up to 2
  return {scaled(bodies.a, unit), scaled(bodies.b, unit)};
}

Bodies uneven_coordinates(Random& random, unsigned n) {
  const Bodies bodies = random_sphere(random, n);
  const mpq_class large = times_power_of_two(1, far - 1), small = times_power_of_two(1, -far);
  return {scaled(bodies.a, large, 1, small), scaled(bodies.b, large, 1, small)};
}

Bodies wild_coordinates(Random& random, unsigned n) {
  const auto coordinate = [&random] {
    const std::int64_t mantissa = random.between(1 << 19, (1 << 20) - 1);
    const std::int64_t sign = random.coin() ? 1 : -1;
    return times_power_of_two(mpq_class(sign * mantissa), random.between(-far, far) - 20);
  };
  Bodies bodies;
  for (Body* body : {&bodies.a, &bodies.b})
    for (unsigned i = 0; i < n; ++i) body->points.push_back({coordinate(), coordinate(), coordinate()});
  return bodies;
}

}  // namespace fathom::families
