// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the charts of one hemisphere, and the lines through the bodies' edges.
// Output  the line of each chart arc, directed upward: searches for closest lines name lines by
//         chart arcs alone.
// Size    linear.
#pragma once

#include "kernels/filters/line_filter.hpp"
#include "kernels/nearest.hpp"
#include "reference/chart/chart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::lines {

// The lines that carry a body's edges, and the planes that two of them span.     [AGHRS, Lemma 2.2]

/// The lines through the edges of the body of one colour, exact and as images. Line i carries edge
/// i. The polytope must outlive it.
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

/// Offers the plane that is parallel to edge e of A and edge f of B, oriented away from O, in exact
/// arithmetic. Skips parallel edges, which span no plane. N = <q - p, d x d'>, and d^2(l,l') = N^2
/// / |d x d'|^2. Returns whether the plane is among the nearest now.
bool offer_edges(const EdgeLinesOfA& a, gaussian::EdgeOfA e, const EdgeLinesOfB& b, gaussian::EdgeOfB f,
                 kernels::NearestPlanes& nearest);

/// The lines of one colour's chart arcs, directed upward in the chart: <d,v> > 0. Line i carries
/// the edge of chart arc i.
template <gaussian::Colour c>
class ChartLines {
 public:
  using Arc = chart::ChartArcOf<c>;

  ChartLines(const chart::ColourChart& chart, const EdgeLines<c>& lines);

  [[nodiscard]] gaussian::EdgeOf<c> edge(Arc i) const { return gaussian::EdgeOf<c>(arc(i).arc.value); }
  [[nodiscard]] const Vector& point(Arc i) const { return lines_->point(edge(i)); }
  [[nodiscard]] Vector direction(Arc i) const {
    return arc(i).flipped ? -lines_->direction(edge(i)) : lines_->direction(edge(i));
  }
  [[nodiscard]] const kernels::LineImages& images() const { return images_; }
  /// In wide floats: one, or all. These refer to this.
  [[nodiscard]] kernels::WideLine wide(Arc i) const;
  [[nodiscard]] kernels::WideLines wide() const;
  [[nodiscard]] const EdgeLines<c>& lines() const { return *lines_; }

 private:
  [[nodiscard]] const chart::ChartArc& arc(Arc i) const { return chart_->arcs[chart::ChartArcId(i.value)]; }

  const chart::ColourChart* chart_;
  const EdgeLines<c>* lines_;
  kernels::LineImages images_;
};

/// The lines of both bodies in one hemisphere. The charts and the lines must outlive it.
struct LineScene {
  Vector pole;
  ChartLines<gaussian::Colour::a> a;
  ChartLines<gaussian::Colour::b> b;

  LineScene(const chart::Charts& charts, const EdgeLinesOfA& lines_a, const EdgeLinesOfB& lines_b)
      : pole(charts.frame.z.exact()), a(charts.of.a, lines_a), b(charts.of.b, lines_b) {}
};

/// As offer_edges, of the edges of two chart arcs.
bool offer_arcs(const LineScene& scene, chart::ChartArcOfA e, chart::ChartArcOfB f, kernels::NearestPlanes& nearest);

}  // namespace fathom::lines
