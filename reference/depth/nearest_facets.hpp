// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the hulls of A and of B, with O in the interior of P = B (+) (-A).
// Output  the facet planes of P nearest to O: facets of A or of B against vertices, and crossing edges.
//         [AGHRS, PENETRATION-DEPTH, section 2.2]
#pragma once

#include "kernels/nearest.hpp"
#include "reference/depth/depth.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom {

/// All stages from Gaussian diagrams to closest lines, over both hemispheres. `exponent` bounds the coordinates: |c| <= 2^exponent.
/// Throws Interrupted, and std::logic_error when options.validate finds a broken law.
NearestPlanes nearest_facets(const Polytope& a, const Polytope& b, long exponent, const Options& options, Counters& counters);

/// The naive twin of the stages after the hulls: every facet normal against every vertex, every edge against every edge by an exact
/// test of its arcs, all in exact arithmetic. O(mn).
NearestPlanes nearest_facets_naive(const Polytope& a, const Polytope& b);

/// The twin that a competitor would write: every edge against every edge, with the double filter. O(mn), a few nanoseconds a pair.
NearestPlanes nearest_facets_scan(const Polytope& a, const Polytope& b, long exponent);

}  // namespace fathom
