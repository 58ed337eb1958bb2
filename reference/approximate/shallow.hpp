// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a rational delta, 0 < delta <= 2.
// Output  the exact depth with every optimum, by looking at the facets of P = B (+) (-A) near O alone.
//         [AGHRS, SHALLOW-PENETRATION, Theorem 3.5; proofs/shallow.md]
// Time    with the hierarchies built: O(1 / delta) rays, and a walk over at most K_delta facets, those within (1 + delta) depth of O.
// Departs from the paper: the grid is that for delta / 4, and a search starts from the facet that a ray hits.   [proofs/errata.md]
#pragma once

#include <cstdint>

#include "fathom/approximate.hpp"
#include "kernels/nearest.hpp"
#include "kernels/report.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/approximate/shallow_surface.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

struct ShallowResult {
  bool inside = false;             ///< whether O is in the interior of P; if not, nothing more is found
  kernels::NearestPlanes nearest;  ///< the planes of all nearest facets of P, in lattice units
  std::uint64_t rays = 0;          ///< shot
  std::uint64_t rays_skipped = 0;  ///< directions of the grids in which no ray was needed
  std::uint64_t ray_steps = 0;     ///< that the rays took
  std::uint64_t starts = 0;        ///< facets from which the walk sets out
  std::uint64_t facets = 0;        ///< visited: at most K_delta
  std::uint64_t edges = 0;         ///< of these facets
  std::uint64_t walk_steps = 0;    ///< corners of faces and neighbours of vertices that were looked at
  mpq_class ball_radius_squared;   ///< of the ball within which the walk stays
};

/// Two bodies made ready for queries from many places. Refers to the hierarchies and their polytopes, which must outlive it.
class ShallowPenetration {
 public:
  /// O(m + n + 1 / delta), except for sorting. Throws std::invalid_argument unless 0 < delta <= 2.
  ShallowPenetration(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                     const mpq_class& delta = mpq_class(1, 4));

  /// The depth of A moved by `shift`, in lattice units: P seen from `shift` in place of O; nothing is prepared anew. Exact.
  /// Throws Interrupted.
  [[nodiscard]] ShallowResult query(kernels::Context& context, const Vector& shift = {0, 0, 0}) const;

 private:
  const polytope::Hierarchy* a_;
  const polytope::Hierarchy* b_;
  RayShooter shooter_;
  SumSurface surface_;
  mpq_class delta_;
  RayGrids grids_;
};

/// Checks that each nearest plane is that of a facet of P, at the same distance, seen from `shift`; not that no facet is nearer.
[[nodiscard]] kernels::Report validate(const ShallowResult& result, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                                       const Vector& shift = {0, 0, 0});

}  // namespace fathom::approximate
