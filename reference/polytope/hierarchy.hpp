// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a convex polytope of any rank.
// Output  its Dobkin-Kirkpatrick hierarchy: ever coarser polytopes, each the hull of the vertices
//         left when an independent set of vertices of bounded degree is removed; extreme vertices
//         in any direction.                                                      [AGHRS, section 3]
// Size    linear; O(log n) levels; O(log n) steps a query.                    [proofs/hierarchy.md]
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "kernels/filters/support.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// A vertex is removed only while at most this many edges meet in it.
inline constexpr std::uint32_t greatest_degree = 8;
/// A polytope with fewer vertices is not coarsened further. Then more than greatest_degree vertices
/// remain, which keeps every level solid.                            [proofs/hierarchy.md, lemma 4]
inline constexpr std::uint32_t least_coarsened = 3 * greatest_degree - 3;

inline constexpr std::uint32_t no_change = std::numeric_limits<std::uint32_t>::max();

/// The coarsening of a solid polytope, level by level, and what a descent needs of it. Level 0 is
/// the polytope itself; level k + 1 is the hull of the vertices of level k without those whose last
/// level is k. An edge belongs to the levels from `born` up to the last level of either end.
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

/// A count of exact sign decisions, the same on every machine.
using Steps = std::uint64_t;

class Hierarchy {
 public:
  /// Refers to the polytope, which must outlive the hierarchy. Expected to be a value that
  /// convex_hull returned. Exact.
  explicit Hierarchy(const Polytope& polytope);

  [[nodiscard]] const Polytope& polytope() const { return *polytope_; }
  /// The vertices, as the filters read them.
  [[nodiscard]] const kernels::PointCloud& cloud() const { return cloud_; }
  [[nodiscard]] std::size_t levels() const;
  /// Returns the number of stored items: vertices, edges of all levels, links and changes.
  [[nodiscard]] std::size_t size() const;

  /// Returns a vertex that maximises <u, p>; any, if several do. Exact. u may be zero. Adds its
  /// steps to *steps.
  [[nodiscard]] VertexId extreme(const Vector& u, Steps* steps = nullptr) const;
  /// Returns all vertices that maximise <u, p>, ascending: a vertex, the ends of an edge, the
  /// corners of a facet, or all vertices when u is zero or normal to a flat polytope. The listing
  /// adds its own length to the time, not to the steps.
  [[nodiscard]] std::vector<VertexId> extreme_face(const Vector& u, Steps* steps = nullptr) const;

  /// How a polytope of rank 3 is coarsened; empty for lower ranks, where vertices of the cycle are
  /// halved again and again.
  [[nodiscard]] const Coarsening& coarsening() const { return coarsening_; }

 private:
  const Polytope* polytope_;
  kernels::PointCloud cloud_;
  Coarsening coarsening_;
};

/// Checks every level of a hierarchy of rank 3 against the hull of its vertices: the same edges;
/// removed vertices independent, of degree at most greatest_degree, with all their edges listed.
/// O(levels) hulls: for tests.
[[nodiscard]] kernels::Report validate(const Hierarchy& hierarchy);

/// One way down a hierarchy, level by level, with the highest vertex in a direction that may change
/// on the way. Refers to the hierarchy, which must outlive it. Each step down takes a constant
/// number of sign decisions.
class HierarchyDescent {
 public:
  explicit HierarchyDescent(const Hierarchy& hierarchy);

  /// The vertices of the coarsest level; all of them if there is but one level.
  [[nodiscard]] std::vector<VertexId> coarsest() const;
  /// Starts at the coarsest level, with direction u, which must not be zero.
  void start(const Vector& u);

  [[nodiscard]] VertexId highest() const;
  [[nodiscard]] bool at_finest() const { return level_ == 0; }
  /// Goes to the next finer level. Returns whether one of its vertices is strictly higher: then it
  /// is `highest`, and its last level is this one.
  bool step_down();
  /// Goes on with another direction, in which `highest`, new at this level, is still highest among
  /// the vertices of this level.
  void turn_to(const Vector& u);
  /// Returns the neighbours of `highest` at this level, if it is new at this level.
  [[nodiscard]] std::vector<VertexId> neighbours() const;

  /// Rank 3, at the finest level: another highest vertex, adjacent to `highest`, if there is one.
  [[nodiscard]] const VertexId* tied() const {
    return left_.level ? &left_.other : right_.level ? &right_.other : nullptr;
  }
  /// The sign of <u, v - highest>: positive if v is higher. One step.
  kernels::Sign rise(VertexId v) { return ++steps_, view_->rise(highest_.value, v.value); }
  [[nodiscard]] Steps steps() const { return steps_; }

 private:
  /// An edge at the highest vertex. A level edge ends in another highest vertex: then it serves as
  /// left and as right.
  struct Side {
    VertexId other;  // the vertex at its other end
    std::uint32_t change = no_change;
    bool level = false;
  };

  kernels::Sign turn(VertexId p, VertexId q) { return ++steps_, view_->turn(highest_.value, p.value, q.value); }
  bool climb(VertexId v);
  void choose_sides();
  void collect(Side& s);
  bool hides(VertexId apex, const Side& s, kernels::Sign sense);
  Side side_to(VertexId apex);
  bool step_down_solid();
  bool step_down_polygon();

  const Hierarchy* hierarchy_;
  const Coarsening* c_;
  std::optional<kernels::PlanarView> view_;
  Steps steps_ = 0;
  std::uint32_t level_ = 0;
  VertexId highest_;
  // Rank 3.
  Side left_, right_;
  std::array<VertexId, 4> apexes_{};
  std::uint32_t count_ = 0;
  // Rank 2: level k holds every 2^k-th corner of the cycle; `highest` stands at this one.
  std::uint32_t position_ = 0;
};

}  // namespace fathom::polytope
