// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the exact method's stages for bodies that penetrate.
// Output  every facet of P = B (+) (-A), with the features of both bodies that make it. The directions are those of nodes and of crossings;
//         crossings of the perturbed arcs are those of the arcs themselves, or lie at a node.            [AGHRS, section 2.2;
//         proofs/depth.md]
// Size    at most the number of nodes and crossings.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/depth/penetration_depth.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {

/// A vertex of A and one of B: the corner b - a of P.
struct SumCorner {
  polytope::VertexId a, b;
  friend auto operator<=>(const SumCorner&, const SumCorner&) = default;
};

/// A facet of P, exactly.
struct ExactSumFacet {
  Vector normal;                         ///< outward, primitive
  mpz_class height;                      ///< h(normal) in the unit of the lattice
  std::vector<SumCorner> corners;        ///< counter-clockwise from outside, none on a line with its neighbours
  std::vector<polytope::VertexId> a, b;  ///< the faces of A and B: extreme points, ascending
  Indices pairs;  ///< canonical pairs with a crossing in this direction, ascending; the lower chart's behind the upper's
};

/// Returns all facets in the order of their normals, or nullopt if there are more than `most`, or far more crossings than that.
std::optional<std::vector<ExactSumFacet>> sum_facets(const depth::ExactStages& exact, std::size_t most);

/// The corners of the facet of P with this normal, given the faces of A in direction -normal and of B in direction normal: each a vertex,
/// the ends of an edge, or a facet's cycle, counter-clockwise from outside its body.
std::vector<SumCorner> sum_cycle(const depth::Hulls& hulls, const Vector& normal, std::vector<polytope::VertexId> of_a,
                                 std::vector<polytope::VertexId> of_b);

}  // namespace fathom::stages
