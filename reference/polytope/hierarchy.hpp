// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a convex polytope of any rank.
// Output  its Dobkin-Kirkpatrick hierarchy: ever coarser polytopes, each the hull of the vertices left when an independent set of
//         vertices of bounded degree is removed; extreme vertices in any direction.                                      [AGHRS, section 3]
// Size    linear; O(log n) levels; O(log n) steps a query.                                             [proofs/hierarchy.md]
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/filters/support.hpp"
#include "kernels/report.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

/// A count of exact sign decisions, the same on every machine.
using Steps = std::uint64_t;

class Hierarchy {
 public:
  /// Refers to the polytope, which must outlive the hierarchy. Expected to be a value that convex_hull returned. Exact.
  explicit Hierarchy(const Polytope& polytope);

  [[nodiscard]] const Polytope& polytope() const { return *polytope_; }
  /// The vertices, as the filters read them.
  [[nodiscard]] const kernels::PointCloud& cloud() const { return cloud_; }
  [[nodiscard]] std::size_t levels() const;
  /// Returns the number of stored items: vertices, edges of all levels, links and changes.
  [[nodiscard]] std::size_t size() const;

  /// Returns a vertex that maximises <u, p>; any, if several do. Exact. u may be zero. Adds its steps to *steps.
  [[nodiscard]] VertexId extreme(const Vector& u, Steps* steps = nullptr) const;
  /// Returns all vertices that maximise <u, p>, ascending: a vertex, the ends of an edge, the corners of a facet, or all vertices when u is
  /// zero or normal to a flat polytope. The listing adds its own length to the time, not to the steps.
  [[nodiscard]] std::vector<VertexId> extreme_face(const Vector& u, Steps* steps = nullptr) const;

  /// How a polytope of rank 3 is coarsened; empty for lower ranks, where vertices of the cycle are halved again and again.
  [[nodiscard]] const Coarsening& coarsening() const { return coarsening_; }

 private:
  const Polytope* polytope_;
  kernels::PointCloud cloud_;
  Coarsening coarsening_;
};

/// Checks every level of a hierarchy of rank 3 against the hull of its vertices: the same edges; removed vertices independent, of
/// degree at most greatest_degree, with all their edges listed. O(levels) hulls: for tests.
[[nodiscard]] kernels::Report validate(const Hierarchy& hierarchy);

}  // namespace fathom::polytope
