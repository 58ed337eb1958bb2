// SPDX-License-Identifier: GPL-3.0-or-later
// P itself, as the hull of all vertex differences, and rays from O by a look at every facet: the
// naive twin of everything in reference/approximate.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "kernels/number/rational.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::testing {

inline mpq_class square(const mpq_class& q) { return q * q; }

/// P = B (+) (-A) in the unit of the lattice, moved by -shift.
inline polytope::Polytope differences(const polytope::PlacedPair& placed, const Vector& shift = {0, 0, 0}) {
  const polytope::Polytope a = polytope::convex_hull(placed.a.points()), b = polytope::convex_hull(placed.b.points());
  std::vector<Vector> all;
  for (const Vector& p : a.vertices) {
    for (const Vector& q : b.vertices) all.push_back(q - p - shift);
  }
  return polytope::convex_hull(all);
}

inline mpz_class height(const polytope::Polytope& p, const polytope::Facet& facet) {
  return dot(facet.normal, p.vertices[p.corners[facet.begin]]);
}

/// Whether O is in the interior of P.
inline bool holds_origin(const polytope::Polytope& p) {
  if (p.rank < 3) return false;
  for (const polytope::Facet& facet : p.facets) {
    if (height(p, facet) <= 0) return false;
  }
  return true;
}

/// The factor by which u reaches the boundary of P, with O in its interior.
inline mpq_class factor_naive(const polytope::Polytope& p, const Vector& u) {
  std::optional<mpq_class> least;
  for (const polytope::Facet& facet : p.facets) {
    const mpz_class speed = dot(facet.normal, u);
    if (speed <= 0) continue;
    const mpq_class factor = kernels::ratio(height(p, facet), speed);
    if (!least || factor < *least) least = factor;
  }
  return least.value();
}

/// Whether `normal` is that of a facet of P which holds the point factor * u.
inline bool is_hit(const polytope::Polytope& p, const Vector& normal, const mpq_class& factor, const Vector& u) {
  for (const polytope::Facet& facet : p.facets) {
    if (facet.normal == normal) return factor * dot(normal, u) == height(p, facet);
  }
  return false;
}

}  // namespace fathom::testing
