// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, and a rational delta > 0.
// Output  Delta with depth <= Delta <= (1 + delta) depth, and every direction u of the grid for delta with Delta(u) <= (1 + delta) Delta,
//         where Delta(u) is how far the boundary of P is from O along u.           [AGHRS, SHALLOW-PENETRATION, steps 1 to 3]
// Departs from the paper: from coarse grids to fine ones, and no ray is shot where those before show that it is too long. Far sides of P
// take few rays.                                                                                               [proofs/shallow.md]
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernels/context.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"

namespace fathom::approximate {

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

/// The gauge of P about O: gauge(u) = 1 / f where f u is on the boundary. It is sublinear, so that few rays bound it everywhere from above.
class GaugeBound {
 public:
  /// The first six rays must be those along x, -x, y, -y, z, -z; the factors of all are positive.
  void add(const NearRay& ray);

  /// Whether the rays along the axes and the one closest to u show that gauge(u)^2 bound_squared < 1. Exact; false proves nothing.
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

}  // namespace fathom::approximate
