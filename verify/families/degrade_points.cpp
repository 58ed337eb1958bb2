// SPDX-License-Identifier: GPL-3.0-or-later
// Ways of breaking general position that add, move or drop points.
#include <algorithm>

#include "fathom/depth.hpp"
#include "kernels/vector.hpp"
#include "verify/families/alignment.hpp"
#include "verify/families/degrade_ways.hpp"

namespace fathom::families {

namespace {

template <class T>
const T& any(const std::vector<T>& list, Random& random) {
  return list[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(list.size()) - 1))];
}

Point between(const Point& p, const Point& q, const mpq_class& share) { return (1 - share) * p + share * q; }

Point centre(const Body& body) {
  Point sum;
  for (const Point& p : body.points) sum = sum + p;
  return ratio(1, mpz_class(body.points.size())) * sum;
}

Body flattened(const Body& body, Random& random) {
  const Features shape = features(body);
  if (shape.facets.empty()) return body;
  const std::size_t chosen = static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(shape.facets.size()) - 1));
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

/// The multiple of 2^exponent that is nearest, the higher one of two.
mpq_class snapped(const mpq_class& x, long exponent) {
  const mpq_class steps = times_power_of_two(x, -exponent) + ratio(1, 2);
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  return times_power_of_two(whole, exponent);
}

}  // namespace

void duplicate_points(Bodies& bodies, Random& random) {
  for (Body* body : {&bodies.a, &bodies.b}) {
    const std::vector<Point> given = body->points;
    body->points.push_back(any(given, random));
    for (const Point& p : given)
      if (random.between(0, 3) == 0) body->points.push_back(p);
  }
}

void collinear_points(Bodies& bodies, Random& random) {
  for (Body* body : {&bodies.a, &bodies.b}) {
    const Features shape = features(*body);
    for (int i = 0; i < 2 && !shape.edges.empty(); ++i) {
      const auto& [from, to] = any(shape.edges, random);
      body->points.push_back(between(from, to, ratio(random.between(1, 7), 8)));
    }
  }
}

// A triangle p q r gets the fourth corner of a parallelogram: in the facet's plane, so it stays a facet.
void coplanar_points(Bodies& bodies, Random& random) {
  for (Body* body : {&bodies.a, &bodies.b}) {
    const Features shape = features(*body);
    if (shape.facets.empty()) continue;
    const std::vector<Point>& corners = any(shape.facets, random);
    if (corners.size() == 3) body->points.push_back(corners[0] + corners[2] - corners[1]);
    body->points.push_back(between(between(corners[0], corners[1], ratio(random.between(1, 3), 4)), corners[2], ratio(1, 2)));
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
  const long exponent =
      static_cast<long>(mpz_sizeinbase(size.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(size.get_den_mpz_t(), 2));
  const long unit = exponent - 3;  // 2^(exponent - 1) < size < 2^(exponent + 1)
  for (Body* body : {&bodies.a, &bodies.b})
    for (Point& p : body->points.edit()) p = {snapped(p.x, unit), snapped(p.y, unit), snapped(p.z, unit)};
}

}  // namespace fathom::families
