// SPDX-License-Identifier: GPL-3.0-or-later
// Near ties of facets that share an edge: O is placed close to an edge of P, between its two facets.             [docs/golden.md]
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// Two spheres of points, B moved so that the two facets of P at an edge are the nearest ones, mostly of kind edge-edge. The distance of
/// the second is larger by the factor 1 + 2^-k (to within 2^-k-16), 8 <= k <= 200. If no such place is found near
/// a few edges, the spheres are not moved; no seed is known for which this happens.
Bodies inverse_ridge(Random& random, unsigned n);

}  // namespace fathom::families
