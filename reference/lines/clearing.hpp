// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a grid, and the nearest planes so far.
// Output  for a block of rows and columns: is every pair of it proved to be strictly farther than those? Then the block is clear. There
//         are two tests: the vertex test (one vertex of P against the four corner crossings, exact), which is here, and the frame test
//         (Taylor models of parabolic frames), which is in kernels/filters/line_frame.hpp.             [proofs/cutting.md]
#pragma once

#include "kernels/filters/line_filter.hpp"
#include "reference/lines/grid.hpp"

namespace fathom::lines {

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

  /// The vertex test, for all lines between the block's first and last ones. `bound` is the images' bound of `nearest`, which may not be
  /// empty unless the bound is infinite. The answer is that of exact arithmetic: it does not depend on rounding.
  [[nodiscard]] bool vertex_clears(const kernels::Block& block, const kernels::NearestPlanes& nearest,
                                   const kernels::LineBound& bound) const;

  /// The least estimate of a pair's squared distance over the corners and the middle: for the order of a search, not a bound.
  [[nodiscard]] double estimate(const kernels::Block& block) const;

 private:
  Grid grid_;
  kernels::LineImages rows_, columns_;
};

/// The vertex test on a whole grid, without images of its chains: can it beat the best at all? O(1).
[[nodiscard]] bool vertex_clears(const Grid& grid, const kernels::NearestPlanes& nearest, const kernels::LineBound& bound);

}  // namespace fathom::lines
