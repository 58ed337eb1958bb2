// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/study/study.hpp"

namespace fathom::studies {

Feature Subject::feature(gaussian::ArcId i) const {
  const polytope::Edge& edge = body.edges[i.value];
  const std::uint32_t p = body.input_ids[edge.from], q = body.input_ids[edge.to];
  return {std::min(p, q), std::max(p, q)};
}

Feature Subject::feature(gaussian::NodeId i) const {
  const polytope::Facet& facet = body.facets[gaussian::facet_of(i)];
  Feature points;
  for (std::uint32_t k = facet.begin; k < facet.end; ++k) points.push_back(body.input_ids[body.corners[k]]);
  std::ranges::sort(points);
  return points;
}

Involved Subject::involved(std::vector<Feature> own, std::vector<Feature> others) const {
  if (colour == gaussian::Colour::b) own.swap(others);
  return {std::move(own), std::move(others)};
}

}  // namespace fathom::studies
