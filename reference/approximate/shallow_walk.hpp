// SPDX-License-Identifier: GPL-3.0-or-later
// The facets of P near a point: breadth first, from facet to facet across the edges that meet a ball. P is never built.
//                                                     [AGHRS, SHALLOW-PENETRATION, step 5; proofs/shallow.md]
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "kernels/context.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/shallow_surface.hpp"

namespace fathom::approximate {

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

/// Visits the starts, and every facet that shares an edge which meets the ball with a visited one. Throws Interrupted.
WalkCounts walk(kernels::Context& context, const SumSurface& surface, const Ball& ball, std::span<const SumFacet> starts,
                const VisitFacet& visit);

}  // namespace fathom::approximate
