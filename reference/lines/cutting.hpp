// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a grid, and the nearest planes so far.
// Output  those planes and all of the grid's that are as near or nearer.                              [proofs/cutting.md, "The engines"]
// How     cuts one chain into runs (cells). Each cell has a conflict list: the runs of the other chain that it may approach, with at most
//         1/r of the lines there were. Then the roles are swapped, and each conflicting run is cut against the cell. A naive scan ends
//         the recursion. A block is dropped only if it is strictly farther than the best so far. Where tests cost too much for what
//         they clear, the rest is scanned: never more than a constant slower than the naive engine.
// Departs from the paper: no bound on the number of cells is proved. proofs/cutting.md says what is kept and what is measured.
#pragma once

#include "reference/lines/closest_lines.hpp"

namespace fathom::lines {

/// A cell of a cutting, with its conflict list.
struct Cell {
  CellNode cell;
  std::vector<CellNode> conflicts;
  std::uint64_t lines = 0;     ///< number of lines in the conflict list
  bool quota_reached = false;  ///< lines <= quota; otherwise the cell is too small to be refined, or the blocks are exhausted
};

/// A (1/r)-cutting of `cell` against the runs `list` of the other chain: halves cells, filters and counts their conflict lists, and refines
/// them while they are over the quota. Leaves out cells with an empty list. The blocks cell x conflicts, together with those cleared
/// strictly or offered, hold all pairs. Nearer halves come first. When the blocks are exhausted, cells stay as they are.
std::vector<Cell> cut(Blocks& blocks, GridAxis side, CellNode cell, const std::vector<CellNode>& list, const CuttingSize& size,
                      LineSearch& search);

/// Offers the grid's nearest planes to the search's best.
void closest_by_cutting(const Grid& grid, LineSearch& search, const CuttingSize& size = {});

}  // namespace fathom::lines
