// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a rational delta > 0.
// Output  an exact separating translation t with depth <= |t| <= (1 + delta) depth.
//                                                           [AGHRS, APPROX-SEPARATION, Theorem 3.2]
// Time    O(1 / delta) rays of O(log^2(m + n)) steps each, once the hierarchies stand.
// Departs from the paper: directions are rational, one for each cell of a grid on the faces of a
//         cube; the criterion is tan^2(angle) <= 2 delta + delta^2, which is decided exactly and
//         suffices for every delta > 0; and each ray offers the plane of the facet that it hits in
//         place of the hit point, which is never farther and often the optimum itself.
//                                                       [proofs/approximate.md, proofs/errata.md]
#pragma once

#include <array>
#include <cstdint>

#include "fathom/approximate.hpp"
#include "kernels/context.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

// Step 1: a grid of directions that covers the sphere densely enough.

/// Whether <v,p> > 0 and (1 + delta)^2 <v,p>^2 >= |v|^2 |p|^2: then a ray along p is at most 1 +
/// delta times as long as the one along v to the plane whose normal is v.
bool covers(const Vector& p, const Vector& v, const mpq_class& delta);

/// The least delta that is accepted: smaller ones would need more directions than any run can try.
inline const mpq_class least_delta(1, 1'000'000'000);

/// Every v other than 0 lies in the cone of a cell, whose centre covers it.
class DirectionGrid {
 public:
  /// 6 directions at least; about 4 / delta for small delta. Deterministic.
  /// Throws std::invalid_argument unless delta >= least_delta. Throws Interrupted.
  DirectionGrid(kernels::Context& context, const mpq_class& delta);

  /// Of cells. Those from size() / 2 on are the opposites of those before, in another order.
  [[nodiscard]] std::uint64_t size() const { return 6 * side_ * side_; }
  /// Of cells along an edge of the cube.
  [[nodiscard]] std::uint64_t side() const { return side_; }
  /// The direction of the grid in that cell; primitive.
  [[nodiscard]] Vector centre(std::uint64_t cell) const;
  /// The four directions that span the cell's cone, in cyclic order; primitive.
  [[nodiscard]] std::array<Vector, 4> corners(std::uint64_t cell) const;

 private:
  std::uint64_t side_;
};

// Step 2: a ray along each.

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
