// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a grid, and the nearest planes so far.
// Output  those planes and all of the grid's that are as near or nearer.                              [proofs/cutting.md, "The engines"]
// How     cuts one chain into runs (cells). Each cell has a conflict list: the runs of the other chain that it may approach, with at most
//         1/r of the lines there were. Then the roles are swapped, and each conflicting run is cut against the cell. A naive scan ends
//         the recursion. A block is dropped only if it is strictly farther than the best so far.
// Departs from the paper: no bound on the number of cells is proved. proofs/cutting.md says what is kept and what is measured.
#pragma once

#include "reference/lines/cell_tree.hpp"
#include "reference/lines/clearing.hpp"
#include "reference/lines/engines.hpp"
#include "reference/lines/line_search.hpp"

namespace fathom::lines {

/// A grid with the cells of both chains. `side` tells whose lines a cell holds; a run of the other chain is `opposite`.
class Blocks {
 public:
  explicit Blocks(const Grid& grid) : clearing_(grid), trees_{CellTree(clearing_.rows()), CellTree(clearing_.columns())} {}
  Blocks(const Blocks&) = delete;  // the trees refer to the images
  Blocks& operator=(const Blocks&) = delete;

  [[nodiscard]] const Clearing& clearing() const { return clearing_; }
  [[nodiscard]] CellTree& tree(GridAxis s) { return trees_[static_cast<std::size_t>(s)]; }
  [[nodiscard]] const CellTree& tree(GridAxis s) const { return trees_[static_cast<std::size_t>(s)]; }

  /// Whether every pair of the block is proved to be strictly farther than the search's best: by the vertex test, or by the frame test
  /// where it may pay.
  bool clears(GridAxis side, CellTree::Node cell, CellTree::Node opposite, LineSearch& search);
  [[nodiscard]] double estimate(GridAxis side, CellTree::Node cell, CellTree::Node opposite) const;

 private:
  bool frames_clear(CellTree::Node row, CellTree::Node column, LineSearch& search);

  [[nodiscard]] kernels::Block block(GridAxis side, CellTree::Node cell, CellTree::Node opposite) const;

  Clearing clearing_;
  std::array<CellTree, 2> trees_;
  std::uint64_t frames_tried_ = 0, frames_held_ = 0;
};

/// A cell of a cutting, with its conflict list.
struct Cell {
  CellTree::Node cell;
  std::vector<CellTree::Node> conflicts;
  std::uint64_t lines = 0;     ///< number of lines in the conflict list
  bool quota_reached = false;  ///< lines <= quota; otherwise the cell is too small to be refined
};

/// A (1/r)-cutting of `cell` against the runs `list` of the other chain: halves cells, filters and counts their conflict lists, and refines
/// them while they are over the quota. Leaves out cells with an empty list. The blocks cell x conflicts, together with those cleared
/// strictly, hold all pairs. Nearer halves come first.
std::vector<Cell> cut(Blocks& blocks, GridAxis side, CellTree::Node cell, const std::vector<CellTree::Node>& list, const CuttingSize& size,
                      LineSearch& search);

/// Offers the grid's nearest planes to the search's best.
void closest_by_cutting(const Grid& grid, LineSearch& search, const CuttingSize& size = {});

}  // namespace fathom::lines
