// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies as lists of convex pieces, for the tests of unions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "fathom/union.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/boxes.hpp"

namespace fathom::unions {

using polytope::joined;
using testing::box;

inline std::vector<Vector> integers(const std::vector<Point>& points) {
  std::vector<Vector> result;
  for (const Point& p : points) result.push_back({p.x.get_num(), p.y.get_num(), p.z.get_num()});
  return result;
}

/// Points of integers in [0, size), not all in one plane.
inline std::vector<Point> random_piece(std::mt19937_64& random, std::size_t points, unsigned size) {
  for (;;) {
    std::vector<Point> piece;
    const auto coordinate = [&] { return mpq_class(static_cast<unsigned long>(random() % size)); };
    for (std::size_t i = 0; i < points; ++i) {
      const mpq_class x = coordinate(), y = coordinate(), z = coordinate();
      piece.push_back({x, y, z});
    }
    if (polytope::affine_rank(integers(piece)) == 3) return piece;
  }
}

inline Pieces moved(Pieces pieces, const Point& t) {
  for (std::vector<Point>& piece : pieces)
    for (Point& p : piece) p = {p.x + t.x, p.y + t.y, p.z + t.z};
  return pieces;
}

inline Pieces scaled(Pieces pieces, const mpq_class& s) {
  for (std::vector<Point>& piece : pieces)
    for (Point& p : piece) p = {p.x * s, p.y * s, p.z * s};
  return pieces;
}

/// Pieces with their places along the diagonal apart by `step`.
inline Pieces random_pieces(std::mt19937_64& random, std::size_t pieces, std::size_t points, unsigned size,
                            unsigned step) {
  Pieces result;
  for (std::size_t i = 0; i < pieces; ++i) {
    const mpq_class at(static_cast<unsigned long>(step * i));
    const mpq_class beside =
        random() % 2 == 0 ? at : mpq_class(0);  // drawn first: compilers differ in the order of arguments
    result.push_back(moved({random_piece(random, points, size)}, {at, beside, 0}).front());
  }
  return result;
}

/// Boxes with corners of integers in [0, size).
inline Pieces random_boxes(std::mt19937_64& random, std::size_t pieces, unsigned size) {
  Pieces result;
  for (std::size_t i = 0; i < pieces; ++i) {
    const auto side = [&] {
      const unsigned long low = random() % (size - 1), high = low + 1 + random() % (size - 1 - low);
      return std::pair<mpq_class, mpq_class>(low, high);
    };
    const auto x = side(), y = side(), z = side();
    result.push_back(box({x.first, y.first, z.first}, {x.second, y.second, z.second}));
  }
  return result;
}

/// The convex hull of integer points, cut into cones over its facets from the mean of its vertices.
inline Pieces cones(const std::vector<Point>& body) {
  const polytope::Polytope hull = polytope::convex_hull(integers(body));
  Point mean{0, 0, 0};
  const mpq_class count(static_cast<unsigned long>(hull.vertices.size()));
  for (const Vector& v : hull.vertices) mean = {mean.x + v.x / count, mean.y + v.y / count, mean.z + v.z / count};
  Pieces pieces;
  for (const polytope::Facet& f : hull.facets) {
    std::vector<Point>& piece = pieces.emplace_back(1, mean);
    for (std::uint32_t c = f.begin; c < f.end; ++c) {
      const Vector& v = hull.vertices[hull.corners[c]];
      piece.push_back({v.x, v.y, v.z});
    }
  }
  return pieces;
}

/// A box, cut by a grid of so many cells along each axis.
inline Pieces grid(const Point& low, const Point& high, int cells) {
  Pieces pieces;
  const auto at = [&](const mpq_class& from, const mpq_class& to, int i) {
    return mpq_class(from + (to - from) * i / cells);
  };
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z)
        pieces.push_back(box({at(low.x, high.x, x), at(low.y, high.y, y), at(low.z, high.z, z)},
                             {at(low.x, high.x, x + 1), at(low.y, high.y, y + 1), at(low.z, high.z, z + 1)}));
  return pieces;
}

/// A ring of so many wedges that abut, about the z axis, or about the x axis and moved along x.
inline Pieces ring(int wedges, bool upright, const mpq_class& shift) {
  static constexpr int circle[12][2] = {{20, 0},  {17, 10},   {10, 17},   {0, 20},  {-10, 17}, {-17, 10},
                                        {-20, 0}, {-17, -10}, {-10, -17}, {0, -20}, {10, -17}, {17, -10}};
  Pieces pieces;
  for (int i = 0; i < wedges; ++i) {
    std::vector<Point>& piece = pieces.emplace_back();
    for (const int k : {i * 12 / wedges, (i + 1) * 12 / wedges % 12}) {
      for (const int radius : {7, 13}) {
        for (const int side : {-4, 4}) {
          const mpq_class u(circle[k][0] * radius, 10), v(circle[k][1] * radius, 10);
          Point p = upright ? Point{u + shift, side, v} : Point{u, v, side};
          for (mpq_class* c : {&p.x, &p.y, &p.z}) c->canonicalize();
          piece.push_back(std::move(p));
        }
      }
    }
  }
  return pieces;
}

}  // namespace fathom::unions
