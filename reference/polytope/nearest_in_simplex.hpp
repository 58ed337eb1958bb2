// SPDX-License-Identifier: GPL-3.0-or-later
// The step that the searches of Gilbert, Johnson and Keerthi share: the point of a simplex nearest to O, exactly.     [proofs/distance.md]
#pragma once

#include <optional>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {

/// A difference and its place.
struct SimplexCorner {
  Difference ids;
  Vector p;
};

/// point / denominator, a convex combination with weights / denominator.
struct SimplexFoot {
  Vector point;
  std::vector<mpz_class> weights;
  mpz_class denominator;
};

/// Of one to four corners, affinely independent: keeps those of the face that holds the point of their hull nearest to O in its relative
/// interior, and returns that point. There is one such face. Only faces with the last corner are looked at: O must be strictly nearer to
/// the hull of all than to that of the others, if there are others. Returns nullopt, and keeps all, if O is in the interior of a
/// tetrahedron.
std::optional<SimplexFoot> nearest_in_simplex(std::vector<SimplexCorner>& corners);

}  // namespace fathom::polytope
