// SPDX-License-Identifier: GPL-3.0-or-later
// Extremes of depth and of shape, and pairs that are almost degenerate.                                            [docs/golden.md]
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// Two sphere-like bodies about one centre, B scaled by 2^-j, 0 <= j <= 10: the depth is nearly the sum of the radii, and facets of P all
/// around nearly tie.
Bodies deep(Random& random, unsigned n);

/// Lenses that overlap by 2^-k of their size, 41 <= k <= 200: one optimum, of a random kind.
Bodies hair_overlap(Random& random, unsigned n);

/// Lenses apart by 2^-k of their size, 61 <= k <= 200, with any of the nine pairs of features nearest to each other.
Bodies hair_gap(Random& random, unsigned n);

/// Sphere-like bodies about one centre, each stretched to extents with a ratio of 10^j, 4 <= j <= 9, as a needle, a plate or a plank,
/// then turned.
Bodies stretched(Random& random, unsigned n);

/// A pair of spheres of points, degraded in a random way [degrade.hpp], then each point moved by at most 2^-k, 4 <= k <= 200.
Bodies approaching_degraded(Random& random, unsigned n);

}  // namespace fathom::families
