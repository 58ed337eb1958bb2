// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a grid, and the nearest planes so far.
// Output  for a block of rows and columns: is every pair of it strictly farther than those? Two tests, either of which clears:
//         the vertex test (one vertex of P, the four corner crossings; exact) and the frame test (Taylor models of parabolic frames).
//         [proofs/cutting.md]
#pragma once

#include "kernels/filters/corner_bound.hpp"
#include "kernels/filters/line_frame.hpp"
#include "reference/lines/grid.hpp"

namespace fathom {

/// The block tests of one grid. Block sides are ascending positions in the grid's chains; not empty.
class Clearing {
 public:
  using Lines = std::span<const std::uint32_t>;

  explicit Clearing(const Grid& grid) : grid_(grid), rows_(grid.row_images()), columns_(grid.column_images()) {}

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const LineImages& rows() const { return rows_; }
  [[nodiscard]] const LineImages& columns() const { return columns_; }

  /// The vertex test. `bound` is the images' bound of `nearest`, which may not be empty unless the bound is infinite. The answer is that
  /// of exact arithmetic: it does not depend on rounding.
  [[nodiscard]] bool vertex_clears(Lines rows, Lines columns, const NearestPlanes& nearest, const LineBound& bound) const;

  /// The least estimate of a pair's squared distance over the corners and the middle: for the order of a search, not a bound.
  [[nodiscard]] double estimate(Lines rows, Lines columns) const;

 private:
  const Grid& grid_;
  LineImages rows_, columns_;
};

/// The vertex test on a whole canonical pair, without images of its chains: can it beat the best at all? O(1).
[[nodiscard]] bool vertex_clears(const Grid& grid, const NearestPlanes& nearest, const LineBound& bound);

}  // namespace fathom
