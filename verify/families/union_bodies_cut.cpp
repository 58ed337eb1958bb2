// SPDX-License-Identifier: GPL-3.0-or-later
// Of union_bodies.hpp the pairs of convex bodies that were cut: their depth is that of the hulls.
#include <algorithm>

#include "kernels/vector.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {
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
  const Point by = on_lattice ? Point{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)} : random_shift(random, 1);
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
