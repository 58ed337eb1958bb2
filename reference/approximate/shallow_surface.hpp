// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of P = B (+) (-A), implicitly: a facet's edges, and the facet beyond an edge, from
// the two bodies' faces alone. Gift wrapping with local adjacency: parallel edges, common normals
// and facets of any number of corners are not special cases. [proofs/shallow.md]
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::approximate {

// One summand of P = B (+) (-A), with what a walk over P needs: the edges at a vertex, the edges
// around a face, and which face becomes extreme next when a direction is turned about an edge of P.

/// A face of a polytope: vertex, edge or facet `index`. A polygon has two facets.
struct Face {
  enum class Kind : std::uint8_t { vertex, edge, facet };
  Kind kind = Kind::vertex;
  std::uint32_t index = 0;

  static Face of(polytope::VertexId v) { return {Kind::vertex, v.value}; }
  static Face of(polytope::FacetId f) { return {Kind::facet, f.value}; }
  static Face of_edge(std::uint32_t e) { return {Kind::edge, e}; }
  /// Of a face of this kind.
  [[nodiscard]] polytope::VertexId vertex() const { return polytope::VertexId(index); }
  [[nodiscard]] polytope::FacetId facet() const { return polytope::FacetId(index); }

  friend auto operator<=>(const Face&, const Face&) = default;
};

/// An edge in the sense in which it is walked.
struct FaceEdge {
  polytope::VertexId from, to;
  std::uint32_t edge;
};

/// What becomes extreme next in one summand, when a direction is turned.
struct Turn {
  bool never = true;  ///< true if nothing does, for lack of another vertex
  Vector x;           ///< from the old face's vertex to a new vertex
  Face face;          ///< the new face; it contains the old one
};

class Summand {
 public:
  /// B itself, or -A for colour a: the same numbering, each vertex and normal negated. The
  /// polytope, a value that convex_hull returned, must outlive it. Time O(n log n), space O(n).
  Summand(const polytope::Polytope& polytope, gaussian::Colour colour);

  [[nodiscard]] const polytope::Polytope& polytope() const { return *polytope_; }
  [[nodiscard]] const Vector& vertex(polytope::VertexId v) const { return vertices_[v]; }
  [[nodiscard]] Vector normal(polytope::FacetId facet) const;
  /// A vertex of the face.
  [[nodiscard]] polytope::VertexId corner(const Face& face) const;

  /// The face of these vertices, which are all that are extreme in direction n.
  [[nodiscard]] Face face_of(std::span<const polytope::VertexId> vertices, const Vector& n) const;

  /// Counter-clockwise seen from outside. A vertex has no sides, an edge two: there and back.
  [[nodiscard]] std::vector<FaceEdge> sides(const Face& face) const;

  /// `face`, a vertex or an edge along d, is extreme in all directions just after n when n is
  /// turned about d, where <n,d> = 0, by a right-handed rotation; `from` is a vertex of it, the end
  /// from which d comes if it is an edge. Returns what becomes extreme next, before half a turn is
  /// over. A vertex costs its degree, which is added to *steps.
  [[nodiscard]] Turn turn(const Face& face, polytope::VertexId from, const Vector& d, std::uint64_t* steps) const;

 private:
  struct Spoke {
    polytope::VertexId other;
    std::uint32_t edge;
  };

  [[nodiscard]] std::span<const Spoke> star(polytope::VertexId v) const;
  [[nodiscard]] std::uint32_t edge_between(polytope::VertexId v, polytope::VertexId w) const;
  [[nodiscard]] polytope::FacetId right_of(std::uint32_t edge, polytope::VertexId from) const;
  [[nodiscard]] polytope::FacetId common_facet(std::uint32_t edge, std::uint32_t other_edge, const Vector& n) const;
  [[nodiscard]] Turn turn_at_edge(std::uint32_t edge, polytope::VertexId from) const;

  const polytope::Polytope* polytope_;
  bool reflected_;
  kernels::IdVector<polytope::VertexId, Vector> vertices_;
  kernels::IdVector<polytope::VertexId, std::uint32_t> first_spoke_;  // and one past the last
  std::vector<Spoke> spokes_;                                         // those of a vertex in ascending order of `other`
  std::vector<std::uint32_t>
      edge_after_;  // of each of the polytope's corners: the edge to the next corner of its facet
};

/// A facet of P: the faces of -A and of B that are extreme in the direction of its normal. The
/// faces alone tell which facet it is.
struct SumFacet {
  Face a, b;
  Vector normal;  ///< outward, primitive
};

/// An edge of a facet of P, counter-clockwise seen from outside: a vertex or an edge of either
/// body, not both vertices; two edges are parallel, and walked in the same sense. The faces alone
/// tell which edge of P it is.
struct SumEdge {
  Face a, b;
  polytope::VertexId from_a, to_a, from_b, to_b;  ///< vertices; from = to for a vertex
};

class SumSurface {
 public:
  /// The polytopes, values that convex_hull returned, must outlive it. P must have an interior. O(m
  /// + n) space, nearly O(m + n) time.
  SumSurface(const polytope::Polytope& a, const polytope::Polytope& b)
      : minus_a_(a, gaussian::Colour::a), b_(b, gaussian::Colour::b) {}

  /// The facet with outward normal n, given all vertices of A that minimise <n,.> and all of B that
  /// maximise it.
  [[nodiscard]] SumFacet facet(const std::vector<polytope::VertexId>& face_a,
                               const std::vector<polytope::VertexId>& face_b, const Vector& n) const;

  /// A point of the facet; and the ends of an edge.
  [[nodiscard]] Vector point(const SumFacet& facet) const;
  [[nodiscard]] Vector from(const SumEdge& edge) const { return minus_a_.vertex(edge.from_a) + b_.vertex(edge.from_b); }
  [[nodiscard]] Vector to(const SumEdge& edge) const { return minus_a_.vertex(edge.to_a) + b_.vertex(edge.to_b); }

  /// All edges, in cyclic order: linear in the number of corners of both faces.
  [[nodiscard]] std::vector<SumEdge> edges(const SumFacet& facet) const;

  /// The facet beyond an edge of a facet. O(1), except for the degrees of the vertices that the
  /// edge is made of: *steps grows by them.
  [[nodiscard]] SumFacet across(const SumEdge& edge, std::uint64_t* steps) const;

 private:
  Summand minus_a_, b_;
};

}  // namespace fathom::approximate
