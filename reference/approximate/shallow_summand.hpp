// SPDX-License-Identifier: GPL-3.0-or-later
// One summand of P = B (+) (-A), with what a walk over P needs: the edges at a vertex, the edges around a face, and which face
// becomes extreme next when a direction is turned about an edge of P.                                    [proofs/shallow.md]
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/gaussian/colour.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::approximate {

/// A face of a polytope: vertex, edge or facet `index`. A polygon has two facets.
struct Face {
  enum class Kind : std::uint8_t { vertex, edge, facet };
  Kind kind = Kind::vertex;
  std::uint32_t index = 0;
  friend auto operator<=>(const Face&, const Face&) = default;
};

/// An edge in the sense in which it is walked.
struct FaceEdge {
  std::uint32_t from, to, edge;
};

/// What becomes extreme next in one summand, when a direction is turned.
struct Turn {
  bool never = true;  ///< true if nothing does, for lack of another vertex
  Vector x;           ///< from the old face's vertex to a new vertex
  Face face;          ///< the new face; it contains the old one
};

class Summand {
 public:
  /// B itself, or -A for colour a: the same numbering, each vertex and normal negated. The polytope, a value that convex_hull
  /// returned, must outlive it. Time O(n log n), space O(n).
  Summand(const polytope::Polytope& polytope, gaussian::Colour colour);

  [[nodiscard]] const polytope::Polytope& polytope() const { return *polytope_; }
  [[nodiscard]] const Vector& vertex(std::uint32_t v) const { return vertices_[v]; }
  [[nodiscard]] Vector normal(std::uint32_t facet) const;
  /// A vertex of the face.
  [[nodiscard]] std::uint32_t corner(const Face& face) const;

  /// The face of these vertices, which are all that are extreme in direction n.
  [[nodiscard]] Face face_of(std::span<const std::uint32_t> vertices, const Vector& n) const;

  /// Counter-clockwise seen from outside. A vertex has no sides, an edge two: there and back.
  [[nodiscard]] std::vector<FaceEdge> sides(const Face& face) const;

  /// `face`, a vertex or an edge along d, is extreme in all directions just after n when n is turned about d, where <n,d> = 0, by a
  /// right-handed rotation; `from` is a vertex of it, the end from which d comes if it is an edge. Returns what becomes extreme next,
  /// before half a turn is over. A vertex costs its degree, which is added to *steps.
  [[nodiscard]] Turn turn(const Face& face, std::uint32_t from, const Vector& d, std::uint64_t* steps) const;

 private:
  struct Spoke {
    std::uint32_t other, edge;
  };

  [[nodiscard]] std::span<const Spoke> star(std::uint32_t v) const;
  [[nodiscard]] std::uint32_t edge_between(std::uint32_t v, std::uint32_t w) const;
  [[nodiscard]] std::uint32_t right_of(std::uint32_t edge, std::uint32_t from) const;
  [[nodiscard]] std::uint32_t common_facet(std::uint32_t edge, std::uint32_t other_edge, const Vector& n) const;
  [[nodiscard]] Turn turn_at_edge(std::uint32_t edge, std::uint32_t from) const;

  const polytope::Polytope* polytope_;
  bool reflected_;
  std::vector<Vector> vertices_;
  std::vector<std::uint32_t> first_spoke_;  // of each vertex, and one past the last
  std::vector<Spoke> spokes_;               // those of a vertex in ascending order of `other`
  std::vector<std::uint32_t> edge_after_;   // of each of the polytope's corners: the edge to the next corner of its facet
};

}  // namespace fathom::approximate
