// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <array>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {
namespace {

polytope::Polytope hull_of(const std::vector<Point>& points) {
  return polytope::convex_hull(polytope::place(points, points).a.points());
}

Point mean_of(const std::vector<Point>& points) {
  Point sum{0, 0, 0};
  for (const Point& p : points) sum = sum + p;
  return mpq_class(1, points.size()) * sum;
}

/// Where the segment from p to q is at `height`: at p it is lower, at q higher.
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
  for (const std::uint32_t id : hull_of(points).input_ids) vertices.push_back(points[id]);
  return vertices;
}

Pieces cut_into_cones(const std::vector<Point>& body) {
  const polytope::Polytope hull = hull_of(body);
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

}  // namespace fathom::families
