// SPDX-License-Identifier: GPL-3.0-or-later
// The coarsening of a solid polytope, level by level, and what a descent needs of it. For Hierarchy.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// A vertex is removed only while at most this many edges meet in it.
inline constexpr std::uint32_t greatest_degree = 8;
/// A polytope with fewer vertices is not coarsened further. Then more than greatest_degree vertices remain, which keeps every level
/// solid.                                                                                                [proofs/hierarchy.md, lemma 4]
inline constexpr std::uint32_t least_coarsened = 3 * greatest_degree - 3;

inline constexpr std::uint32_t no_change = std::numeric_limits<std::uint32_t>::max();

/// Level 0 is the polytope itself; level k + 1 is the hull of the vertices of level k without those whose last level is k.
/// An edge belongs to the levels from `born` up to the last level of either end.
struct Coarsening {
  struct Edge {
    VertexId from, to;
    std::uint32_t born;
    std::uint32_t changes;  ///< the first, from the coarsest level on; or no_change
  };
  /// At `level` one of the edge's two facets is new: one level below, `apex` stood above it.
  struct Change {
    std::uint32_t level;
    VertexId apex;
    std::uint32_t next;  ///< of the same edge, at this level or a finer one; or no_change
  };
  struct Link {
    VertexId vertex;  ///< at the other end
    std::uint32_t edge;
  };

  kernels::IdVector<VertexId, std::uint32_t> last;  ///< the coarsest level that has the vertex
  std::vector<VertexId> top;                        ///< vertices of the coarsest level
  std::vector<Edge> edges;                          ///< of all levels
  std::vector<Change> changes;
  std::vector<Link> links;                                ///< of each vertex at its last level, counter-clockwise
  kernels::IdVector<VertexId, std::uint32_t> first_link;  ///< one more entry closes the last
  std::uint32_t levels = 0;

  [[nodiscard]] std::span<const Link> links_of(VertexId v) const {
    return std::span(links).subspan(first_link[v], first_link[v.next()] - first_link[v]);
  }
};

/// Of a polytope of rank 3. Exact, linear time.
Coarsening coarsen(const Polytope& polytope);

}  // namespace fathom::polytope
