// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <utility>

#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

constexpr long ball_grid_bits = 20;
constexpr std::int64_t radius = std::int64_t{1} << ball_grid_bits;

/// Returns a grid point other than 0 in the ball of the given radius, by rejection.
std::array<std::int64_t, 3> in_ball(Random& random) {
  while (true) {
    const std::array<std::int64_t, 3> p{random.between(-radius, radius), random.between(-radius, radius),
                                        random.between(-radius, radius)};
    const std::int64_t norm = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    if (norm > 0 && norm <= radius * radius) return p;
  }
}

mpq_class on_ball_grid(const mpz_class& value) { return times_power_of_two(mpq_class(value), -ball_grid_bits); }

/// p * radius / |p|, rounded towards 0 with a norm that carries 20 bits more than p.
mpq_class pushed_out(std::int64_t p, const mpz_class& norm) {
  const mpz_class numerator = mpz_class(p) * radius * radius;
  return on_ball_grid(mpz_class(numerator / norm));
}

Body turned(Random& random, const Body& body) { return rotated(body, random_rotation(random)); }

mpq_class random_half_extent(Random& random) { return ratio(random.between(8, 64), 32); }

/// Returns a prism over at least three corners: 2 * corners points.
Body random_prism(Random& random, unsigned n) {
  const unsigned corners = std::max(3u, (n + 1) / 2);
  const mpq_class half_height = random_half_extent(random);
  return turned(random, random.coin() ? prism(corners, half_height) : antiprism(corners, half_height));
}

Body random_aligned_box(Random& random) {
  std::array<std::int64_t, 3> low{}, high{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = random.between(0, 2);
    high[axis] = random.between(low[axis] + 1, 4);
  }
  Body body;
  for (const std::int64_t x : {low[0], high[0]})
    for (const std::int64_t y : {low[1], high[1]})
      for (const std::int64_t z : {low[2], high[2]}) body.points.push_back({x, y, z});
  return body;
}

mpq_class thin() { return times_power_of_two(1, -20); }

Body needle(Random& random, unsigned n) {
  return turned(random, scaled(random_sphere_body(random, n), 1, thin(), thin()));
}
Body plate(Random& random, unsigned n) { return turned(random, scaled(random_sphere_body(random, n), 1, 1, thin())); }

Bodies far_away(Random& random, Bodies bodies) {
  const auto part = [&random] {
    long long length = random.between(1, 9);
    for (std::int64_t zeros = random.between(3, 6); zeros > 0; --zeros) length *= 10;
    return mpq_class(static_cast<long>(random.coin() ? length : -length));
  };
  const Point by{part(), part(), part()};
  return {translated(bodies.a, by), translated(bodies.b, by)};
}

}  // namespace

Body random_ball_body(Random& random, unsigned n) {
  Body body;
  for (unsigned i = 0; i < n; ++i) {
    const auto p = in_ball(random);
    body.points.push_back({on_ball_grid(p[0]), on_ball_grid(p[1]), on_ball_grid(p[2])});
  }
  return body;
}

Body random_sphere_body(Random& random, unsigned n) {
  Body body;
  for (unsigned i = 0; i < n; ++i) {
    const auto p = in_ball(random);
    const mpz_class square = mpz_class(p[0]) * p[0] + mpz_class(p[1]) * p[1] + mpz_class(p[2]) * p[2];
    const mpz_class norm = sqrt(mpz_class(square * radius * radius));  // |p| * radius
    body.points.push_back({pushed_out(p[0], norm), pushed_out(p[1], norm), pushed_out(p[2], norm)});
  }
  return body;
}

Body random_lattice_body(Random& random, unsigned n, long side) {
  Body body;
  for (unsigned i = 0; i < n; ++i)
    body.points.push_back({random.between(0, side), random.between(0, side), random.between(0, side)});
  return body;
}

Bodies random_ball(Random& random, unsigned n) {
  const Body a = random_ball_body(random, n);
  const Body b = random_ball_body(random, n);
  return {a, translated(b, random_shift(random, 1))};
}

Bodies random_sphere(Random& random, unsigned n) {
  const Body a = random_sphere_body(random, n);
  const Body b = random_sphere_body(random, n);
  return {a, translated(b, random_shift(random, 1))};
}

Bodies random_lattice(Random& random, unsigned n) {
  const Body a = random_lattice_body(random, n);
  return {a, random_lattice_body(random, n)};
}

Bodies random_disjoint(Random& random, unsigned n) {
  Bodies bodies = random_ball(random, n);
  const mpq_class far = ratio(random.between(13, 20), 4);  // beyond 1 + 1 + the shift's 1
  bodies.b = translated(bodies.b, {far, 0, 0});
  return rotated(bodies, random_rotation(random));
}

Bodies boxes_posed(Random& random, unsigned) {
  Bodies bodies;
  for (Body* body : {&bodies.a, &bodies.b}) {
    const mpq_class x = random_half_extent(random), y = random_half_extent(random), z = random_half_extent(random);
    *body = turned(random, box(x, y, z));
  }
  bodies.b = translated(bodies.b, random_shift(random, 2));
  return bodies;
}

Bodies far_boxes(Random& random, unsigned n) {
  Bodies bodies = boxes_posed(random, n);
  return far_away(random, std::move(bodies));
}

Bodies far_sphere(Random& random, unsigned n) {
  Bodies bodies = random_sphere(random, n);
  return far_away(random, std::move(bodies));
}

Bodies boxes_aligned(Random& random, unsigned) {
  const Body a = random_aligned_box(random);
  return {a, random_aligned_box(random)};
}

Bodies platonic_posed(Random& random, unsigned) {
  Bodies bodies;
  for (Body* body : {&bodies.a, &bodies.b}) {
    const Body solid = platonic(static_cast<unsigned>(random.between(0, 4)));
    *body = turned(random, scaled(solid, random_half_extent(random)));
  }
  bodies.b = translated(bodies.b, random_shift(random, 1));
  return bodies;
}

Bodies platonic_aligned(Random& random, unsigned) {
  const unsigned first = static_cast<unsigned>(random.between(0, 4)),
                 second = static_cast<unsigned>(random.between(0, 4));
  const Point shift{ratio(random.between(-4, 4), 4), ratio(random.between(-4, 4), 4), ratio(random.between(-4, 4), 4)};
  return {platonic(first), translated(platonic(second), shift)};
}

Bodies prisms_posed(Random& random, unsigned n) {
  const Body a = random_prism(random, n);
  const Body b = random_prism(random, n);
  return {a, translated(b, random_shift(random, 1))};
}

Bodies needles(Random& random, unsigned n) {
  const Body a = needle(random, n);
  return {a, needle(random, n)};
}

Bodies plates(Random& random, unsigned n) {
  const Body a = plate(random, n);
  return {a, plate(random, n)};
}

Bodies needle_and_plate(Random& random, unsigned n) {
  const Body a = needle(random, n);
  return {a, plate(random, n)};
}

}  // namespace fathom::families
