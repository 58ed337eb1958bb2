// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of convex_hull: equal points are found by hashing, triangles cover the boundary,
// coplanar ones are merged.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// A hash of all limbs: in a scaled integer the lowest ones are often zero.
inline std::size_t hash_value(const mpz_class& n) {
  const char* limbs = reinterpret_cast<const char*>(mpz_limbs_read(n.get_mpz_t()));
  const std::size_t hash = std::hash<std::string_view>{}({limbs, mpz_size(n.get_mpz_t()) * sizeof(mp_limb_t)});
  return sgn(n) < 0 ? ~hash : hash;
}

inline std::size_t hash_value(const Vector& v) {
  constexpr std::size_t odd = 0x9e3779b97f4a7c15;
  return (hash_value(v.x) * odd + hash_value(v.y)) * odd + hash_value(v.z);
}

struct HashOfPoint {
  std::span<const Vector> points;
  std::size_t operator()(std::uint32_t i) const { return hash_value(points[i]); }
};

struct SamePoint {
  std::span<const Vector> points;
  bool operator()(std::uint32_t i, std::uint32_t j) const { return points[i] == points[j]; }
};

/// Indices of points, no two of equal points.
using DistinctPoints = std::unordered_set<std::uint32_t, HashOfPoint, SamePoint>;

inline DistinctPoints no_points_yet(std::span<const Vector> points, std::size_t expected) {
  return DistinctPoints(expected, HashOfPoint{points}, SamePoint{points});
}

/// Three indices of points, counter-clockwise seen from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

/// Triangles that cover the boundary of the hull of points[id], id in `ids`, once. Exact for
/// integers of any size. No triangle is degenerate; neighbours may be coplanar and corners may lie
/// inside a facet or an edge. `ids` must be distinct points that affinely span space.
std::vector<HullTriangle> hull_triangles(std::span<const Vector> points, std::span<const std::uint32_t> ids);

/// The corners of the hull of points[id], id in `ids`, in the projection that forgets coordinate
/// `axis` (0, 1, 2 for x, y, z): extreme points only, counter-clockwise seen from the positive end
/// of that axis. Exact. `ids` must have distinct projections that affinely span the plane.
std::vector<std::uint32_t> hull_cycle(std::span<const Vector> points, std::span<const std::uint32_t> ids, int axis);

/// Up to so many points hull_triangles_of_few is used: it is quadratic, and near 20 points, as most
/// bodies have, several times as fast.
inline constexpr std::size_t few_points = 64;

/// Returns triangles as hull_triangles states, in general others where points are coplanar.
std::vector<HullTriangle> hull_triangles_of_few(std::span<const Vector> points, std::span<const std::uint32_t> ids);

/// The polytope of rank 3 whose boundary `triangles` cover as hull_triangles states. Exact, O(n log
/// n).                                                                         [proofs/polytope.md]
Polytope merge_coplanar(std::span<const Vector> points, std::span<const HullTriangle> triangles);

// The naive twin of convex_hull: supporting planes through all triples of points. For tests and
// small inputs: O(n^4) and worse.

/// A hull as sets of input ids (of equal points the lowest), so that it can be compared without
/// regard to numbering.
struct NaiveHull {
  int rank = 0;
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  ///< lower id first
  /// Primitive outward normal and ids of the corners, ascending. Rank 2: the polygon with either
  /// normal.
  std::set<std::pair<std::vector<mpz_class>, std::vector<std::uint32_t>>> facets;
  friend bool operator==(const NaiveHull&, const NaiveHull&) = default;
};

/// By the definitions. Exact. `points` must not be empty.
NaiveHull convex_hull_naive(std::span<const Vector> points);

}  // namespace fathom::polytope
