// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/edge_lines.hpp"

namespace fathom {

EdgeLines::EdgeLines(const Polytope& polytope, long exponent) : polytope_(&polytope), images_(exponent), truncated_(exponent) {
  for (std::uint32_t i = 0; i < size(); ++i) images_.push_back(point(i), direction(i));
  for (std::uint32_t i = 0; exponent >= TruncatedLines::worth_it && i < size(); ++i) truncated_.push_back(point(i), direction(i));
}

Vector EdgeLines::direction(std::uint32_t edge) const {
  const Edge& e = polytope_->edges[edge];
  return polytope_->vertices[e.to] - polytope_->vertices[e.from];
}

bool offer_edges(const EdgeLines& a, std::uint32_t of_a, const EdgeLines& b, std::uint32_t of_b, NearestPlanes& nearest) {
  const Vector w = cross(a.direction(of_a), b.direction(of_b));
  if (is_zero(w)) return false;
  const mpz_class height = dot(b.point(of_b) - a.point(of_a), w);
  return height > 0 ? nearest.offer(w, height) : nearest.offer(-w, mpz_class(-height));
}

}  // namespace fathom
