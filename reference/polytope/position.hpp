// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets A and B.
// Output  whether O lies inside P = B (+) (-A), on its boundary or outside, with a proof; of sets
//         that are apart the exact distance: the point of P nearest to O, as convex weights of
//         both. [AGHRS, section 2.2, step before the algorithm; proofs/position.md, distance.md]
// Time    linear expected in |A| + |B| for the position.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {

enum class Position { inside, boundary, outside };

/// Below, h(u) = max_b <u,b> - min_a <u,a> is the support function of P.
struct PositionOfOrigin {
  Position position = Position::outside;
  /// outside: primitive u with h(u) < 0. boundary: primitive u with h(u) = 0. inside: none.
  std::optional<Vector> normal;
  /// inside and boundary: convex weights (each list sums to 1) with sum of weighted a = sum of
  /// weighted b. outside: empty.
  std::vector<Weight> a, b;
  /// inside: index pairs (a, b) whose differences b - a have O in the interior of their convex
  /// hull. Otherwise empty.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> surrounding;
  std::size_t scans = 0;  ///< linear scans over all points that it took

  friend bool operator==(const PositionOfOrigin&, const PositionOfOrigin&) = default;
};

/// The clouds must have the same exponent and be non-empty: std::invalid_argument. In either kind
/// of integers the steps are the same, and so is the answer.
template <class Body>
PositionOfOrigin position_of_origin(DifferencesOf<Body> differences);
inline PositionOfOrigin position_of_origin(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  return position_of_origin(Differences{a, b});
}

/// Checks the proof, and nothing but the proof.
[[nodiscard]] kernels::Report validate(const PositionOfOrigin& answer, std::span<const Vector> a,
                                       std::span<const Vector> b);

/// The least |b - a| of two sets whose hulls have no point in common. With it the depth becomes one
/// exact signed function of a sweep across contact. The nearest point of P is z = (h(n) / <n,n>) n
/// for n = `normal`, as for a penetrating pair, with h(n) < 0.
struct NearestPoints {
  Vector normal;             ///< primitive; -z is a positive multiple of it, and h(normal) / |normal| is -distance
  mpz_class height;          ///< h(normal) < 0. distance^2 = height^2 / <normal,normal>
  std::vector<Weight> a, b;  ///< convex weights of points with sum of weighted b - sum of weighted a = z
  std::size_t scans = 0;     ///< linear scans over all points that it took

  friend bool operator==(const NearestPoints&, const NearestPoints&) = default;
};

/// The clouds must have the same exponent and be non-empty, and O must lie outside P. Exact, and
/// the same in either kind of integers. Throws std::invalid_argument otherwise.
template <class Body>
NearestPoints nearest_points(DifferencesOf<Body> differences);
/// The same; nullopt if O lies in P.
template <class Body>
std::optional<NearestPoints> nearest_points_if_apart(DifferencesOf<Body> differences);
inline NearestPoints nearest_points(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  return nearest_points(Differences{a, b});
}

/// Of bodies of more points together samples are searched, in integers of any size
/// (proofs/position.md, "Linear expected time").
inline constexpr std::size_t most_points_without_samples = 2000;

/// Calls f with the pair in integers that hold all that these two searches compute, for
/// coordinates of any narrow lattice: of fixed size, unless samples are searched.
template <class F>
auto with_searched_pair(const NarrowMemory& placed, const Points& a, const Points& b, kernels::ScanMemory& memory,
                        F f) {
  if (a.size() + b.size() > most_points_without_samples) return f(widened(placed, b[0].exact()));
  return f(placed.pair<NarrowInteger>(a, b, memory));
}

/// Checks the weights and that no point of P is nearer to O, and nothing else. Exact arithmetic
/// only.
[[nodiscard]] kernels::Report validate(const NearestPoints& answer, std::span<const Vector> a,
                                       std::span<const Vector> b);

/// A difference and its place.
template <class Integer>
struct SimplexCorner {
  Difference ids;
  Vec3<Integer> p;
};

/// point / denominator, a convex combination with weights / denominator.
template <class Integer>
struct SimplexFoot {
  Vec3<Integer> point;
  std::vector<Integer> weights;
  Integer denominator;
};

/// The step that the searches of Gilbert, Johnson and Keerthi share. Of one to four corners,
/// affinely independent: keeps those of the face that holds the point of their hull nearest to O in
/// its relative interior, and returns that point. There is one such face. Only faces with the last
/// corner are looked at: O must be strictly nearer to the hull of all than to that of the others,
/// if there are others. Returns nullopt, and keeps all, if O is in the interior of a tetrahedron.
template <class Integer>
std::optional<SimplexFoot<Integer>> nearest_in_simplex(std::vector<SimplexCorner<Integer>>& corners);

}  // namespace fathom::polytope
