// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a convex polytope under removal of vertices: half-edges, facets of any number of corners. For coarsen().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "kernels/id.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// Half-edges 2 e and 2 e + 1 are the two senses of edge e; 2 e of the polytope's own edges runs as they do. A half-edge's facet lies to
/// its left, seen from outside.
using HalfEdge = kernels::Id<struct HalfEdgeTag>;

constexpr HalfEdge opposite(HalfEdge h) { return HalfEdge(h.value ^ 1); }
constexpr std::uint32_t edge_of(HalfEdge h) { return h.value / 2; }

/// Edges are plain indices, as in a Polytope.
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

  /// Removes v and closes the hole with the hull of its neighbours. New edges get the next numbers. Returns the edges of all new
  /// facets, each once: the rim first. What remains must be of rank 3.
  std::vector<std::uint32_t> remove(VertexId v);

 private:
  using Cycle = std::vector<HalfEdge>;  // each followed by the next
  HalfEdge add_edge(VertexId from, VertexId to);
  void join(HalfEdge h, HalfEdge following);
  HalfEdge cut_corner(HalfEdge h);
  [[nodiscard]] std::uint32_t point(HalfEdge h) const { return origin_[h].value; }  // its origin, as the filters number it
  std::vector<std::size_t> corners_of_facet(const Cycle& hole) const;
  void close(const Cycle& hole, std::vector<std::uint32_t>& touched);

  kernels::BoxedPoints points_;
  kernels::IdVector<HalfEdge, VertexId> origin_;
  kernels::IdVector<HalfEdge, HalfEdge> next_, previous_;
  kernels::IdVector<VertexId, HalfEdge> leaving_;  // any one
  kernels::IdVector<VertexId, std::uint32_t> degree_;
};

}  // namespace fathom::polytope
