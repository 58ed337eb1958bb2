// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the charts of one hemisphere.
// Output  for each facet normal of one body an extreme vertex of the other. With both hemispheres
//         these are all facets of P of kind vertex-facet.        [AGHRS, PENETRATION-DEPTH, step 1]
// Time    linear. The point location of step 1 happens in chart/chart.cpp, since the canonical
//         subsets need the places of nodes too.
#pragma once

#include <vector>

#include "kernels/messages.hpp"
#include "kernels/nearest.hpp"
#include "reference/chart/chart.hpp"

namespace fathom::vertex_facet {

/// A facet of the body of colour `facet_of`, and a vertex of the other body that is extreme in the
/// direction of its node (on -A for a facet of B, so it minimises <normal, a>). If several vertices
/// are extreme, it is any one of them.
struct VertexFacetPair {
  gaussian::Colour facet_of;
  polytope::FacetId facet;
  polytope::VertexId vertex;
};

/// One pair for each node of either colour in this hemisphere.
std::vector<VertexFacetPair> vertex_facet_pairs(const chart::Charts& charts);

/// Offers the facets' planes; the height h(n) comes from the pair's vertex.
void offer(const std::vector<VertexFacetPair>& pairs, const chart::Charts& charts, const polytope::Polytope& a,
           const polytope::Polytope& b, kernels::NearestPlanes& nearest);

/// Checks that each node of the hemisphere occurs once and that its vertex is extreme, by a linear
/// scan: O(facets * vertices).
[[nodiscard]] kernels::Report validate(const std::vector<VertexFacetPair>& pairs, const chart::Charts& charts,
                                       const polytope::Polytope& a, const polytope::Polytope& b);

}  // namespace fathom::vertex_facet
