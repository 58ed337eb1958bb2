// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the charts of one hemisphere.
// Output  for each node of one colour a face of the other that contains it: for each facet normal of one body an extreme vertex of the
//         other. With both hemispheres these are all facets of P of kind vertex-facet.         [AGHRS, PENETRATION-DEPTH, step 1]
// Time    linear: the charts hold the place of each node, found by a plane sweep in O((m + n) log(m + n)).
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/nearest.hpp"
#include "kernels/report.hpp"
#include "reference/chart/chart.hpp"

namespace fathom {

/// Facet `facet` of the body of colour `facet_of`, and a vertex of the other body that is extreme in its normal direction (on -A, for
/// colour b's facets; so it minimises <normal, a>). If several vertices are extreme, any one of them.
struct VertexFacetPair {
  Colour facet_of;
  std::uint32_t facet;
  std::uint32_t vertex;
  friend bool operator==(const VertexFacetPair&, const VertexFacetPair&) = default;
};

/// One pair for each node of either colour in this hemisphere.
std::vector<VertexFacetPair> vertex_facet_pairs(const Charts& charts);

/// Offers the facets' planes, h(n) from the pair's vertex: AGHRS, PENETRATION-DEPTH, step 1.
void offer(const std::vector<VertexFacetPair>& pairs, const Charts& charts, const Polytope& a, const Polytope& b, NearestPlanes& nearest);

/// Checks that each node of the hemisphere occurs once and that its vertex is extreme, by a linear scan: O(facets * vertices).
[[nodiscard]] Report validate(const std::vector<VertexFacetPair>& pairs, const Charts& charts, const Polytope& a, const Polytope& b);

}  // namespace fathom
