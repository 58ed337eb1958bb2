// SPDX-License-Identifier: GPL-3.0-or-later
// The lines that carry a body's edges, and the planes that two of them span.                    [AGHRS, Lemma 2.2]
#pragma once

#include "kernels/filters/line_filter.hpp"
#include "kernels/nearest.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::lines {

/// The lines through the edges of the body of one colour, exact and as images. Line i carries edge i. The polytope must outlive it.
template <gaussian::Colour c>
class EdgeLines {
 public:
  using Edge = gaussian::EdgeOf<c>;

  /// `exponent` bounds the coordinates of both bodies: |c| <= 2^exponent.
  EdgeLines(const polytope::Polytope& polytope, long exponent);

  [[nodiscard]] std::size_t size() const { return polytope_->edges.size(); }
  [[nodiscard]] kernels::IdsBelow<Edge> ids() const { return kernels::IdsBelow<Edge>(size()); }
  [[nodiscard]] const Vector& point(Edge edge) const { return polytope_->vertices[polytope_->edges[edge.value].from]; }
  [[nodiscard]] Vector direction(Edge edge) const;
  [[nodiscard]] const kernels::LineImages& images() const { return images_; }

 private:
  const polytope::Polytope* polytope_;
  kernels::LineImages images_;
};

using EdgeLinesOfA = EdgeLines<gaussian::Colour::a>;
using EdgeLinesOfB = EdgeLines<gaussian::Colour::b>;

/// Offers the plane that is parallel to edge e of A and edge f of B, oriented away from O, in exact arithmetic. Skips parallel edges, which
/// span no plane. N = <q - p, d x d'>, and d^2(l,l') = N^2 / |d x d'|^2. Returns whether the plane is among the nearest now.
bool offer_edges(const EdgeLinesOfA& a, gaussian::EdgeOfA e, const EdgeLinesOfB& b, gaussian::EdgeOfB f, kernels::NearestPlanes& nearest);

}  // namespace fathom::lines
