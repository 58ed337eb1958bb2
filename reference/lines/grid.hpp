// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a canonical pair and the charts it comes from.
// Output  its grid: A's edges as rows and B's as columns, each a chain in the order in which it meets the other, and all directions
//         oriented so that d x d' is the outward normal of P's facet wherever row d crosses column d'.  [proofs/canonical_subsets.md]
// Why     the stored arcs span a strip and do not cross; each query crosses all of them, from below to above or the other way round, and
//         queries do not cross each other. So the lowest and the highest stored arc meet the queries in one order, as all others do.
#pragma once

#include <array>

#include "kernels/filters/line_scan.hpp"
#include "kernels/report.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/lines/edge_lines.hpp"

namespace fathom {

/// A view: the pair's sets, the charts and the lines must outlive it.
class Grid {
 public:
  Grid(const CanonicalPair& pair, const Charts& charts, const EdgeLines& a, const EdgeLines& b);

  [[nodiscard]] std::size_t rows() const { return edges_a_.size(); }
  [[nodiscard]] std::size_t columns() const { return edges_b_.size(); }
  [[nodiscard]] std::uint32_t edge_of_row(std::size_t i) const { return edges_a_[i]; }
  [[nodiscard]] std::uint32_t edge_of_column(std::size_t j) const { return edges_b_[j]; }
  [[nodiscard]] const EdgeLines& lines_a() const { return *a_; }
  [[nodiscard]] const EdgeLines& lines_b() const { return *b_; }

  /// The oriented directions, and a point of each edge.
  [[nodiscard]] Vector row_direction(std::size_t i) const;
  [[nodiscard]] Vector column_direction(std::size_t j) const;
  [[nodiscard]] const Vector& row_point(std::size_t i) const { return a_->point(edge_of_row(i)); }
  [[nodiscard]] const Vector& column_point(std::size_t j) const { return b_->point(edge_of_column(j)); }
  /// Images of the oriented lines: of both chains, or of three members each.
  [[nodiscard]] LineImages row_images() const;
  [[nodiscard]] LineImages column_images() const;
  [[nodiscard]] LineImages row_images(const std::array<std::size_t, 3>& chosen) const;
  [[nodiscard]] LineImages column_images(const std::array<std::size_t, 3>& chosen) const;

  /// The sign of <w, next row>, and of <w, next column>, at each crossing w: what it means that the chains are in order.
  [[nodiscard]] int row_sense() const;
  [[nodiscard]] int column_sense() const;

  /// Offers the plane of one crossing.
  bool offer(std::size_t row, std::size_t column, NearestPlanes& nearest) const;

 private:
  [[nodiscard]] bool rows_turned() const;
  [[nodiscard]] bool row_reversed(std::size_t i) const;
  [[nodiscard]] bool column_reversed(std::size_t j) const;

  const Charts* charts_;
  const EdgeLines* a_;
  const EdgeLines* b_;
  std::span<const std::uint32_t> edges_a_, edges_b_;
  Colour stored_of_;
  bool rising_;
};

/// Order: each row meets neighbouring columns in the chain's order, each column neighbouring rows (weakly, since the input may have
/// closed what the perturbation opened), and all crossings lie in the hemisphere. Membership: at each crossing that is not parallel, no
/// neighbour's point lies farther out than the crossing's own, and O lies below it: so p - q is a vertex of P and the vertex test holds.
/// O(rows columns).
[[nodiscard]] Report validate(const Grid& grid, const Charts& charts);

}  // namespace fathom
