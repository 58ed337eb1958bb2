// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a rational delta > 0.
// Output  an exact separating translation t with depth <= |t| <= (1 + delta) depth.
//                                                           [AGHRS, APPROX-SEPARATION, Theorem 3.2]
// Time    O(1 / delta) rays of O(log^2(m + n)) steps each, once the hierarchies stand. Departs from
//         the paper: the grid, see directions.hpp; and each ray offers the plane of the facet that
//         it hits in place of the hit point, which is never farther and often the optimum itself.
//                                                                           [proofs/approximate.md]
#pragma once

#include <cstdint>

#include "fathom/approximate.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

/// In the unit of the lattice. With O on the boundary of P all lengths are 0; then, and outside,
/// normal and ray are zero vectors.
struct ApproxSeparation {
  bool inside = false;      ///< whether O is in P, its boundary included. If not, no other field is set.
  std::uint64_t rays = 0;   ///< shot
  std::uint64_t steps = 0;  ///< that they took
  Vector normal{            /// primitive outward normal of the nearest facet that was hit; of several, the least
                /// lexicographically
                0, 0, 0};
  mpz_class height;  ///< of its plane above the viewpoint: the translation (height / <normal,normal>) normal separates
  Vector ray{0, 0, 0};      ///< the direction of the grid in which the boundary of P is nearest
  mpq_class reach_squared;  ///< squared distance of the boundary along that ray: |t|^2 <= reach_squared <= (1 +
                            ///< delta)^2 depth^2
};

/// P = B (+) (-A), seen from the point `shift` of the lattice in place of O: A moved by `shift`,
/// without new hierarchies. Throws std::invalid_argument unless delta >= least_delta of the grid,
/// 1e-9, and Interrupted.
ApproxSeparation approx_separation(kernels::Context& context, const polytope::Hierarchy& a,
                                   const polytope::Hierarchy& b, const mpq_class& delta,
                                   const Vector& shift = {0, 0, 0});

/// For a body against itself: P is symmetric about O, and half of the rays suffice.
///                                                                           [AGHRS, Corollary 3.3]
ApproxSeparation approx_width(kernels::Context& context, const polytope::Hierarchy& body, const mpq_class& delta);

}  // namespace fathom::approximate
