// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a rational delta > 0.
// Output  an exact separating translation t with depth <= |t| <= (1 + delta) depth.        [AGHRS, APPROX-SEPARATION, Theorem 3.2]
// Time    O(1 / delta) rays of O(log^2(m + n)) steps each, once the hierarchies stand.
// Departs from the paper: the grid, see grid/directions.hpp; and each ray offers the plane of the facet that it hits in place of the
// hit point, which is never farther and often the optimum itself.                                   [proofs/approximate.md]
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom {

/// In the unit of the lattice. With O on the boundary of P all lengths are 0; then, and outside, normal and ray are zero vectors.
struct ApproxSeparation {
  bool inside = false;      ///< whether O is in P, its boundary included. If not, nothing else is said.
  std::uint64_t rays = 0;   ///< shot
  std::uint64_t steps = 0;  ///< that they took
  Vector normal{0, 0, 0};   ///< primitive outward normal of the nearest facet that was hit; of several, the least lexicographically
  mpz_class height;         ///< of its plane above the viewpoint: the translation (height / <normal,normal>) normal separates
  Vector ray{0, 0, 0};      ///< the direction of the grid in which the boundary of P is nearest
  mpq_class reach_squared;  ///< squared distance of the boundary along that ray: |t|^2 <= reach_squared <= (1 + delta)^2 depth^2
};

/// P = B (+) (-A), seen from the point `shift` of the lattice in place of O: A moved by `shift`, without new hierarchies.
/// Throws std::invalid_argument unless delta >= least_delta of the grid, 1e-9, and Interrupted.
ApproxSeparation approx_separation(Context& context, const Hierarchy& a, const Hierarchy& b, const mpq_class& delta,
                                   const Vector& shift = {0, 0, 0});

/// For a body against itself: P is symmetric about O, and half of the rays suffice.                         [AGHRS, Corollary 3.3]
ApproxSeparation approx_width(Context& context, const Hierarchy& body, const mpq_class& delta);

/// A depth within a known factor: bound <= the true depth <= |translation| <= (1 + delta) bound.
struct ApproxPenetration {
  mpq_class squared;               ///< |translation|^2
  mpq_class bound_squared;         ///< a lower bound of depth^2
  Vector direction;                ///< primitive outward normal of a facet of P: one, without a claim that it is an optimum
  Point translation;               ///< to the facet's plane, along the direction
  Contact contact;                 ///< in that direction
  std::optional<Witness> witness;  ///< only where the foot of O on the facet's plane lies in the facet
  std::uint64_t rays = 0, steps = 0;
};

struct ApproxDepth : SeparationOr<ApproxPenetration> {
  mpq_class delta;

  /// 0 unless penetrating, as the next.
  [[nodiscard]] mpq_class squared() const { return penetration() ? penetration()->squared : mpq_class(0); }
  [[nodiscard]] mpq_class bound_squared() const { return penetration() ? penetration()->bound_squared : mpq_class(0); }
  [[nodiscard]] Point translation() const { return penetration() ? penetration()->translation : Point(); }
  /// Of the penetration, or of the separation.
  [[nodiscard]] const Vector& direction() const { return penetration() ? penetration()->direction : separation()->normal; }
};

/// For all statuses and ranks. Throws std::invalid_argument when a body is empty or delta is below 1e-9, and Interrupted.
ApproxDepth approx_depth(std::span<const Point> a, std::span<const Point> b, const mpq_class& delta, Monitor* monitor = nullptr);

/// The same for the width of one body, as the depth of the body against itself.
ApproxDepth approx_width(std::span<const Point> points, const mpq_class& delta, Monitor* monitor = nullptr);

}  // namespace fathom
