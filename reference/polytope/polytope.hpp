// SPDX-License-Identifier: GPL-3.0-or-later
// Input   any finite, non-empty set of integer points: duplicates, interior, collinear and coplanar
//         points welcome.
// Output  its convex hull: extreme vertices only, coplanar facets merged, ids of the input kept.
//                                                                                [AGHRS, section 2]
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/id.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"

namespace fathom::polytope {

/// The affine span: the rank of a set of points, up to 3, and for rank 2 a normal of their plane.
template <class Integer>
struct Span {
  int rank = 0;
  Vec3<Integer> normal;
};

/// Of points[0], points[1], ..., over integers of any kind. Linear at worst; stops as soon as the
/// rank is 3. There must be a point.
template <class Integer, class Points>
Span<Integer> affine_span(const Points& points, std::size_t size) {
  Span<Integer> span;
  const Vec3<Integer> origin = points[0];
  Vec3<Integer> direction;
  for (std::size_t i = 1; i < size && span.rank < 3; ++i) {
    Vec3<Integer> d = points[i] - origin;
    if (span.rank == 0) {
      if (is_zero(d)) continue;
      direction = std::move(d);
      span.rank = 1;
    } else if (span.rank == 1) {
      span.normal = cross(direction, d);
      if (!is_zero(span.normal)) span.rank = 2;
    } else if (sgn(dot(span.normal, d)) != 0) {
      span.rank = 3;
    }
  }
  return span;
}

/// Indices in a polytope.
using VertexId = kernels::Id<struct VertexTag>;
using FacetId = kernels::Id<struct FacetTag>;

/// The edge from vertex `from` to vertex `to`; seen from outside, facet `left` lies to its left and
/// `right` to its right. So normal(left) x normal(right) is a positive multiple of to - from.
struct Edge {
  VertexId from, to;
  FacetId left, right;
};

/// Corners (vertices, counter-clockwise seen from outside, none collinear) are corners[begin, end)
/// of the polytope.
struct Facet {
  Vector normal;  ///< outward, primitive
  std::uint32_t begin, end;
};

/// A convex polytope of rank 0 (a point), 1 (a segment), 2 (a convex polygon) or 3. Rank 2 has two
/// facets on the same corners, facet 0 with normal N, counter-clockwise seen from N's side, and
/// facet 1 with -N and the reverse cycle; every edge runs along facet 0's cycle, with left = 0 and
/// right = 1. Rank 1 has one edge, whose facets are none. The facets' ranges of corners follow one
/// another and fill `corners`.
struct Polytope {
  int rank = 0;
  kernels::IdVector<VertexId, Vector> vertices;
  kernels::IdVector<VertexId, std::uint32_t> input_ids;  ///< of equal input points the lowest. Ascending.
  std::vector<Edge> edges;
  kernels::IdVector<FacetId, Facet> facets;
  std::vector<VertexId> corners;
};

/// The dimension of the affine span of a non-empty set. Linear at worst; stops as soon as it is 3.
int affine_rank(std::span<const Vector> points);

/// Exact for integers of any size; about n log n steps for n points in common position, never
/// recursive. The result depends on the points and their numbering alone, and is written in one way
/// only: each cycle starts at its lowest vertex, facets are ordered by cycle; edges of rank 3 have
/// from < to and are ordered by (from, to); those of rank 2 follow facet 0's cycle; the one of rank
/// 1 runs from 0 to 1. Of the normals of a polygon N is the one whose first component other than
/// zero is positive. Throws std::invalid_argument when `points` is empty or holds 2^31 points or
/// more.                                                                       [proofs/polytope.md]
Polytope convex_hull(std::span<const Vector> points);
/// The hull of points that no other body has to share a lattice with: `vertices` are in a unit of
/// their own. Throws as `place` does.
Polytope hull_of(const std::vector<Point>& points);

/// Checks every law of the types above, Euler's formula, and convexity at every edge and every
/// vertex: so far O(n log n), and enough for a convex polytope [proofs/polytope.md, lemma 4].
/// `thorough` checks also that no input point lies outside it, in O(facets * points). Safe on any
/// value, however broken.
[[nodiscard]] kernels::Report validate(const Polytope& polytope, std::span<const Vector> points, bool thorough = true);

// The same of points in one plane, over integers of any kind.

/// The corners of the hull of points[i], for the indices i in `ids`, counter-clockwise seen from
/// the tip of u; of equal points the lowest index stands for all. A segment has two corners, a
/// point one. The points lie in a plane orthogonal to u, not zero. Exact for integers of any kind
/// that hold twice the square of a difference of two coordinates. The two chains of Andrew (1979)
/// on the points seen along an axis that the plane is not parallel to: n log n steps.
template <class Integer, class Points>
std::vector<std::uint32_t> polygon_corners(const Points& points, std::vector<std::uint32_t> ids,
                                           const Vec3<Integer>& u) {
  if (ids.size() == 1) return ids;
  struct Seen {
    Integer x, y;
    std::uint32_t id;
  };
  std::vector<Seen> seen;
  seen.reserve(ids.size());
  const int side = sgn(u.z) != 0 ? sgn(u.z) : sgn(u.x) != 0 ? sgn(u.x) : sgn(u.y);
  for (const std::uint32_t i : ids) {
    Vec3<Integer> p = points[i];
    if (sgn(u.z) != 0) seen.push_back({std::move(p.x), std::move(p.y), i});
    else if (sgn(u.x) != 0) seen.push_back({std::move(p.y), std::move(p.z), i});
    else seen.push_back({std::move(p.z), std::move(p.x), i});
  }
  std::sort(seen.begin(), seen.end(), [](const Seen& p, const Seen& q) {
    const int in_x = cmp(p.x, q.x), order = in_x != 0 ? in_x : cmp(p.y, q.y);
    return order != 0 ? order < 0 : p.id < q.id;
  });
  seen.erase(
      std::unique(seen.begin(), seen.end(), [](const Seen& p, const Seen& q) { return p.x == q.x && p.y == q.y; }),
      seen.end());

  // Below the chord from the first to the last, and back above it.
  const auto turns_left = [](const Seen& o, const Seen& p, const Seen& q) {
    return cmp(Integer((p.x - o.x) * (q.y - o.y)), Integer((p.y - o.y) * (q.x - o.x))) > 0;
  };
  std::vector<const Seen*> cycle;
  std::size_t kept = 0;  // of the cycle, which no later point takes away
  const auto add = [&](const Seen& p) {
    while (cycle.size() >= kept + 2 && !turns_left(*cycle[cycle.size() - 2], *cycle.back(), p)) cycle.pop_back();
    cycle.push_back(&p);
  };
  for (const Seen& p : seen) add(p);
  kept = cycle.size() - 1;
  for (std::size_t i = seen.size() - 1; i-- > 0;) add(seen[i]);
  if (cycle.size() > 1) cycle.pop_back();  // the first again
  if (side < 0) std::reverse(cycle.begin(), cycle.end());
  ids.clear();
  for (const Seen* p : cycle) ids.push_back(p->id);
  return ids;
}

}  // namespace fathom::polytope
