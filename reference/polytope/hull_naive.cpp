// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <iterator>

#include "reference/polytope/hull.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;
using Ids = std::vector<Index>;

Ids lowest_ids(std::span<const Vector> points) {
  Ids ids;
  for (Index i = 0; i < points.size(); ++i) {
    if (std::ranges::none_of(ids, [&](Index j) { return points[i] == points[j]; })) ids.push_back(i);
  }
  return ids;
}

/// Calls f(i, j, k) for all i < j < k of ids.
void for_each_triple(const Ids& ids, const std::function<void(Index, Index, Index)>& f) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (std::size_t j = i + 1; j < ids.size(); ++j) {
      for (std::size_t k = j + 1; k < ids.size(); ++k) f(ids[i], ids[j], ids[k]);
    }
  }
}

struct Naive {
  std::span<const Vector> points;
  Ids ids;

  [[nodiscard]] Vector normal(Index i, Index j, Index k) const {
    return cross(points[j] - points[i], points[k] - points[i]);
  }

  /// p lies between q and r.
  [[nodiscard]] bool in_segment(Index p, Index q, Index r) const {
    const Vector pq = points[q] - points[p], pr = points[r] - points[p];
    return is_zero(cross(pq, pr)) && dot(pq, pr) < 0;
  }

  /// p, in the plane of the triangle, lies in it: no side has p strictly on its outer side.
  [[nodiscard]] bool in_triangle(Index p, Index q, Index r, Index s) const {
    const Vector n = normal(q, r, s);
    return !is_zero(n) && dot(n, normal(p, q, r)) >= 0 && dot(n, normal(p, r, s)) >= 0 && dot(n, normal(p, s, q)) >= 0;
  }

  /// By Caratheodory's theorem a point of a coplanar set is a corner iff no segment and no triangle
  /// of the others holds it.
  [[nodiscard]] Ids corners(const Ids& coplanar) const {
    Ids result;
    for (const Index p : coplanar) {
      Ids others;
      std::ranges::copy_if(coplanar, std::back_inserter(others), [&](Index q) { return q != p; });
      bool held = false;
      for (const Index q : others) {
        for (const Index r : others) held = held || in_segment(p, q, r);
      }
      for_each_triple(others, [&](Index q, Index r, Index s) { held = held || in_triangle(p, q, r, s); });
      if (!held) result.push_back(p);
    }
    return result;
  }

  /// The ids on the plane through p with normal n, if no point lies above it.
  [[nodiscard]] Ids supported(const Vector& n, Index p) const {
    Ids on;
    for (const Index q : ids) {
      const int side = sgn(dot(n, points[q] - points[p]));
      if (side > 0) return {};
      if (side == 0) on.push_back(q);
    }
    return on;
  }

  void add_facets(NaiveHull& hull) const {
    for_each_triple(ids, [&](Index i, Index j, Index k) {
      const Vector some = normal(i, j, k);
      if (is_zero(some)) return;
      for (const Vector& n : {primitive(some), primitive(-some)}) {
        const std::vector<mpz_class> key{n.x, n.y, n.z};
        const auto known = hull.facets.lower_bound({key, {}});
        if (known != hull.facets.end() && known->first == key) continue;
        if (const Ids on = supported(n, i); !on.empty()) hull.facets.insert({key, corners(on)});
      }
    });
  }

  /// Neighbours on a convex polygon have all other corners on one side of their line.
  void add_edges_of_polygon(NaiveHull& hull, const Ids& cycle, const Vector& n) const {
    for (const Index p : cycle) {
      for (const Index q : cycle) {
        if (p == q) continue;
        const bool all_left =
            std::ranges::all_of(cycle, [&](Index r) { return r == p || r == q || dot(n, normal(p, q, r)) > 0; });
        if (all_left) hull.edges.insert(std::minmax(p, q));
      }
    }
  }
};

}  // namespace

NaiveHull convex_hull_naive(std::span<const Vector> points) {
  const Naive naive{points, lowest_ids(points)};
  NaiveHull hull;
  naive.add_facets(hull);
  for (const auto& [n, corners] : hull.facets) {
    hull.vertices.insert(corners.begin(), corners.end());
    naive.add_edges_of_polygon(hull, corners, {n[0], n[1], n[2]});
  }
  if (hull.facets.empty()) {
    const Ids ends = naive.corners(naive.ids);
    hull.vertices.insert(ends.begin(), ends.end());
    if (ends.size() == 2) hull.edges.insert({ends[0], ends[1]});
  }
  const bool flat = std::ranges::any_of(hull.facets, [&](const auto& f) {
    return hull.facets.contains({{mpz_class(-f.first[0]), mpz_class(-f.first[1]), mpz_class(-f.first[2])}, f.second});
  });
  hull.rank = hull.facets.empty() ? static_cast<int>(hull.vertices.size()) - 1 : flat ? 2 : 3;
  return hull;
}

}  // namespace fathom::polytope
