// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/study/findings.hpp"

#include <algorithm>

namespace fathom::studies {

Feature Subject::edge(std::uint32_t i) const {
  const polytope::Edge& edge = body.edges[i];
  const std::uint32_t p = body.input_ids[edge.from], q = body.input_ids[edge.to];
  return {std::min(p, q), std::max(p, q)};
}

Feature Subject::facet(std::uint32_t i) const {
  Feature points;
  for (std::uint32_t k = body.facets[i].begin; k < body.facets[i].end; ++k) points.push_back(body.input_ids[body.corners[k]]);
  std::ranges::sort(points);
  return points;
}

}  // namespace fathom::studies
