// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of a small cone in R^4, exactly: the one piece of linear algebra that the position of O needs.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::polytope {

/// A vector of R^4.
struct Lifted {
  Vector v;
  mpz_class w;
};

/// <g, h> in R^4.
mpz_class dot(const Lifted& g, const Lifted& h);

/// The point of a cone that is nearest to a target, as a combination with positive weights; exact.
struct NearestInCone {
  std::vector<std::size_t> support;  ///< indices of the generators that it combines, ascending
  std::vector<mpz_class> weights;    ///< > 0, one for each of them, over `denominator`
  mpz_class denominator = 1;         ///< > 0
  Lifted residual;                   ///< target - nearest, times a positive rational: zero, or without a common divisor
};

/// The nearest point of the cone of `generators` to `target`. There are one to four of them, linearly independent, and the target lies
/// strictly nearer to their cone than to the cone of all but the last (so the last one is in the support).
/// The residual is orthogonal to the support and has no positive product with any generator, which proves the point nearest.
NearestInCone nearest_in_cone(std::span<const Lifted> generators, const Lifted& target);

}  // namespace fathom::polytope
