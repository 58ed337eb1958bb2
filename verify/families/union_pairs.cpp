// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/union_pairs.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {
namespace {

Point mean_of(const std::vector<Point>& points) {
  Point sum{0, 0, 0};
  for (const Point& p : points) sum = sum + p;
  return mpq_class(1, points.size()) * sum;
}

/// Returns the point of the segment from p to q where <n, x> = height; <n, p> is less, <n, q>
/// greater.
Point crossing(const Vector& n, const mpq_class& height, const Point& p, const Point& q) {
  const mpq_class low = dot(n, p), t = (height - low) / (dot(n, q) - low);
  return p + t * (q - p);
}

Vector small_normal(Random& random) {
  const auto component = [&random] { return mpz_class(random.between(-3, 3)); };
  Vector n{0, 0, 0};
  while (n == Vector{0, 0, 0}) n = {component(), component(), component()};  // braces: in this order
  return n;
}

/// A mean of vertices with random weights.
Point random_inside(Random& random, const std::vector<Point>& vertices) {
  Point sum{0, 0, 0};
  mpq_class weights = 0;
  for (const Point& v : vertices) {
    const mpq_class w(random.between(1, 4));
    weights += w;
    sum = sum + w * v;
  }
  return mpq_class(1 / weights) * sum;
}

}  // namespace

bool is_flat(const std::vector<Point>& points) {
  return polytope::affine_rank(polytope::place(points, points).a.points()) < 3;
}

std::vector<Point> hull_vertices(const std::vector<Point>& points) {
  std::vector<Point> vertices;
  for (const std::uint32_t id : polytope::hull_of(points).input_ids) vertices.push_back(points[id]);
  return vertices;
}

Pieces cut_into_cones(const std::vector<Point>& body) {
  const polytope::Polytope hull = polytope::hull_of(body);
  std::vector<Point> vertices;
  for (const std::uint32_t id : hull.input_ids) vertices.push_back(body[id]);
  const Point mean = mean_of(vertices);
  Pieces pieces;
  for (const polytope::Facet& facet : hull.facets) {
    std::vector<Point>& piece = pieces.emplace_back(1, mean);
    for (std::uint32_t c = facet.begin; c < facet.end; ++c) piece.push_back(body[hull.input_ids[hull.corners[c]]]);
  }
  return pieces;
}

Pieces cut_by_plane(const Pieces& pieces, const Vector& normal, const mpq_class& height) {
  Pieces result;
  for (const std::vector<Point>& piece : pieces) {
    std::vector<Point> below, above, on;
    for (const Point& p : piece) {
      const int side = cmp(dot(normal, p), height);
      (side < 0 ? below : side > 0 ? above : on).push_back(p);
    }
    if (below.empty() || above.empty()) {
      result.push_back(piece);
      continue;
    }
    for (const Point& p : below)
      for (const Point& q : above) on.push_back(crossing(normal, height, p, q));
    for (std::vector<Point>* side : {&below, &above}) {
      side->insert(side->end(), on.begin(), on.end());
      result.push_back(hull_vertices(*side));
    }
  }
  return result;
}

Pieces cut_into_slabs(const std::vector<Point>& body, const Vector& normal, unsigned count) {
  mpq_class low = dot(normal, body.front()), high = low;
  for (const Point& p : body) {
    const mpq_class height = dot(normal, p);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  Pieces pieces = {hull_vertices(body)};
  for (unsigned i = 1; i < count; ++i) pieces = cut_by_plane(pieces, normal, low + (high - low) * ratio(i, count));
  return pieces;
}

Pieces cut_by_random_planes(Random& random, const std::vector<Point>& body, unsigned count) {
  const std::vector<Point> vertices = hull_vertices(body);
  Pieces pieces = {vertices};
  while (pieces.size() < count) {
    const Vector normal = small_normal(random);
    const Point inside = random_inside(random, vertices);
    pieces = cut_by_plane(pieces, normal, dot(normal, inside));
  }
  return pieces;
}

Pieces cut_into_grid(const Point& low, const Point& high, unsigned cells) {
  const auto at = [cells](const mpq_class& from, const mpq_class& to, unsigned i) {
    return mpq_class(from + (to - from) * ratio(i, cells));
  };
  Pieces pieces;
  for (unsigned x = 0; x < cells; ++x)
    for (unsigned y = 0; y < cells; ++y)
      for (unsigned z = 0; z < cells; ++z) {
        std::vector<Point>& piece = pieces.emplace_back();
        for (unsigned corner = 0; corner < 8; ++corner)
          piece.push_back({at(low.x, high.x, x + (corner & 1)), at(low.y, high.y, y + (corner >> 1 & 1)),
                           at(low.z, high.z, z + (corner >> 2))});
      }
  return pieces;
}

// ---- the bodies, pairs that are not convex, and pairs of convex bodies that were cut ----

namespace {

constexpr long union_grid_bits = 16;

/// The multiple of 2^-16 at or below it.
mpq_class down_to_grid(const mpq_class& value) {
  const mpq_class scaled = times_power_of_two(value, union_grid_bits);
  mpz_class below;
  mpz_fdiv_q(below.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return times_power_of_two(below, -union_grid_bits);
}

Point unit_vector(Random& random) { return random_sphere_body(random, 1).points.front(); }

Point at(const Point& center, const mpq_class& radius, const Point& unit) {
  return {down_to_grid(center.x + radius * unit.x), down_to_grid(center.y + radius * unit.y),
          down_to_grid(center.z + radius * unit.z)};
}

/// Multiples of 1/64.
mpq_class between(Random& random, const mpq_class& low, const mpq_class& high) {
  return low + (high - low) * ratio(random.between(0, 64), 64);
}

Point shift(Random& random, const mpq_class& bound) {
  const mpq_class x = between(random, -bound, bound), y = between(random, -bound, bound),
                  z = between(random, -bound, bound);
  return {x, y, z};
}

Pieces half_turn_about_z(Pieces pieces) {
  for (std::vector<Point>& piece : pieces)
    for (Point& p : piece) p = {-p.x, -p.y, p.z};
  return pieces;
}

/// A plate of width 1 beside one of n slots, and within reach of it.
UnionPair plate_at_slot(Random& random, unsigned n, const mpq_class& width) {
  const Pieces walls = slotted(n, width);
  const mpq_class slot = 2 + (2 + width) * mpq_class(random.between(0, static_cast<std::int64_t>(walls.size()) - 2));
  const int side = random.coin() ? 1 : -1;  // drawn first: compilers differ in the order of operands
  const mpq_class beside = side * ratio(random.between(1, 48), 64);
  const mpq_class x = slot + beside, y = between(random, -1, 0), z = between(random, -1, 0);
  return {{box_from({x, y, z}, {x + 1, y + 1, z + 1})}, walls};
}

}  // namespace

std::vector<Point> box_from(const Point& low, const Point& high) { return cut_into_grid(low, high, 1).front(); }

Pieces translated(const Pieces& pieces, const Point& by) {
  Pieces result = pieces;
  for (std::vector<Point>& piece : result)
    for (Point& p : piece) p = p + by;
  return result;
}

Pieces cluster(Random& random, unsigned n, unsigned points) {
  const mpq_class usual = ratio(2, 5);
  Pieces pieces;
  Point center{0, 0, 0};
  while (pieces.size() < std::max(1U, n)) {
    const mpq_class radius = usual * random_dyadic(random, 0, 1, 10) * ratio(6, 10) + usual * ratio(7, 10);
    std::vector<Point> piece;
    for (unsigned i = 0; i < points; ++i) piece.push_back(at(center, radius, unit_vector(random)));
    if (is_flat(piece)) continue;
    pieces.push_back(std::move(piece));
    center = at(center, usual, unit_vector(random));
  }
  return pieces;
}

Pieces lattice_boxes(Random& random, unsigned n) {
  Pieces pieces;
  for (unsigned i = 0; i < std::max(1U, n); ++i) {
    std::array<std::int64_t, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = random.between(0, 4);
      high[axis] = random.between(low[axis] + 1, 5);
    }
    pieces.push_back(box_from({low[0], low[1], low[2]}, {high[0], high[1], high[2]}));
  }
  return pieces;
}

Pieces comb(unsigned n, const mpq_class& tooth_length) {
  const unsigned teeth = std::max(1U, n);
  Pieces pieces = {box_from({0, -1, 0}, {2 * teeth - 1, 0, 1})};
  for (unsigned i = 0; i < teeth; ++i) pieces.push_back(box_from({2 * i, 0, 0}, {2 * i + 1, tooth_length, 1}));
  return pieces;
}

Pieces ring(unsigned n, bool upright) {
  const unsigned wedges = std::max(3U, n), bits = std::max(10U, circle_bits(wedges));
  const auto corners = [&](std::vector<Point>& piece, unsigned k) {
    const CirclePoint c = circle_point(k % wedges, wedges, bits);
    for (const mpq_class& radius : {ratio(3, 4), ratio(5, 4)})
      for (const mpq_class& side : {ratio(-1, 4), ratio(1, 4)}) {
        const mpq_class u = times_power_of_two(radius * c.cosine, -static_cast<long>(bits)),
                        v = times_power_of_two(radius * c.sine, -static_cast<long>(bits));
        piece.push_back(upright ? Point{u, side, v} : Point{u, v, side});
      }
  };
  Pieces pieces;
  for (unsigned i = 0; i < wedges; ++i) {
    std::vector<Point>& piece = pieces.emplace_back();
    corners(piece, i);
    corners(piece, i + 1);
  }
  return pieces;
}

Pieces slotted(unsigned n, const mpq_class& width) {
  Pieces pieces;
  mpq_class x = 0;
  for (unsigned i = 0; i <= std::max(1U, n); ++i, x += 2 + width)
    pieces.push_back(box_from({x, -3, -3}, {x + 2, 3, 3}));
  return pieces;
}

UnionPair clusters(Random& random, unsigned n) {
  constexpr unsigned points = 20;
  const Pieces a = cluster(random, n, points);
  const Pieces b = cluster(random, n, points);
  return {a, translated(b, shift(random, ratio(1, 2)))};
}

UnionPair lattice_clusters(Random& random, unsigned n) {
  const auto body = [&random, n] {
    Pieces pieces;
    while (pieces.size() < std::max(1U, n)) {
      const Body hull = random_lattice_body(random, 6, 3);
      if (is_flat(hull.points)) continue;
      const Point place{random.between(0, 3), random.between(0, 3), random.between(0, 3)};
      pieces.push_back(translated(Pieces{hull.points}, place).front());
    }
    return pieces;
  };
  const Pieces a = body(), b = body();
  return {a, b};
}

UnionPair box_unions(Random& random, unsigned n) {
  const Pieces a = lattice_boxes(random, n), b = lattice_boxes(random, n);
  return {a, b};
}

UnionPair box_unions_touching(Random& random, unsigned n) {
  const Pieces a = lattice_boxes(random, n), b = lattice_boxes(random, n);
  mpq_class end = 0, begin = 5;
  for (const std::vector<Point>& piece : a)
    for (const Point& p : piece) end = std::max(end, p.x);
  for (const std::vector<Point>& piece : b)
    for (const Point& p : piece) begin = std::min(begin, p.x);
  return {a, translated(b, {end - begin, random.between(-2, 2), random.between(-2, 2)})};
}

UnionPair clusters_apart(Random& random, unsigned n) {
  constexpr unsigned points = 8;
  const Pieces a = cluster(random, n, points), b = cluster(random, n, points);
  mpq_class end = -100000, begin = 100000;
  for (const std::vector<Point>& piece : a)
    for (const Point& p : piece) end = std::max(end, p.x);
  for (const std::vector<Point>& piece : b)
    for (const Point& p : piece) begin = std::min(begin, p.x);
  return {a, translated(b, {end - begin + ratio(random.between(1, 8), 8), 0, 0})};
}

UnionPair combs(Random& random, unsigned n) {
  const mpq_class length = between(random, 1, 4);
  const Pieces a = comb(n, length), b = half_turn_about_z(comb(n, length));
  const mpq_class across = between(random, 2, 2 * std::max(1U, n)), into = between(random, 0, length);
  return {a, translated(b, {across, 2 * length - into, between(random, ratio(-1, 2), ratio(1, 2))})};
}

UnionPair keys(Random& random, unsigned n) {
  // The lock: a plate about a keyhole, with n wards behind. The key: a shaft through the hole, with
  // n bits between the wards.
  const unsigned wards = std::max(1U, n);
  Pieces lock = {box_from({0, -3, -3}, {1, 3, -1}), box_from({0, -3, 1}, {1, 3, 3}), box_from({0, -3, -1}, {1, -1, 1}),
                 box_from({0, 1, -1}, {1, 3, 1})};
  Pieces key = {box_from({-4, ratio(-3, 4), ratio(-3, 4)}, {2 * wards + 2, ratio(3, 4), ratio(3, 4)})};
  for (unsigned i = 0; i < wards; ++i) {
    lock.push_back(box_from({2 * i + 2, -3, 1}, {2 * i + 3, 3, 3}));
    key.push_back(
        box_from({2 * i + ratio(5, 4), ratio(-1, 2), ratio(3, 4)}, {2 * i + ratio(7, 4), ratio(1, 2), ratio(9, 4)}));
  }
  return {translated(key, shift(random, 1)), lock};
}

UnionPair slots(Random& random, unsigned n) { return plate_at_slot(random, n, 1); }
UnionPair slots_narrow(Random& random, unsigned n) { return plate_at_slot(random, n, 1 - times_power_of_two(1, -16)); }

UnionPair rings_linked(Random& random, unsigned n) {
  const Point place{1 + between(random, ratio(-1, 2), ratio(1, 2)), between(random, ratio(-1, 4), ratio(1, 4)),
                    between(random, ratio(-1, 4), ratio(1, 4))};
  return {ring(n, false), translated(ring(n, true), place)};
}

UnionPair ring_and_rod(Random& random, unsigned n) {
  const mpq_class half = between(random, ratio(1, 4), ratio(3, 4));
  const Pieces rod = {box_from({-half, -half, -3}, {half, half, 0}), box_from({-half, -half, 0}, {half, half, 3})};
  return {translated(rod, shift(random, ratio(1, 2))), ring(n, false)};
}

// ---- convex bodies that were cut: their depth is that of the hulls ----

namespace {

struct Whole {
  std::vector<Point> a, b;
};

/// On a lattice, or near spheres; B moved by up to 1.
Whole whole(Random& random, unsigned points) {
  const bool on_lattice = random.coin();
  const auto body = [&] {
    for (;;) {
      const Body hull = on_lattice ? random_lattice_body(random, points) : random_sphere_body(random, points);
      if (!is_flat(hull.points)) return hull;
    }
  };
  const Body a = body(), b = body();
  const Point by =
      on_lattice ? Point{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)} : random_shift(random, 1);
  return {a.points, translated(b, by).points};
}

/// A normal with components in -3..3, of which one is not 0.
Vector normal_of(Random& random) {
  const auto component = [&random] { return mpz_class(random.between(-3, 3)); };
  return {component(), component(), mpz_class(random.between(1, 3))};
}

Pieces shuffled(Random& random, Pieces pieces) {
  for (std::size_t i = pieces.size(); i > 1; --i)
    std::swap(pieces[i - 1], pieces[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(i) - 1))]);
  return pieces;
}

unsigned cells_of(unsigned n) {
  unsigned cells = 1;
  while (cells < 16 && (cells + 1) * (cells + 1) * (cells + 1) <= n) ++cells;
  return cells;
}

}  // namespace

UnionPair cut_cones(Random& random, unsigned n) {
  const Whole bodies = whole(random, std::max(4U, n / 2 + 2));
  return {cut_into_cones(bodies.a), cut_into_cones(bodies.b)};
}

UnionPair cut_slabs(Random& random, unsigned n) {
  const Whole bodies = whole(random, 10);
  const Vector normal = normal_of(random), other = random.coin() ? normal : normal_of(random);
  return {cut_into_slabs(bodies.a, normal, std::max(1U, n)), cut_into_slabs(bodies.b, other, std::max(1U, n))};
}

UnionPair cut_planes(Random& random, unsigned n) {
  const Whole bodies = whole(random, 8);
  const Pieces a = cut_by_random_planes(random, bodies.a, n), b = cut_by_random_planes(random, bodies.b, n);
  return {a, b};
}

UnionPair cut_grids(Random& random, unsigned n) {
  const auto side = [&random] { return mpq_class(random.between(1, 4)); };
  const auto grid = [&] {
    const Point low{side(), side(), side()}, size{side(), side(), side()};
    return cut_into_grid(low, low + size, cells_of(n));
  };
  const Pieces a = grid(), b = grid();
  return {a, b};
}

UnionPair cut_repeated(Random& random, unsigned n) {
  const Whole bodies = whole(random, 8);
  const auto repeated = [&](const std::vector<Point>& body) {
    Pieces pieces = cut_by_random_planes(random, body, n);
    const std::size_t count = pieces.size();
    for (std::size_t i = 0; i < count; i += 2) pieces.push_back(pieces[i]);
    pieces.push_back(body);
    return shuffled(random, std::move(pieces));
  };
  const Pieces a = repeated(bodies.a), b = repeated(bodies.b);
  return {a, b};
}

UnionPair cut_same(Random& random, unsigned n) {
  const std::vector<Point> body = whole(random, 8).a;
  const Pieces a = cut_by_random_planes(random, body, n);
  return {a, random.coin() ? a : cut_into_cones(body)};
}

UnionPair cut_and_whole(Random& random, unsigned n) {
  const Whole bodies = whole(random, 10);
  return {cut_by_random_planes(random, bodies.a, n), {bodies.b}};
}

}  // namespace fathom::families
