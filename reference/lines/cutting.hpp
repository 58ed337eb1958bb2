// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a grid, and the nearest planes so far.
// Output  those planes and all of the grid's that are as near or nearer.                              [proofs/cutting.md, "The engines"]
// How     cuts one chain into runs (cells). Each cell has a conflict list: the runs of the other chain that it may approach, with at most
//         1/r of the lines there were. Then the roles are swapped, and each conflicting run is cut against the cell. A naive scan ends
//         the recursion. A block is dropped only if it is strictly farther than the best so far. Where tests cost too much for what
//         they clear, the rest is scanned: never more than a constant slower than the naive engine.
// Departs from the paper: no bound on the number of cells is proved. proofs/cutting.md says what is kept and what is measured.
#pragma once

#include <memory>

#include "reference/lines/cell_tree.hpp"
#include "reference/lines/clearing.hpp"
#include "reference/lines/engines.hpp"
#include "reference/lines/line_search.hpp"

namespace fathom::lines {

/// A grid with the cells of both chains. `side` tells whose lines a cell holds; a run of the other chain is `opposite`.
class Blocks {
 public:
  Blocks(const Grid& grid, std::uint64_t allowance);
  Blocks(const Blocks&) = delete;  // the frames refer to the trees
  Blocks& operator=(const Blocks&) = delete;

  [[nodiscard]] const Clearing& clearing() const { return clearing_; }
  [[nodiscard]] const CellTree& tree(GridAxis s) const { return trees_[static_cast<std::size_t>(s)]; }

  /// Whether the block is done: every pair of it is proved to be strictly farther than the search's best, or has been offered to it. By
  /// the vertex test, or, where they may pay, by the frame test, the same in wide floats, or the offset test.
  bool clears(GridAxis side, CellNode cell, CellNode opposite, LineSearch& search);
  /// Whether the tests of this grid have cost more than they can be worth: an eighth of the time that scanning it takes, as far as that is
  /// known, and the allowance.
  [[nodiscard]] bool exhausted(const LineSearch& search) const;
  [[nodiscard]] double estimate(GridAxis side, CellNode cell, CellNode opposite) const;

 private:
  // Whether a kind of test is worth its cost, in pairs scanned: as long as it has not cost more than what it saved and what is granted.
  struct Account {
    std::uint64_t free = 0, spent = 0, saved = 0;
    [[nodiscard]] bool worth_trying(std::uint64_t credit) const { return spent <= free + saved + credit; }
  };

  // What the frames are made of, in binary64 or wide.
  template <class Lines>
  struct Framed {
    CellFrames<Lines> rows, columns;
  };
  struct Wide {
    kernels::WideLines rows, columns;
    Framed<kernels::WideLines> frames;
    Wide(const Grid& grid, const std::array<CellTree, 2>& trees);
  };

  bool frames_clear(CellNode row, CellNode column, LineSearch& search);
  bool nearly_tied(CellNode row, CellNode column, double bound);
  bool wide_clears(CellNode row, CellNode column, LineSearch& search);
  bool whole_clears(CellNode row, CellNode column, LineSearch& search);
  bool offsets_may_clear(CellNode row, CellNode column, const kernels::WideFloat& bound);
  bool offsets_clear(CellNode row, CellNode column, LineSearch& search);
  // The lines' wide frames count, too.
  template <class Test>
  bool counting_lines(LineSearch& search, Test test);
  void spend(Account& account, std::uint64_t pairs, LineSearch& search);
  // What the pairs that the filter in binary64 left have cost, a part of it.
  [[nodiscard]] std::uint64_t credit(const LineSearch& search) const;

  [[nodiscard]] kernels::Block block(GridAxis side, CellNode cell, CellNode opposite) const;

  Clearing clearing_;
  std::array<CellTree, 2> trees_;
  Framed<kernels::LineImages> frames_;
  std::unique_ptr<Wide> wide_;
  Account vertex_account_, frames_account_, wide_account_;
  std::optional<std::uint64_t> offers_before_;  // those of the search when it first came here
};

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
