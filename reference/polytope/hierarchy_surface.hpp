// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a convex polytope under removal of vertices: half-edges, facets of any number of corners. For coarsen().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// Half-edges 2 e and 2 e + 1 are the two senses of edge e; 2 e of the polytope's own edges runs as they do. A half-edge's facet lies to
/// its left, seen from outside.
class HierarchySurface {
 public:
  /// Rank 3.
  explicit HierarchySurface(const Polytope& polytope);

  [[nodiscard]] std::uint32_t degree(std::uint32_t v) const { return degree_[v]; }
  [[nodiscard]] std::uint32_t origin(std::uint32_t h) const { return origin_[h]; }
  [[nodiscard]] std::uint32_t target(std::uint32_t h) const { return origin_[h ^ 1]; }
  [[nodiscard]] std::size_t edges() const { return origin_.size() / 2; }
  /// Half-edges that leave v, counter-clockwise.
  [[nodiscard]] std::vector<std::uint32_t> leaving(std::uint32_t v) const;

  /// Removes v and closes the hole with the hull of its neighbours. New edges get the next numbers. Returns the edges of all new
  /// facets, each once: the rim first. What remains must be of rank 3.
  std::vector<std::uint32_t> remove(std::uint32_t v);

 private:
  using Cycle = std::vector<std::uint32_t>;  // half-edges, each followed by the next
  std::uint32_t add_edge(std::uint32_t from, std::uint32_t to);
  void join(std::uint32_t h, std::uint32_t following);
  std::uint32_t cut_corner(std::uint32_t h);
  std::vector<std::size_t> corners_of_facet(const Cycle& hole) const;
  void close(const Cycle& hole, std::vector<std::uint32_t>& touched);

  kernels::BoxedPoints points_;
  std::vector<std::uint32_t> origin_, next_, previous_;  // of half-edges
  std::vector<std::uint32_t> leaving_, degree_;          // of vertices
};

}  // namespace fathom::polytope
