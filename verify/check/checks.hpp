// SPDX-License-Identifier: Apache-2.0
// The checks of FORMAT.md, sections 4 and 12 to 15. Each returns if all is proved and throws a
// Fault otherwise.
#pragma once

#include <functional>
#include <vector>

#include "certificate.hpp"
#include "scaled.hpp"
#include "vectors.hpp"

namespace fathom_check {

/// A bound of h(n)/|n|, squared with its sign, in the units of the scaled points, in lowest terms.
struct Bound {
  mpz_class num, den;
};

/// All of it: the claim of `certificate` is proved by its parts.
void check_claim(const Certificate& certificate, Arithmetic arithmetic = Arithmetic::fixed_where_it_fits);

/// The upper side (section 5): each direction's height compared as the claim demands. If a core is
/// a half-space, the lower side too.
void check_directions(const Certificate& certificate, const Scaled& bodies, const Bound& low, const Bound& high);

/// The sum of weight * point, over a common denominator of the weights.
struct Combination {
  MutableVector sum;
  mpz_class den = 1;
};
/// Throws Fault (refused, on `line`) unless the weights are positive, of points that exist, and sum
/// to 1.
Combination convex_combination(const Weight* begin, const Weight* end, const Points& points, std::size_t line);

/// The weights are convex, and yield points of A and of B that are so near to each other that
/// h(n)/|n| is at least `low`.
void check_weights(const Certificate& certificate, const Points& a, const Points& b, const Bound& low);

/// <normal, x> = c: the plane of a facet, whose normal points outward.
struct Plane {
  Vector normal;
  Integer c;
};

/// Returns the vertices from number `first` to `last`, as differences of these points; their digits
/// lie in `integers`.
std::vector<Vector> differences(const Part<std::vector<Pair>>& vertices, std::size_t first, std::size_t last,
                                const Points& a, const Points& b, Arena& integers);

/// The facets of a polytope: those from number `first` to `last`, which `line` announces.
struct FacetRange {
  const Part<Facets>* part;
  std::size_t first, last, line;
};

/// Is called with each facet that is exactly as near to O as the polytope claims.
using NearestFacet = std::function<void(std::size_t line, const MutableVector& normal)>;

/// The inner polytope of these vertices: it holds a ball of squared radius `squared` around O.
/// Returns the planes of its facets, whose digits lie in `integers`.
std::vector<Plane> check_polytope(const std::vector<Vector>& vertices, const FacetRange& facets, const Bound& squared,
                                  const NearestFacet& nearest, Arena& integers);

/// The inner polytope holds a ball of squared radius `squared` around O; with `all`, no direction
/// is missing.
void check_inner(const Certificate& certificate, const Scaled& bodies, const Bound& squared);

/// No vector has h = 0 but those of the cone.
void check_cone(const Certificate& certificate, const Scaled& bodies);

/// Section 13: each patch is the hull of its corners, and the rates follow.
void check_patches(const Certificate& certificate, const Scaled& bodies);

/// Section 14: the pieces of this solid tile what its mesh encloses.
void check_solid(const Body& body);

/// Section 15, once it is known that the number of the claim is positive. `low` is that of the
/// claim, negative if they are apart.
void check_two_bodies(const Certificate& certificate, const Bound& low);

/// Section 12, once it is known that the number of the claim is positive.
void check_unions(const Certificate& certificate, const Scaled& bodies, const Bound& low);

}  // namespace fathom_check
