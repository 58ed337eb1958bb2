// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of P = B (+) (-A), implicitly: a facet's edges, and the facet beyond an edge, from the two bodies' faces alone. Gift
// wrapping with local adjacency: parallel edges, common normals and facets of any number of corners are not special cases.
// [proofs/shallow.md]
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::approximate {

/// A facet of P: the faces of -A and of B that are extreme in the direction of its normal. The faces alone tell which facet it is.
struct SumFacet {
  Face a, b;
  Vector normal;  ///< outward, primitive
};

/// An edge of a facet of P, counter-clockwise seen from outside: a vertex or an edge of either body, not both vertices; two edges
/// are parallel, and walked in the same sense. The faces alone tell which edge of P it is.
struct SumEdge {
  Face a, b;
  polytope::VertexId from_a, to_a, from_b, to_b;  ///< vertices; from = to for a vertex
};

class SumSurface {
 public:
  /// The polytopes, values that convex_hull returned, must outlive it. P must have an interior. O(m + n) space, nearly O(m + n) time.
  SumSurface(const polytope::Polytope& a, const polytope::Polytope& b) : minus_a_(a, gaussian::Colour::a), b_(b, gaussian::Colour::b) {}

  /// The facet with outward normal n, given all vertices of A that minimise <n,.> and all of B that maximise it.
  [[nodiscard]] SumFacet facet(const std::vector<polytope::VertexId>& face_a, const std::vector<polytope::VertexId>& face_b,
                               const Vector& n) const;

  /// A point of the facet; and the ends of an edge.
  [[nodiscard]] Vector point(const SumFacet& facet) const;
  [[nodiscard]] Vector from(const SumEdge& edge) const { return minus_a_.vertex(edge.from_a) + b_.vertex(edge.from_b); }
  [[nodiscard]] Vector to(const SumEdge& edge) const { return minus_a_.vertex(edge.to_a) + b_.vertex(edge.to_b); }

  /// All edges, in cyclic order: linear in the number of corners of both faces.
  [[nodiscard]] std::vector<SumEdge> edges(const SumFacet& facet) const;

  /// The facet beyond an edge of a facet. O(1), except for the degrees of the vertices that the edge is made of: *steps grows by them.
  [[nodiscard]] SumFacet across(const SumEdge& edge, std::uint64_t* steps) const;

 private:
  Summand minus_a_, b_;
};

}  // namespace fathom::approximate
