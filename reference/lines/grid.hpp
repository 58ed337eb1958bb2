// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the charts of one hemisphere, and the lines through the bodies' edges.
// Output  the line of each chart arc, directed upward: searches for closest lines name lines by
//         chart arcs alone.
// Size    linear.
#pragma once

#include <array>
#include <utility>

#include "kernels/filters/line_filter.hpp"
#include "kernels/messages.hpp"
#include "kernels/nearest.hpp"
#include "reference/canonical/canonical_subsets.hpp"
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

// Input   a canonical pair and the scene of its hemisphere.
// Output  its grid: A's arcs as rows and B's as columns, each a chain in the order in which it
//         meets the other, and all directions oriented so that d x d' is the outward normal of P's
//         facet wherever row d crosses column d'.                   [proofs/cutting.md, "The grid"]
// Why     the stored arcs span a strip and do not cross; each query crosses all of them, from below
//         to above or the other way round, and queries do not cross each other. So the lowest and
//         the highest stored arc meet the queries in one order, as all others do.

enum class GridAxis : std::uint8_t { rows, columns };

constexpr GridAxis other(GridAxis s) { return s == GridAxis::rows ? GridAxis::columns : GridAxis::rows; }

/// What belongs to the rows, and what to the columns, if `own` belongs to `axis` and `opposite` to
/// the other one.
template <class T>
constexpr std::pair<T&, T&> rows_and_columns(GridAxis axis, T& own, T& opposite) {
  return axis == GridAxis::rows ? std::pair<T&, T&>(own, opposite) : std::pair<T&, T&>(opposite, own);
}

/// A view: the pair's sets and the scene must outlive it.
class Grid {
 public:
  Grid(const canonical::CanonicalPair& pair, const LineScene& scene) : pair_(pair), scene_(&scene) {}

  [[nodiscard]] std::size_t rows() const { return pair_.a.size(); }
  [[nodiscard]] std::size_t columns() const { return pair_.b.size(); }
  [[nodiscard]] chart::ChartArcOfA row(std::size_t i) const { return pair_.a[i]; }
  [[nodiscard]] chart::ChartArcOfB column(std::size_t j) const { return pair_.b[j]; }
  [[nodiscard]] const LineScene& scene() const { return *scene_; }

  /// The oriented directions, and a point of each edge.
  [[nodiscard]] Vector row_direction(std::size_t i) const;
  [[nodiscard]] Vector column_direction(std::size_t j) const { return scene_->b.direction(column(j)); }
  [[nodiscard]] const Vector& row_point(std::size_t i) const { return scene_->a.point(row(i)); }
  [[nodiscard]] const Vector& column_point(std::size_t j) const { return scene_->b.point(column(j)); }
  /// Images of the oriented lines: of both chains, or of three members each.
  [[nodiscard]] kernels::LineImages row_images() const;
  [[nodiscard]] kernels::LineImages column_images() const;
  [[nodiscard]] kernels::LineImages row_images(const std::array<std::size_t, 3>& chosen) const;
  [[nodiscard]] kernels::LineImages column_images(const std::array<std::size_t, 3>& chosen) const;

  /// The oriented lines of both chains in wide floats. They refer to the grid's scene.
  [[nodiscard]] kernels::WideLines wide_rows() const;
  [[nodiscard]] kernels::WideLines wide_columns() const;

  /// The sign of <w, next row>, and of <w, next column>, at each crossing w: what it means that the
  /// chains are in order.
  [[nodiscard]] kernels::Sign row_sense() const;
  [[nodiscard]] kernels::Sign column_sense() const;

 private:
  [[nodiscard]] bool rows_turned() const { return (pair_.stored_of == gaussian::Colour::a) != pair_.rising; }
  [[nodiscard]] kernels::LineImages turned_rows(const auto& chosen) const;

  canonical::CanonicalPair pair_;
  const LineScene* scene_;
};

/// Order: each row meets neighbouring columns in the chain's order, each column neighbouring rows
/// (weakly, since the input may have closed what the perturbation opened), and all crossings lie in
/// the hemisphere. Membership: at each crossing that is not parallel, no neighbour's point lies
/// farther out than the crossing's own, and O lies below it: so p - q is a vertex of P and the
/// vertex test holds. O(rows columns).
[[nodiscard]] kernels::Report validate(const Grid& grid);

// The vertex test: is every pair of a block of rows and columns proved to be strictly farther than
// the nearest planes so far? Then the block is clear. One vertex of P against the four corner
// crossings, exact.                                                             [proofs/cutting.md]

/// Ascending positions in one chain of a grid; not empty.
using ChainLines = std::span<const std::uint32_t>;

inline kernels::BlockSide side_of(ChainLines lines) { return {lines.front(), lines[lines.size() / 2], lines.back()}; }

/// The block tests of one grid.
class Clearing {
 public:
  explicit Clearing(const Grid& grid) : grid_(grid), rows_(grid.row_images()), columns_(grid.column_images()) {}

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const kernels::LineImages& rows() const { return rows_; }
  [[nodiscard]] const kernels::LineImages& columns() const { return columns_; }

  /// The vertex test, for all lines between the block's first and last ones. `bound` is the images'
  /// bound of `nearest`, which may not be empty unless the bound is infinite. The answer is that of
  /// exact arithmetic: it does not depend on rounding.
  [[nodiscard]] bool vertex_clears(const kernels::Block& block, const kernels::NearestPlanes& nearest,
                                   const kernels::LineBound& bound) const;

  /// The least estimate of a pair's squared distance over the corners and the middle: for the order
  /// of a search, not a bound.
  [[nodiscard]] double estimate(const kernels::Block& block) const;

 private:
  Grid grid_;
  kernels::LineImages rows_, columns_;
};

/// The vertex test on a whole grid, without images of its chains: can it beat the best at all?
/// O(1).
[[nodiscard]] bool vertex_clears(const Grid& grid, const kernels::NearestPlanes& nearest,
                                 const kernels::LineBound& bound);

}  // namespace fathom::lines
