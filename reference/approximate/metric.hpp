// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, and a convex polytope Q with O in its interior: the unit ball of a norm if Q
//         is symmetric about O, else of a gauge.
// Output  the exact Q-depth: the least s >= 0 such that some translation of A by a vector of s Q
//         makes the interiors disjoint. [AGHRS, section 3.1, Corollary 3.4]
// Time    one ray of O(log^2(m + n)) steps for each of Q's k vertices, once the hierarchies stand.
#pragma once

#include <cstdint>
#include <vector>

#include "fathom/approximate.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

/// In integers: vertices of the ball and points of the lattice as they are.
struct MetricDepth {
  bool inside = false;     ///< whether O is in P, its boundary included. If not, no other field is set.
  mpq_class depth;         ///< in multiples of ball.vertices, taken as integer vectors of the lattice
  std::uint64_t rays = 0;  ///< shot
  /// Vertices of the ball whose rays leave P first, ascending. Empty when the depth is 0.
  struct Deciding {
    std::uint32_t vertex;
    Vector normal;  ///< primitive outward normal of a facet of P that holds the hit point
  };
  std::vector<Deciding> deciding;
};

/// P = B (+) (-A), seen from the point `shift` of the lattice in place of O: A moved by `shift`,
/// without new hierarchies.
MetricDepth metric_depth(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                         const UnitBall& ball, const Vector& shift = {0, 0, 0});

}  // namespace fathom::approximate
