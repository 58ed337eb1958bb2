// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/plane_pairs.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "fathom/plane.hpp"
#include "fathom/shape.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {
namespace {

using Polygon = std::vector<Point>;

constexpr unsigned grid_bits = 20;
constexpr unsigned least_corners = 3, most_steps = 1024;

mpq_class on_grid(std::int64_t value) { return times_power_of_two(mpq_class(value), -long{grid_bits}); }

Body body_of(Polygon points) {
  Body body;
  body.points = std::move(points);
  return in_plane(std::move(body));
}

Body with_margin(const Polygon& core, const mpq_class& margin) {
  Body body;
  body.shape = fathom::with_margin(hull(core), margin);
  return in_plane(std::move(body));
}

Polygon moved(Polygon points, const Point& by) {
  for (Point& p : points) p.x += by.x, p.y += by.y;
  return points;
}

Polygon scaled(Polygon points, const mpq_class& x, const mpq_class& y) {
  for (Point& p : points) p.x *= x, p.y *= y;
  return points;
}

/// Turned and scaled by one of some matrices ((p, -q), (q, p)) / 2^k, which keep dyadic numbers
/// short.
struct Similarity {
  long p, q, halvings;
};
constexpr auto similarities = std::to_array<Similarity>({{1, 0, 0},
                                                         {0, 1, 0},
                                                         {-1, 0, 0},
                                                         {0, -1, 0},
                                                         {3, 4, 2},
                                                         {4, -3, 2},
                                                         {1, 1, 0},
                                                         {-2, 1, 1},
                                                         {2, 3, 2},
                                                         {-7, 3, 3},
                                                         {5, -12, 4},
                                                         {-9, -4, 3}});

Polygon turned(const Similarity& by, Polygon points) {
  for (Point& p : points) {
    const mpq_class x = by.p * p.x - by.q * p.y, y = by.q * p.x + by.p * p.y;
    p = {times_power_of_two(x, -by.halvings), times_power_of_two(y, -by.halvings), 0};
  }
  return points;
}

Point in_disc(Random& random) {
  constexpr std::int64_t radius = std::int64_t{1} << grid_bits;
  while (true) {
    const std::int64_t x = random.between(-radius, radius), y = random.between(-radius, radius);
    if (x * x + y * y <= radius * radius) return {on_grid(x), on_grid(y), 0};
  }
}

Point shift(Random& random) {
  const mpq_class x = random_dyadic(random, -1, 1, grid_bits), y = random_dyadic(random, -1, 1, grid_bits);
  return {x, y, 0};
}

/// Three points of which are no line.
Polygon random_polygon(Random& random, unsigned n) {
  Polygon points;
  while (true) {
    points.clear();
    for (unsigned i = 0; i < std::max(least_corners, n); ++i) points.push_back(in_disc(random));
    const Point &o = points[0], &p = points[1], &q = points[2];
    if ((p.x - o.x) * (q.y - o.y) != (p.y - o.y) * (q.x - o.x)) return points;
  }
}

/// The regular polygon, its first corner at `start` / most_steps of a step.
Polygon regular(unsigned corners, unsigned start) {
  Polygon points;
  for (unsigned k = 0; k < corners; ++k) {
    const CirclePoint p =
        circle_point((k * most_steps + start) % (corners * most_steps), corners * most_steps, grid_bits);
    points.push_back({on_grid(p.cosine), on_grid(p.sine), 0});
  }
  return points;
}

unsigned corners_up_to(Random& random, unsigned n) {
  return static_cast<unsigned>(random.between(least_corners, std::max(least_corners, n)));
}

unsigned start_of(Random& random) { return static_cast<unsigned>(random.between(0, most_steps - 1)); }

/// 2^-k, k in [least, most].
mpq_class small(Random& random, std::int64_t least, std::int64_t most) {
  return times_power_of_two(mpq_class(1), -static_cast<long>(random.between(least, most)));
}

// ---- contacts ----

/// A polygon in y <= 0 whose highest feature is the vertex O, or an edge of y = 0 about O.
Polygon below(Random& random, bool edge, unsigned n) {
  constexpr unsigned coarse_bits = 10;
  Polygon points;
  if (edge) {
    const mpq_class left = random_dyadic(random, 0, 1, coarse_bits), right = random_dyadic(random, 0, 1, coarse_bits);
    points = {{-left - ratio(1, 8), 0, 0}, {right + ratio(1, 8), 0, 0}};
  } else {
    points = {{0, 0, 0}};
  }
  points.push_back({0, -1, 0});
  while (points.size() < std::max(least_corners, n)) {
    const mpq_class x = random_dyadic(random, -1, 1, coarse_bits), y = random_dyadic(random, -1, 0, coarse_bits);
    points.push_back({x, y - ratio(1, 8), 0});
  }
  return points;
}

/// The same in y >= 0.
Polygon above(Random& random, bool edge, unsigned n) {
  Polygon points = below(random, edge, n);
  for (Point& p : points) p.x = -p.x, p.y = -p.y;
  return points;
}

PlanePair turned_pair(Random& random, const Polygon& a, const Polygon& b) {
  const Similarity& by = any_of(similarities, random);
  return {body_of(turned(by, a)), body_of(turned(by, b))};
}

/// B's feature is `height` above A's.
PlanePair meeting(Random& random, unsigned n, const mpq_class& height, bool edge_a, bool edge_b) {
  const Polygon a = below(random, edge_a, n), b = above(random, edge_b, n);
  const mpq_class aside = edge_a && edge_b ? random_dyadic(random, 0, 1, 3) / 8 : mpq_class(0);
  return turned_pair(random, a, moved(b, {aside, height, 0}));
}

}  // namespace

PlanePair plane_random(Random& random, unsigned n) {
  const Polygon a = random_polygon(random, n), b = random_polygon(random, n);
  return {body_of(a), body_of(moved(b, shift(random)))};
}

PlanePair plane_regular(Random& random, unsigned n) {
  const unsigned of_a = corners_up_to(random, n), of_b = corners_up_to(random, n);
  const Polygon a = regular(of_a, start_of(random));
  const mpq_class size = ratio(random.between(4, 8), 8);
  return {body_of(a), body_of(moved(scaled(regular(of_b, start_of(random)), size, size), shift(random)))};
}

PlanePair plane_boxes(Random& random, unsigned /*n*/) {
  const auto box = [&random] {
    std::array<std::int64_t, 2> low{}, high{};
    for (const std::size_t axis : {0U, 1U}) {
      low[axis] = random.between(0, 2);
      high[axis] = random.between(low[axis] + 1, 4);
    }
    return Polygon{{low[0], low[1], 0}, {high[0], low[1], 0}, {high[0], high[1], 0}, {low[0], high[1], 0}};
  };
  const Polygon a = box(), b = box();
  return {body_of(a), body_of(b)};
}

PlanePair plane_thin(Random& random, unsigned n) {
  const auto thin = [&] {
    const mpq_class width = small(random, 3, 10);
    const Polygon points = scaled(regular(std::max(least_corners + 1, n), 0), 1, width);
    return turned(any_of(similarities, random), points);
  };
  const Polygon a = thin(), b = thin();
  const Point by = shift(random);
  return {body_of(a), body_of(moved(b, {by.x / 4, by.y / 4, 0}))};
}

PlanePair plane_far(Random& random, unsigned n) {
  const auto part = [&random] {
    long length = static_cast<long>(random.between(1, 9));
    for (std::int64_t zeros = random.between(3, 6); zeros > 0; --zeros) length *= 10;
    return mpq_class(random.coin() ? length : -length);
  };
  const Polygon a = random_polygon(random, n), b = moved(random_polygon(random, n), shift(random));
  const mpq_class x = part(), y = part();
  return {body_of(moved(a, {x, y, 0})), body_of(moved(b, {x, y, 0}))};
}

PlanePair plane_rounded(Random& random, unsigned n) {
  const auto rounded = [&](const Point& at) {
    const mpq_class margin = ratio(random.between(1, 32), 64);
    const std::int64_t kind = random.between(0, 2);
    const Polygon core = kind == 0   ? Polygon{{0, 0, 0}}
                         : kind == 1 ? Polygon{in_disc(random), in_disc(random)}
                                     : random_polygon(random, n);
    return with_margin(moved(core, at), margin);
  };
  Body a = rounded({0, 0, 0});
  return {std::move(a), rounded(shift(random))};
}

PlanePair plane_flat(Random& random, unsigned n) {
  const auto points = [&](std::int64_t rank) {
    if (rank == 2) return random_polygon(random, n);
    Polygon result;
    for (std::int64_t i = 0; i <= rank; ++i) {
      const mpq_class x = ratio(random.between(-2, 2), 2), y = ratio(random.between(-2, 2), 2);
      result.push_back({x, y, 0});
    }
    return result;
  };
  const std::int64_t flat = random.between(0, 1), other = random.between(0, 2);
  const Polygon one = points(flat), two = points(other);
  return random.coin() ? PlanePair{body_of(one), body_of(two)} : PlanePair{body_of(two), body_of(one)};
}

PlanePair plane_ties(Random& random, unsigned n) {
  const unsigned corners = 2 * std::max(2U, corners_up_to(random, n) / 2);
  const Polygon a = regular(corners, random.coin() ? 0 : most_steps / 2);
  const mpq_class size = small(random, 0, 2);
  return {body_of(a), body_of(scaled(a, size, size))};
}

PlanePair plane_near_ties(Random& random, unsigned n) {
  const unsigned corners = 2 * std::max(2U, corners_up_to(random, n) / 2);
  const Polygon a = regular(corners, random.coin() ? 0 : most_steps / 2);
  const mpq_class x = small(random, 4, 20), y = small(random, 4, 20);
  return {body_of(a), body_of(moved(a, {x, random.coin() ? y : mpq_class(-y), 0}))};
}

PlanePair plane_identical(Random& random, unsigned n) {
  const Polygon a = random_polygon(random, n);
  return {body_of(a), body_of(a)};
}

PlanePair plane_nested(Random& random, unsigned n) {
  const Polygon a = random_polygon(random, n);
  const mpq_class size = small(random, 1, 3);
  return {body_of(a), body_of(scaled(a, size, size))};
}

PlanePair plane_touching(Random& random, unsigned n) {
  const bool edge_a = random.coin(), edge_b = random.coin();
  return meeting(random, n, 0, edge_a, edge_b);
}

PlanePair plane_nearly_touching(Random& random, unsigned n) {
  const bool edge_a = random.coin(), edge_b = random.coin();
  const mpq_class height = small(random, 4, 16);
  return meeting(random, n, random.coin() ? height : mpq_class(-height), edge_a, edge_b);
}

PlanePair plane_parallel_edges(Random& random, unsigned n) {
  return meeting(random, n, -small(random, 2, 10), true, true);
}

PlanePair plane_tilted_edges(Random& random, unsigned n) {
  const Polygon a = below(random, true, n);
  Polygon b = above(random, true, n);
  const mpq_class slope = small(random, 4, 14);
  for (Point& p : b) p.y += slope * p.x;
  return turned_pair(random, a, moved(b, {0, -small(random, 2, 6), 0}));
}

}  // namespace fathom::families
