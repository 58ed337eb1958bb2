// SPDX-License-Identifier: GPL-3.0-or-later
// The quadratic twins of the stages after the hulls, from Gaussian diagrams to closest lines.
// Input   the hulls of A and of B, with O in the interior of P = B (+) (-A).
// Output  the facet planes of P nearest to O: facets of A or of B against vertices, and crossing edges.
#pragma once

#include "kernels/nearest.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {

/// Every facet normal against every vertex, every edge against every edge by an exact test of its arcs, all in exact arithmetic. O(mn).
kernels::NearestPlanes nearest_facets_naive(const polytope::Polytope& a, const polytope::Polytope& b);

/// A twin as other libraries would write it: every edge against every edge, with the double filter. O(mn), a few nanoseconds a pair.
/// `exponent` bounds the coordinates: |c| <= 2^exponent.
kernels::NearestPlanes nearest_facets_scan(const polytope::Polytope& a, const polytope::Polytope& b, long exponent);

}  // namespace fathom::depth
