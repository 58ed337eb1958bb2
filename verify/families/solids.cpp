// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/families/solids.hpp"

#include <bit>
#include <utility>

#include "kernels/vector.hpp"

namespace fathom::families {

// ---- placements ----

namespace {

template <class Map>
Body mapped(const Body& body, Map map) {
  Body result;
  result.points.reserve(body.points.size());
  for (const Point& point : body.points) result.points.push_back(map(point));
  return result;
}

}  // namespace

Rotation rotation(long w, long x, long y, long z) {
  const mpz_class norm = w * w + x * x + y * y + z * z;
  const auto entry = [&norm](long value) { return ratio(value, norm); };
  return {Point{entry(w * w + x * x - y * y - z * z), entry(2 * (x * y - w * z)), entry(2 * (x * z + w * y))},
          Point{entry(2 * (x * y + w * z)), entry(w * w - x * x + y * y - z * z), entry(2 * (y * z - w * x))},
          Point{entry(2 * (x * z - w * y)), entry(2 * (y * z + w * x)), entry(w * w - x * x - y * y + z * z)}};
}

Rotation random_rotation(Random& random) {
  const long w = random.between(1, 5);  // never 0, so the quaternion is not
  const long x = random.between(-5, 5);
  const long y = random.between(-5, 5);
  const long z = random.between(-5, 5);
  return rotation(w, x, y, z);
}

Body rotated(const Body& body, const Rotation& rotation) {
  return mapped(body, [&rotation](const Point& p) {
    return Point{dot(rotation[0], p), dot(rotation[1], p), dot(rotation[2], p)};
  });
}

Body translated(const Body& body, const Point& by) {
  return mapped(body, [&by](const Point& p) { return p + by; });
}

Body scaled(const Body& body, const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return mapped(body, [&](const Point& p) { return Point{p.x * x, p.y * y, p.z * z}; });
}

Body scaled(const Body& body, const mpq_class& factor) { return scaled(body, factor, factor, factor); }

Bodies rotated(const Bodies& bodies, const Rotation& rotation) {
  return {rotated(bodies.a, rotation), rotated(bodies.b, rotation)};
}

Point random_shift(Random& random, long bound) {
  return {random_dyadic(random, -bound, bound, 20), random_dyadic(random, -bound, bound, 20),
          random_dyadic(random, -bound, bound, 20)};
}

// ---- points near a circle ----

namespace {

__extension__ typedef __int128 Wide;
constexpr unsigned fraction = 60;  // fixed point, 60 bits after the point
constexpr std::int64_t one = std::int64_t{1} << fraction;
constexpr std::int64_t half_pi = 1811004864519280711;  // pi / 2 * 2^60, rounded

std::int64_t product(std::int64_t a, std::int64_t b) { return static_cast<std::int64_t>((Wide{a} * b) >> fraction); }

/// cos and sin of an angle in [0, pi/4], in fixed point: Taylor series, whose terms fall below
/// 2^-60 before the 20th.
std::pair<std::int64_t, std::int64_t> taylor(std::int64_t angle) {
  std::int64_t cosine = one, sine = 0, term = one;
  for (int power = 1; power < 22; ++power) {
    term = product(term, angle) / power;
    std::int64_t& sum = power % 2 ? sine : cosine;
    sum += power % 4 < 2 ? term : -term;
  }
  return {cosine, sine};
}

std::int64_t rounded(std::int64_t value, unsigned bits) {
  const unsigned shift = fraction - bits;
  return (value + (std::int64_t{1} << (shift - 1))) >> shift;
}

}  // namespace

CirclePoint circle_point(std::uint64_t k, std::uint64_t n, unsigned bits) {
  const std::uint64_t quadrant = 4 * k / n, rest = 4 * k % n;
  const bool steep = 2 * rest > n;  // beyond pi/4: swap, so that the octants mirror each other
  const std::uint64_t share = steep ? n - rest : rest;
  auto [cosine, sine] = taylor(static_cast<std::int64_t>(Wide{half_pi} * share / n));
  if (steep) std::swap(cosine, sine);
  const std::int64_t c = rounded(cosine, bits), s = rounded(sine, bits);
  switch (quadrant) {
    case 0: return {c, s};
    case 1: return {-s, c};
    case 2: return {-c, -s};
    default: return {s, -c};
  }
}

unsigned circle_bits(std::uint64_t n) {
  const unsigned needed =
      12 + 2 * static_cast<unsigned>(std::bit_width(n - 1));  // steps of a polygon turn by about (2 pi / n)^2
  return needed < 20 ? 20 : needed > 52 ? 52 : needed;
}

std::vector<CirclePoint> regular_polygon(std::uint64_t n, unsigned phase) {
  std::vector<CirclePoint> corners;
  corners.reserve(n);
  for (std::uint64_t k = 0; k < n; ++k) corners.push_back(circle_point(4 * k + phase, 4 * n, circle_bits(n)));
  return corners;
}

// ---- solids ----

namespace {

/// (0, +-p, +-q) and its cyclic shifts: twelve points.
void add_cyclic(Body& body, const mpq_class& p, const mpq_class& q) {
  for (const int s : {-1, 1})
    for (const int t : {-1, 1}) {
      const mpq_class u = s * p, v = t * q;
      body.points.push_back({0, u, v});
      body.points.push_back({v, 0, u});
      body.points.push_back({u, v, 0});
    }
}

void add_polygon(Body& body, unsigned n, unsigned phase, const mpq_class& z) {
  const long bits = circle_bits(n);
  for (const CirclePoint& corner : regular_polygon(n, phase))
    body.points.push_back({times_power_of_two(corner.cosine, -bits), times_power_of_two(corner.sine, -bits), z});
}

}  // namespace

Body box(const mpq_class& half_x, const mpq_class& half_y, const mpq_class& half_z) {
  Body body;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1})
        body.points.push_back({mpq_class(x * half_x), mpq_class(y * half_y), mpq_class(z * half_z)});
  return body;
}

Body tetrahedron() { return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}; }

Body cube() { return box(1, 1, 1); }

Body octahedron() { return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}}; }

Body dodecahedron() {
  const mpq_class h =
      ratio(55, 89);  // the pentagons of (0, +-(1 - h^2), +-(1 + h)) with the cube are planar for every h
  Body body = cube();
  add_cyclic(body, mpq_class(1 - h * h), mpq_class(1 + h));
  return body;
}

Body icosahedron() {
  Body body;
  add_cyclic(body, 1, ratio(89, 55));
  return body;
}

Body platonic(unsigned index) {
  switch (index % 5) {
    case 0: return tetrahedron();
    case 1: return cube();
    case 2: return octahedron();
    case 3: return dodecahedron();
    default: return icosahedron();
  }
}

Body prism(unsigned n, const mpq_class& half_height, unsigned phase) {
  Body body;
  add_polygon(body, n, phase, -half_height);
  add_polygon(body, n, phase, half_height);
  return body;
}

Body antiprism(unsigned n, const mpq_class& half_height) {
  Body body;
  add_polygon(body, n, 0, -half_height);
  add_polygon(body, n, 2, half_height);
  return body;
}

}  // namespace fathom::families
