// SPDX-License-Identifier: GPL-3.0-or-later
// The laws of facets, edges and vertices, checked locally and exactly. For validate alone.
#pragma once

#include "kernels/report.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// Normals primitive, corners on the plane, cycles simple, strictly convex and counter-clockwise. Indices must be in range.
void validate_facets(const Polytope& polytope, kernels::Report& report);

/// Rank 3 with valid facets: each side of a facet belongs to one edge and each edge to two sides, left and right facets lie to the left and
/// right, facets meet convexly at every edge and in a convex cone at every vertex.
void validate_surface(const Polytope& polytope, kernels::Report& report);

}  // namespace fathom::polytope
