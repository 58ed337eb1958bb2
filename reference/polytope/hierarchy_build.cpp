// SPDX-License-Identifier: GPL-3.0-or-later
// The coarsening of a solid polytope: independent vertices are removed, level by level, and each
// hole is closed with the hull of its rim.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "kernels/id.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

/// Half-edges 2 e and 2 e + 1 are the two senses of edge e; 2 e of the polytope's own edges runs as
/// they do. A half-edge's facet lies to its left, seen from outside.
using HalfEdge = kernels::Id<struct HalfEdgeTag>;

constexpr HalfEdge opposite(HalfEdge h) { return HalfEdge(h.value ^ 1); }
constexpr std::uint32_t edge_of(HalfEdge h) { return h.value / 2; }

/// The boundary of a convex polytope under removal of vertices: half-edges, facets of any number of
/// corners. Edges are plain indices, as in a Polytope.
class HierarchySurface {
 public:
  /// Rank 3.
  explicit HierarchySurface(const Polytope& polytope);

  [[nodiscard]] std::uint32_t degree(VertexId v) const { return degree_[v]; }
  [[nodiscard]] VertexId origin(HalfEdge h) const { return origin_[h]; }
  [[nodiscard]] VertexId target(HalfEdge h) const { return origin_[opposite(h)]; }
  [[nodiscard]] std::size_t edges() const { return origin_.size() / 2; }
  /// Half-edges that leave v, counter-clockwise.
  [[nodiscard]] std::vector<HalfEdge> leaving(VertexId v) const;

  /// Removes v and closes the hole with the hull of its neighbours. New edges get the next numbers.
  /// Returns the edges of all new facets, each once: the rim first. What remains must be of rank 3.
  std::vector<std::uint32_t> remove(VertexId v);

 private:
  using Cycle = std::vector<HalfEdge>;  // each followed by the next
  HalfEdge add_edge(VertexId from, VertexId to);
  void join(HalfEdge h, HalfEdge following);
  HalfEdge cut_corner(HalfEdge h);
  [[nodiscard]] std::uint32_t point(HalfEdge h) const {
    return origin_[h].value;
  }  // its origin, as the filters number it
  std::vector<std::size_t> corners_of_facet(const Cycle& hole) const;
  void close(const Cycle& hole, std::vector<std::uint32_t>& touched);

  kernels::BoxedPoints points_;
  kernels::IdVector<HalfEdge, VertexId> origin_;
  kernels::IdVector<HalfEdge, HalfEdge> next_, previous_;
  kernels::IdVector<VertexId, HalfEdge> leaving_;  // any one
  kernels::IdVector<VertexId, std::uint32_t> degree_;
};

HierarchySurface::HierarchySurface(const Polytope& polytope)
    : points_(polytope.vertices), leaving_(polytope.vertices.size()), degree_(polytope.vertices.size(), 0) {
  for (const Edge& e : polytope.edges) {
    add_edge(e.from, e.to);
  }
  next_.resize(origin_.size());
  previous_.resize(origin_.size());
  // The half-edge that leaves each corner along its facet: half-edges grouped by facet, then looked
  // up by their origin.
  kernels::IdVector<FacetId, Index> free(polytope.facets.size());
  std::vector<HalfEdge> grouped(origin_.size());
  kernels::IdVector<VertexId, HalfEdge> at(polytope.vertices.size());
  for (const FacetId f : polytope.facets.ids()) free[f] = polytope.facets[f].begin;
  for (Index e = 0; e < polytope.edges.size(); ++e) {
    grouped[free[polytope.edges[e].left]++] = HalfEdge(2 * e);
    grouped[free[polytope.edges[e].right]++] = HalfEdge(2 * e + 1);
  }
  for (const Facet& f : polytope.facets) {
    for (Index c = f.begin; c < f.end; ++c) at[origin_[grouped[c]]] = grouped[c];
    for (Index c = f.begin; c < f.end; ++c) join(grouped[c], at[target(grouped[c])]);
  }
}

HalfEdge HierarchySurface::add_edge(VertexId from, VertexId to) {
  const HalfEdge h(static_cast<Index>(origin_.size()));
  origin_.insert(origin_.end(), {from, to});
  next_.resize(origin_.size());
  previous_.resize(origin_.size());
  leaving_[from] = h;
  leaving_[to] = opposite(h);
  ++degree_[from];
  ++degree_[to];
  return h;
}

void HierarchySurface::join(HalfEdge h, HalfEdge following) {
  next_[h] = following;
  previous_[following] = h;
}

std::vector<HalfEdge> HierarchySurface::leaving(VertexId v) const {
  std::vector<HalfEdge> ring;
  HalfEdge h = leaving_[v];
  do {
    ring.push_back(h);
    h = opposite(previous_[h]);
  } while (h != leaving_[v]);
  return ring;
}

/// h leaves v. The half-edge with the hole to its left, from h's target to the next neighbour,
/// where v's corner of the facet left of h is cut off. Of a triangle nothing is left but that side.
HalfEdge HierarchySurface::cut_corner(HalfEdge h) {
  const HalfEdge last = previous_[h], first = next_[h];
  if (next_[first] == last) return first;
  const HalfEdge cut = add_edge(target(h), origin_[last]);
  join(previous_[last], opposite(cut));
  join(opposite(cut), first);
  return cut;
}

std::vector<Index> HierarchySurface::remove(VertexId v) {
  std::vector<Index> touched;
  Cycle rim;
  for (const HalfEdge h : leaving(v)) rim.push_back(cut_corner(h));
  for (const HalfEdge h : rim) {
    leaving_[origin_[h]] = h;
    --degree_[origin_[h]];
    touched.push_back(edge_of(h));
  }
  degree_[v] = 0;
  close(rim, touched);
  return touched;
}

/// The facet left of hole[0], as positions of its further corners in the hole: a plane is turned
/// about hole[0] until no corner lies above it. The corners span less than a half-turn about
/// hole[0], so the order in which the plane meets them is total.
std::vector<std::size_t> HierarchySurface::corners_of_facet(const Cycle& hole) const {
  std::size_t best = 2;
  kernels::Plane plane(points_, point(hole[0]), point(hole[1]), point(hole[best]));
  for (std::size_t i = 3; i < hole.size(); ++i) {
    if (plane.side(point(hole[i])) != kernels::Sign::positive) continue;
    best = i;
    plane = kernels::Plane(points_, point(hole[0]), point(hole[1]), point(hole[best]));
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 2; i < hole.size(); ++i)
    if (i == best || plane.side(point(hole[i])) == kernels::Sign::zero) corners.push_back(i);
  return corners;
}

/// Facets are found from the hole's first side inwards; each leaves smaller holes, at most
/// greatest_degree deep.
void HierarchySurface::close(const Cycle& hole, std::vector<Index>& touched) {
  Cycle facet{hole[0]};
  std::vector<Cycle> holes;
  std::size_t from = 1;
  std::vector<std::size_t> corners = corners_of_facet(hole);
  corners.push_back(hole.size());  // back to where hole[0] begins
  for (const std::size_t to : corners) {
    if (to == from + 1) {
      facet.push_back(hole[from]);
    } else {
      const HalfEdge side = add_edge(origin_[hole[from]], to == hole.size() ? origin_[hole[0]] : origin_[hole[to]]);
      facet.push_back(side);
      touched.push_back(edge_of(side));
      Cycle& rest = holes.emplace_back(hole.begin() + static_cast<std::ptrdiff_t>(from),
                                       hole.begin() + static_cast<std::ptrdiff_t>(to));
      rest.push_back(opposite(side));
    }
    from = to;
  }
  for (std::size_t i = 0; i < facet.size(); ++i) join(facet[i], facet[(i + 1) % facet.size()]);
  for (const Cycle& rest : holes) close(rest, touched);
}

/// No two adjacent, none of more than greatest_degree edges; greedily, those of few edges first,
/// since they exclude few others.
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
