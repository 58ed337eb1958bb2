// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/line_scene.hpp"

namespace fathom::lines {

template <gaussian::Colour c>
EdgeLines<c>::EdgeLines(const polytope::Polytope& polytope, long exponent) : polytope_(&polytope), images_(exponent) {
  for (const Edge i : ids()) images_.push_back(point(i), direction(i));
}

template <gaussian::Colour c>
Vector EdgeLines<c>::direction(Edge edge) const {
  const auto& e = polytope_->edges[edge.value];
  return polytope_->vertices[e.to] - polytope_->vertices[e.from];
}

template class EdgeLines<gaussian::Colour::a>;
template class EdgeLines<gaussian::Colour::b>;

bool offer_edges(const EdgeLinesOfA& a, gaussian::EdgeOfA e, const EdgeLinesOfB& b, gaussian::EdgeOfB f, kernels::NearestPlanes& nearest) {
  const Vector w = cross(a.direction(e), b.direction(f));
  if (is_zero(w)) return false;
  const mpz_class height = dot(b.point(f) - a.point(e), w);
  return height > 0 ? nearest.offer(w, height) : nearest.offer(-w, mpz_class(-height));
}

}  // namespace fathom::lines
