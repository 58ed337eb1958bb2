// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a grid, runs of one chain against runs of the other, and the tests that are done with a block at once: from the cheapest to
// the one that sees most, each only where it may pay.                                        [proofs/cutting.md, "The offset test"]
#pragma once

#include <memory>
#include <optional>

#include "reference/lines/cutting.hpp"
#include "reference/lines/grid.hpp"
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

  [[nodiscard]] bool frames_promise(const LineSearch& search) const;
  bool frames_clear(CellNode row, CellNode column, LineSearch& search);
  // How many of the block's pairs the filter in binary64 would leave.
  [[nodiscard]] std::uint64_t offers_expected(CellNode row, CellNode column, double bound) const;
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
  Account test_account_, wide_account_;
  std::uint64_t frames_tried_ = 0, frames_held_ = 0;
  std::optional<std::uint64_t> offers_before_;  // those of the search when it first came here
};

}  // namespace fathom::lines
