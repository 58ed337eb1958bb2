// SPDX-License-Identifier: GPL-3.0-or-later
// The depth of two convex polygons by the definitions: the hull of all differences of points, edge
// by edge. Points and segments too.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/vector.hpp"

namespace fathom::plane {

/// z is 0.
using Points = std::vector<Point>;

/// Positive if q is counter-clockwise of p.
inline mpq_class turn(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }
inline mpq_class square(const Point& p) { return p.x * p.x + p.y * p.y; }
inline mpq_class height(const Point& n, const Point& p) { return n.x * p.x + n.y * p.y; }

/// The extreme points, counter-clockwise.
inline Points hull(Points points) {
  const auto less = [](const Point& p, const Point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); };
  std::ranges::sort(points, less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Points chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = chain.size();
    for (const Point& p : points) {
      while (chain.size() >= begin + 2 && turn(chain.back() - chain[chain.size() - 2], p - chain.back()) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::ranges::reverse(points);
  }
  return chain;
}

struct NaiveAnswer {
  Status status = Status::touching;
  mpq_class squared;         ///< of the depth, or of the distance
  std::vector<Vector> ways;  ///< primitive, sorted: all directions of the depth
};

inline mpq_class squared_distance(const Point& p, const Point& q) {
  const Point edge = q - p;
  const mpq_class length = square(edge);
  if (length == 0) return square(p);
  const mpq_class along = std::clamp<mpq_class>(-height(edge, p) / length, 0, 1);
  return square(p + along * edge);
}

/// Of the origin and the hull of the differences b - a.
inline NaiveAnswer naive_depth(const Points& a, const Points& b) {
  Points differences;
  for (const Point& p : a)
    for (const Point& q : b) differences.push_back(q - p);
  const Points sum = hull(std::move(differences));
  NaiveAnswer answer;
  std::optional<mpq_class> nearest, depth;  // squared
  bool inside = sum.size() > 2, outside = false;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const Point &p = sum[i], &q = sum[(i + 1) % sum.size()], edge = q - p, normal{edge.y, -edge.x, 0};
    const mpq_class distance = squared_distance(p, q), h = height(normal, p);
    if (!nearest || distance < *nearest) nearest = distance;
    outside = outside || h < 0;
    inside = inside && h > 0;
    if (sum.size() < 3) continue;
    const mpq_class squared = h * h / square(normal);
    if (!depth || squared < *depth) (depth = squared, answer.ways.clear());
    if (squared == *depth) answer.ways.push_back(primitive_along(normal));
  }
  if (!inside) answer.ways.clear();
  std::ranges::sort(answer.ways,
                    [](const Vector& u, const Vector& v) { return u.x < v.x || (u.x == v.x && u.y < v.y); });
  answer.status = inside ? Status::penetrating : *nearest == 0 ? Status::touching : Status::disjoint;
  answer.squared = inside ? *depth : *nearest;
  return answer;
}

/// The points that span the face of a body in direction n: the ends of an edge, or a vertex; of
/// equal points the first.
inline std::vector<std::uint32_t> naive_face(const Points& points, const Point& n) {
  mpq_class most = height(n, points.front());
  for (const Point& p : points) most = std::max<mpq_class>(most, height(n, p));
  std::optional<std::uint32_t> low, high;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (height(n, points[i]) != most) continue;
    if (!low || turn(n, points[i]) < turn(n, points[*low])) low = i;
    if (!high || turn(n, points[i]) > turn(n, points[*high])) high = i;
  }
  if (points[*low] == points[*high]) return {std::min(*low, *high)};
  return {std::min(*low, *high), std::max(*low, *high)};
}

}  // namespace fathom::plane
