// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/hierarchy_surface.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

/// No two adjacent, none of more than greatest_degree edges; greedily, those of few edges first, since they exclude few others.
std::vector<VertexId> independent_set(const HierarchySurface& surface, const std::vector<VertexId>& vertices) {
  std::array<std::vector<VertexId>, greatest_degree + 1> by_degree;
  for (const VertexId v : vertices)
    if (surface.degree(v) <= greatest_degree) by_degree[surface.degree(v)].push_back(v);
  kernels::IdVector<VertexId, bool> excluded(vertices.back().value + 1);
  std::vector<VertexId> chosen;
  for (const std::vector<VertexId>& group : by_degree) {
    for (const VertexId v : group) {
      if (excluded[v]) continue;
      chosen.push_back(v);
      for (const HalfEdge h : surface.leaving(v)) excluded[surface.target(h)] = true;
    }
  }
  return chosen;
}

class Builder {
 public:
  explicit Builder(const Polytope& polytope) : surface_(polytope), links_(polytope.vertices.size()) {
    for (const Edge& e : polytope.edges) result_.edges.push_back({e.from, e.to, 0, no_change});
    result_.last.resize(polytope.vertices.size());
    for (const VertexId v : polytope.vertices.ids()) result_.top.push_back(v);
  }

  /// From level `levels` to the next one; result_.top holds its vertices, ascending.
  void coarsen_once() {
    const std::vector<VertexId> removed = independent_set(surface_, result_.top);
    for (const VertexId v : removed) leave(v, result_.levels);
    ++result_.levels;
    for (const VertexId v : removed) remove(v);
    std::erase_if(result_.top, [this](VertexId v) { return result_.last[v] < result_.levels; });
  }

  Coarsening run() {
    for (const VertexId v : result_.top) result_.last[v] = last_of_all;
    while (result_.top.size() >= least_coarsened) coarsen_once();
    for (const VertexId v : result_.top) leave(v, result_.levels);
    for (const std::vector<Coarsening::Link>& links : links_) {
      result_.first_link.push_back(static_cast<Index>(result_.links.size()));
      result_.links.insert(result_.links.end(), links.begin(), links.end());
    }
    result_.first_link.push_back(static_cast<Index>(result_.links.size()));
    ++result_.levels;
    return std::move(result_);
  }

 private:
  static constexpr Index last_of_all = std::numeric_limits<Index>::max();

  void leave(VertexId v, Index level) {
    result_.last[v] = level;
    for (const HalfEdge h : surface_.leaving(v)) links_[v].push_back({surface_.target(h), edge_of(h)});
  }

  void remove(VertexId v) {
    for (const Index e : surface_.remove(v)) {
      while (result_.edges.size() <= e) {
        const HalfEdge h(static_cast<Index>(2 * result_.edges.size()));
        result_.edges.push_back({surface_.origin(h), surface_.target(h), result_.levels, no_change});
      }
      Coarsening::Edge& edge = result_.edges[e];
      result_.changes.push_back({result_.levels, v, edge.changes});
      edge.changes = static_cast<Index>(result_.changes.size() - 1);
    }
  }

  HierarchySurface surface_;
  kernels::IdVector<VertexId, std::vector<Coarsening::Link>> links_;
  Coarsening result_;
};

}  // namespace

Coarsening coarsen(const Polytope& polytope) { return Builder(polytope).run(); }

}  // namespace fathom::polytope
