// SPDX-License-Identifier: GPL-3.0-or-later
// Input   any points in one plane: duplicates, collinear and interior ones welcome.
// Output  the corners of the convex polygon that they span.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::polytope {

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
