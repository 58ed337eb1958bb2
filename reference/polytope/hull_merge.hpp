// SPDX-License-Identifier: GPL-3.0-or-later
// From a triangulated boundary to facets, edges and vertices. For convex_hull alone.
#pragma once

#include <span>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// The polytope of rank 3 whose boundary `triangles` cover as hull_triangles states. Exact, O(n log n).    [proofs/polytope.md]
Polytope merge_coplanar(std::span<const Vector> points, std::span<const HullTriangle> triangles);

/// Gives `polytope` the vertices points[id] for the ids marked in `extreme`, in ascending order. Returns the vertex of each id, or none.
std::vector<VertexId> number_vertices(Polytope& polytope, std::span<const Vector> points, const std::vector<bool>& extreme);

/// Turns a cycle so that it starts at its lowest vertex.
void start_at_lowest(std::vector<VertexId>& cycle);

void append_facet(Polytope& polytope, Vector normal, std::span<const VertexId> cycle);

}  // namespace fathom::polytope
