// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, and a convex polytope Q with O in its interior: the unit ball of a norm if Q is symmetric about O, else of a gauge.
// Output  the exact Q-depth: the least s >= 0 such that some translation of A by a vector of s Q makes the interiors disjoint.
//         [AGHRS, section 3.1, Corollary 3.4]
// Time    one ray of O(log^2(m + n)) steps for each of Q's k vertices, once the hierarchies stand.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom {

/// A point set that is no unit ball: its hull is flat, or does not have O in its interior. what() says which.
struct NoUnitBall : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The unit ball Q, checked. Vertices are integer multiples of 1 / denominator.
struct UnitBall {
  std::vector<Vector> vertices;          ///< extreme points only
  std::vector<std::uint32_t> input_ids;  ///< of each vertex; of equal input points the lowest. Ascending.
  mpz_class denominator = 1;
  bool symmetric = false;  ///< about O: a norm. Else a gauge: the length of -t may differ from that of t.
};

/// Throws NoUnitBall, and std::invalid_argument when there are no points.
UnitBall unit_ball(std::span<const Point> points);

/// In integers: vertices of the ball and points of the lattice as they are.
struct MetricDepth {
  bool inside = false;     ///< whether O is in P, its boundary included. If not, nothing else is said.
  mpq_class depth;         ///< so many multiples of ball.vertices, as integer vectors, in the unit of the lattice
  std::uint64_t rays = 0;  ///< shot
  /// Vertices of the ball whose rays leave P first, ascending. Empty when the depth is 0.
  struct Deciding {
    std::uint32_t vertex;
    Vector normal;  ///< primitive outward normal of a facet of P that holds the hit point
  };
  std::vector<Deciding> deciding;
};

/// P = B (+) (-A), seen from the point `shift` of the lattice in place of O: A moved by `shift`, without new hierarchies.
MetricDepth metric_depth(Context& context, const Hierarchy& a, const Hierarchy& b, const UnitBall& ball, const Vector& shift = {0, 0, 0});

/// A shortest way out in the metric of Q: along a vertex of Q.
struct MetricOptimum {
  std::uint32_t vertex;  ///< id of the input point of Q
  Point translation;     ///< depth times that vertex
  Vector direction;      ///< primitive outward normal of a facet of P that holds the translation
  Contact contact;       ///< in that direction
  Witness witness;       ///< points of the contact with b - a = translation
};

struct MetricPenetration {
  mpq_class depth;                    ///< > 0: the Q-length of each optimum's translation
  std::vector<MetricOptimum> optima;  ///< one per deciding vertex, by ascending id; at least one
  std::uint64_t rays = 0;
};

struct MetricResult : SeparationOr<MetricPenetration> {
  /// 0 unless penetrating.
  [[nodiscard]] mpq_class depth() const { return penetration() ? penetration()->depth : mpq_class(0); }
  /// Empty unless penetrating.
  [[nodiscard]] const std::vector<MetricOptimum>& optima() const;
  /// Of the first optimum, or of the separation.
  [[nodiscard]] const Vector& direction() const { return penetration() ? optima().front().direction : separation()->normal; }
};

/// For all statuses and ranks. Throws std::invalid_argument when a body is empty, and Interrupted.
MetricResult metric_depth(std::span<const Point> a, std::span<const Point> b, const UnitBall& ball, Monitor* monitor = nullptr);

}  // namespace fathom
