// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/polytope/hierarchy.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "kernels/float_environment.hpp"

namespace fathom::polytope {
namespace {

std::vector<VertexId> all_vertices(const Polytope& p) {
  std::vector<VertexId> all;
  std::ranges::copy(p.vertices.ids(), std::back_inserter(all));
  return all;
}

/// Of a polytope of rank 1 or 2: the vertices as high as `highest`, among it and those next to it.
std::vector<VertexId> face_of_cycle(HierarchyDescent& descent, const Polytope& p) {
  std::vector<VertexId> face{descent.highest()};
  for (const VertexId v : p.rank == 2 ? descent.neighbours() : all_vertices(p)) {
    if (v == descent.highest()) continue;
    if (descent.rise(v) == kernels::Sign::zero) face.push_back(v);
  }
  return face.size() == 3 ? all_vertices(p) : face;  // then the polygon's plane is level
}

/// The facet with outward normal along u at the edge from v to w, or the edge itself.
std::vector<VertexId> face_at_edge(const Polytope& p, VertexId v, VertexId w, const Vector& u) {
  const auto [from, to] = std::minmax(v, w);
  const auto edge = std::ranges::lower_bound(p.edges, std::tuple(from, to), {}, [](const Edge& e) { return std::tuple(e.from, e.to); });
  for (const FacetId f : {edge->left, edge->right}) {
    const Facet& facet = p.facets[f];
    if (same_direction(facet.normal, u)) return {p.corners.begin() + facet.begin, p.corners.begin() + facet.end};
  }
  return {from, to};
}

}  // namespace

Hierarchy::Hierarchy(const Polytope& polytope) : polytope_(&polytope), cloud_(polytope.vertices) {
  const kernels::DefaultFloatEnvironment environment;
  if (polytope.rank == 3) coarsening_ = coarsen(polytope);
}

std::size_t Hierarchy::levels() const {
  if (polytope_->rank == 3) return coarsening_.levels;
  std::size_t levels = 1;
  if (polytope_->rank == 2)
    for (std::size_t n = cloud_.size(); n > 4; n = (n + 1) / 2) ++levels;
  return levels;
}

std::size_t Hierarchy::size() const {
  return cloud_.size() + coarsening_.edges.size() + coarsening_.changes.size() + coarsening_.links.size();
}

VertexId Hierarchy::extreme(const Vector& u, Steps* steps) const {
  const kernels::DefaultFloatEnvironment environment;
  if (polytope_->rank == 0 || is_zero(u)) return VertexId(0);
  HierarchyDescent descent(*this);
  descent.start(u);
  while (!descent.at_finest()) descent.step_down();
  if (steps) *steps += descent.steps();
  return descent.highest();
}

std::vector<VertexId> Hierarchy::extreme_face(const Vector& u, Steps* steps) const {
  const kernels::DefaultFloatEnvironment environment;
  if (polytope_->rank == 0 || is_zero(u)) return all_vertices(*polytope_);
  HierarchyDescent descent(*this);
  descent.start(u);
  while (!descent.at_finest()) descent.step_down();
  std::vector<VertexId> face{descent.highest()};
  if (polytope_->rank < 3) face = face_of_cycle(descent, *polytope_);
  else if (const VertexId* tied = descent.tied()) face = face_at_edge(*polytope_, descent.highest(), *tied, u);
  std::ranges::sort(face);
  if (steps) *steps += descent.steps();
  return face;
}

}  // namespace fathom::polytope
