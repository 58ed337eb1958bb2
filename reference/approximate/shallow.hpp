// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and a rational delta, 0 < delta <= 2.
// Output  the exact depth with every optimum, by looking at the facets of P = B (+) (-A) near O
//         alone. [AGHRS, SHALLOW-PENETRATION, Theorem 3.5; proofs/shallow.md]
// Time    with the hierarchies built: O(1 / delta) rays, and a walk over at most K_delta facets,
//         those within (1 + delta) depth of O. Departs from the paper: the grid is that for delta /
//         4, and a search starts from the facet that a ray hits.                 [proofs/errata.md]
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fathom/approximate.hpp"
#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "kernels/nearest.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/approximate/shallow_surface.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

// The rays.
// Input   two bodies, and a rational delta > 0.
// Output  Delta with depth <= Delta <= (1 + delta) depth, and every direction u of the grid for
//         delta with Delta(u) <= (1 + delta) Delta, where Delta(u) is how far the boundary of P is
//         from O along u.                                [AGHRS, SHALLOW-PENETRATION, steps 1 to 3]
// Departs from the paper: from coarse grids to fine ones, and no ray is shot where those before
// show that it is too long. Far sides of P take few rays.                       [proofs/shallow.md]

/// A ray that was shot from O, which is inside P.
struct NearRay {
  Vector direction;
  Vector normal;             ///< of a facet of P that it hits
  mpq_class factor;          ///< factor * direction is on the boundary
  mpq_class length_squared;  ///< of factor * direction
};

struct NearRays {
  bool inside = false;            ///< whether O is in the interior of P; if not, nothing more is found
  mpq_class nearest_squared;      ///< Delta^2: the squared distance of the nearest plane of a facet that was hit
  std::vector<NearRay> in_reach;  ///< the rays, of all grids, with Delta(u) <= (1 + delta) Delta
  std::uint64_t rays = 0;         ///< shot
  std::uint64_t skipped = 0;      ///< directions of the grids in which no ray was needed
  std::uint64_t steps = 0;        ///< that the rays took
};

/// The gauge of P about O: gauge(u) = 1 / f where f u is on the boundary. It is sublinear, so that
/// few rays bound it everywhere from above.
class GaugeBound {
 public:
  /// The first six rays must be those along x, -x, y, -y, z, -z; the factors of all are positive.
  void add(const NearRay& ray);

  /// Whether the rays along the axes and the one closest to u show that gauge(u)^2 bound_squared <
  /// 1. Exact; false proves nothing.
  [[nodiscard]] bool below(const Vector& u, const mpq_class& bound_squared) const;

 private:
  struct Known {
    Vector direction;
    mpq_class gauge;
  };
  [[nodiscard]] mpq_class along_axes(const std::array<mpq_class, 3>& r) const;
  [[nodiscard]] mpq_class along(const Vector& u, const Known& known) const;

  std::vector<Known> axes_, others_;
};

/// The six axes, the grids for 1/4, 1/16, ..., and at last that for delta.
class RayGrids {
 public:
  /// Throws std::invalid_argument unless delta > 0.
  RayGrids(kernels::Context& context, const mpq_class& delta);

  /// From `start` in place of O, in lattice units. Throws Interrupted.
  [[nodiscard]] NearRays shoot(kernels::Context& context, const RayShooter& shooter, const Vector& start) const;

 private:
  struct Grid {
    mpq_class delta;
    std::vector<Vector> directions;
  };
  std::vector<Grid> grids_;
};

// The walk over the facets of P near a point: breadth first, from facet to facet across the edges
// that meet a ball. P is never built.
//                                           [AGHRS, SHALLOW-PENETRATION, step 5; proofs/shallow.md]

/// The closed ball of points x with denominator |x - centre|^2 <= numerator.
struct Ball {
  Vector centre;
  mpz_class numerator, denominator = 1;  ///< >= 0 and > 0

  [[nodiscard]] bool holds(const Vector& p) const;
  /// Whether the segment from p to q, which differ, meets the ball. Exact.
  [[nodiscard]] bool meets(const Vector& p, const Vector& q) const;
};

struct WalkCounts {
  std::uint64_t facets = 0;  ///< visited
  std::uint64_t edges = 0;   ///< of these facets, one that two of them share counted once
  std::uint64_t steps = 0;   ///< corners of faces and neighbours of vertices that were looked at
};

/// Called once for each facet.
using VisitFacet = std::function<void(const SumFacet& facet)>;

/// Visits the starts, and every facet that shares an edge which meets the ball with a visited one.
/// Throws Interrupted.
WalkCounts walk(kernels::Context& context, const SumSurface& surface, const Ball& ball,
                std::span<const SumFacet> starts, const VisitFacet& visit);

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

/// Two bodies made ready for queries from many places. Refers to the hierarchies and their
/// polytopes, which must outlive it.
class ShallowPenetration {
 public:
  /// O(m + n + 1 / delta), except for sorting. Throws std::invalid_argument unless 0 < delta <= 2.
  ShallowPenetration(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                     const mpq_class& delta = mpq_class(1, 4));

  /// The depth of A moved by `shift`, in lattice units: P seen from `shift` in place of O; nothing
  /// is prepared anew. Exact. Throws Interrupted.
  [[nodiscard]] ShallowResult query(kernels::Context& context, const Vector& shift = {0, 0, 0}) const;

 private:
  const polytope::Hierarchy* a_;
  const polytope::Hierarchy* b_;
  RayShooter shooter_;
  SumSurface surface_;
  mpq_class delta_;
  RayGrids grids_;
};

/// Checks that each nearest plane is that of a facet of P, at the same distance, seen from `shift`;
/// not that no facet is nearer.
[[nodiscard]] kernels::Report validate(const ShallowResult& result, const polytope::Hierarchy& a,
                                       const polytope::Hierarchy& b, const Vector& shift = {0, 0, 0});

}  // namespace fathom::approximate
