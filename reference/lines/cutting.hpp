// SPDX-License-Identifier: GPL-3.0-or-later
// What all engines share (the one global best, the bound that the filters compare with, the naive
// scan, the counts of work), and the engine that cuts.
#pragma once

#include <array>
#include <bit>
#include <deque>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "kernels/context.hpp"
#include "kernels/filters/line_filter.hpp"
#include "kernels/filters/line_frame.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"

namespace fathom::lines {

/// One for each hemisphere. `nearest` holds the best so far of all. A trace, which may be null, is
/// written and never read.
class LineSearch {
 public:
  LineSearch(kernels::Context& context, const LineScene& scene, kernels::NearestPlanes& nearest, std::uint64_t seed,
             SearchTrace* trace = nullptr);

  /// All pairs of two sets of arcs.
  void scan(std::span<const chart::ChartArcOfA> of_a, std::span<const chart::ChartArcOfB> of_b);
  /// All pairs of a run of rows and a run of columns.
  void scan(const Clearing& clearing, kernels::LineRun rows, kernels::LineRun columns);
  /// One pair, in exact arithmetic; or, where many turn out to be farther, in wide floats first.
  void offer(chart::ChartArcOfA e, chart::ChartArcOfB f);

  /// The squared distance of the nearest planes so far, in images, in wide floats (if there are any
  /// planes), and exact.
  [[nodiscard]] const kernels::LineBound& bound() const { return bound_; }
  [[nodiscard]] const kernels::WideFloat& wide_bound();
  [[nodiscard]] const kernels::NearestPlanes& nearest() const { return nearest_; }
  [[nodiscard]] Counters& counters() const { return context_.counters; }
  /// How many pairs the filter in binary64 has left.
  [[nodiscard]] std::uint64_t offers() const { return offers_; }
  /// How often the best has become nearer.
  [[nodiscard]] std::uint64_t improvements() const { return improvements_; }
  [[nodiscard]] std::mt19937_64& random() { return random_; }
  [[nodiscard]] SearchTrace* trace() const { return trace_; }

  /// Notes a piece of work. From time to time it throws Interrupted if the search is to stop.
  void work(std::uint64_t amount);

 private:
  void tighten();

  kernels::Context& context_;
  const LineScene& scene_;
  kernels::NearestPlanes& nearest_;
  kernels::LineBound bound_;
  std::optional<kernels::WideFloat> wide_bound_;  // computed when it is asked for
  kernels::WideLines wide_a_, wide_b_;
  std::uint64_t offers_ = 0;
  std::uint64_t farther_ = 0;  // those that only exact arithmetic has shown to be farther
  kernels::LineImages block_;
  std::vector<std::uint32_t> unsure_;
  std::mt19937_64 random_;
  std::uint64_t improvements_ = 0;
  std::uint64_t since_check_ = 0;
  SearchTrace* trace_;
};

// Input   a grid, and the nearest planes so far.
// Output  those planes and all of the grid's that are as near or nearer.
//                                                                [proofs/cutting.md, "The engines"]
// How     cuts one chain into runs (cells). Each cell has a conflict list: the runs of the other
//         chain that it may approach, with at most 1/r of the lines there were. Then the roles are
//         swapped, and each conflicting run is cut against the cell. A naive scan ends the
//         recursion. A block is dropped only if it is strictly farther than the best so far. Where
//         tests cost too much for what they clear, the rest is scanned: never more than a constant
//         slower than the naive engine. Departs from the paper: no bound on the number of cells is
//         proved. proofs/cutting.md says what is kept and what is measured.

// The cells of one chain: contiguous runs of the grid's order, halved again and again. Their frames
// are made only when asked for.

/// A cell. Heap order: 1 is the whole chain, 2k and 2k + 1 are the halves of k.
using CellNode = std::uint64_t;

/// Which lines the cells of a chain hold.
class CellTree {
 public:
  static constexpr CellNode root = 1;

  explicit CellTree(std::size_t lines) : order_(lines) { std::iota(order_.begin(), order_.end(), 0U); }

  [[nodiscard]] kernels::LineRun run(CellNode k) const {
    const CellNode level = std::bit_floor(k), place = k - level;
    return {static_cast<std::size_t>(place * order_.size() / level),
            static_cast<std::size_t>((place + 1) * order_.size() / level)};
  }
  [[nodiscard]] std::size_t size(CellNode k) const { return run(k).size(); }
  [[nodiscard]] std::span<const std::uint32_t> lines(CellNode k) const {
    const kernels::LineRun r = run(k);
    return std::span(order_).subspan(r.first, r.size());
  }

 private:
  std::vector<std::uint32_t> order_;
};

/// The frames of a chain's cells, made when they are first asked for. The tree and the lines must
/// outlive it.
template <class Lines>
class CellFrames {
 public:
  using Frame = kernels::LineFrame<typename Lines::Number>;

  CellFrames(const CellTree& tree, const Lines& lines) : tree_(&tree), lines_(&lines) {}

  /// The frame of all lines of the cell. Linear in them when first asked for.
  [[nodiscard]] const Frame& whole(CellNode k) {
    return wholes_.of(k, [&] {
      lines_framed_ += tree_->size(k);
      return kernels::line_frame(*lines_, tree_->lines(k));
    });
  }
  /// The frame of a few of them. A cheap pre-test: if the sketch does not clear, the full frame
  /// almost never does.
  [[nodiscard]] const Frame& sketch(CellNode k) {
    return sketches_.of(k, [&] { return kernels::line_frame(*lines_, few_lines(k)); });
  }
  static constexpr std::size_t sketched = 9;
  using FewLines = std::array<std::uint32_t, sketched>;
  /// The lines of the sketch: ascending, the first and the last among them.
  [[nodiscard]] FewLines few_lines(CellNode k) const {
    FewLines few;
    const kernels::LineRun r = tree_->run(k);
    for (std::size_t i = 0; i < sketched; ++i)
      few[i] = static_cast<std::uint32_t>(r.first + i * (r.size() - 1) / (sketched - 1));
    return few;
  }
  /// How many lines went into the frames of whole cells so far: what these have cost.
  [[nodiscard]] std::uint64_t lines_framed() const { return lines_framed_; }

 private:
  // Frames by node, made on demand.
  struct Frames {
    std::vector<std::uint32_t> place;  // one more than the index of the node's frame, or 0
    std::deque<Frame> made;            // which stay where they are

    const Frame& of(CellNode k, const auto& make) {
      if (k >= place.size()) place.resize(std::bit_ceil(k + 1), 0);
      if (place[k] == 0) {
        made.push_back(make());
        place[k] = static_cast<std::uint32_t>(made.size());
      }
      return made[place[k] - 1];
    }
  };

  const CellTree* tree_;
  const Lines* lines_;
  Frames wholes_, sketches_;
  std::uint64_t lines_framed_ = 0;
};

// The blocks of a grid, runs of one chain against runs of the other, and the tests that are done
// with a block at once: from the cheapest to the one that sees most, each only where it may pay.
//                                                            [proofs/cutting.md, "The offset test"]

/// A grid with the cells of both chains. `side` tells whose lines a cell holds; a run of the other
/// chain is `opposite`.
class Blocks {
 public:
  Blocks(const Grid& grid, std::uint64_t allowance);
  Blocks(const Blocks&) = delete;  // the frames refer to the trees
  Blocks& operator=(const Blocks&) = delete;

  [[nodiscard]] const Clearing& clearing() const { return clearing_; }
  [[nodiscard]] const CellTree& tree(GridAxis s) const { return trees_[static_cast<std::size_t>(s)]; }

  /// Whether the block is done: every pair of it is proved to be strictly farther than the search's
  /// best, or has been offered to it. By the vertex test, or, where they may pay, by the frame
  /// test, the same in wide floats, or the offset test.
  bool clears(GridAxis side, CellNode cell, CellNode opposite, LineSearch& search);
  /// Whether the tests of this grid have cost more than they can be worth: an eighth of the time
  /// that scanning it takes, as far as that is known, and the allowance.
  [[nodiscard]] bool exhausted(const LineSearch& search) const;
  [[nodiscard]] double estimate(GridAxis side, CellNode cell, CellNode opposite) const;

 private:
  // Whether a kind of test is worth its cost, in pairs scanned: as long as it has not cost more
  // than what it saved and what is granted.
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

/// A cell of a cutting, with its conflict list.
struct Cell {
  CellNode cell;
  std::vector<CellNode> conflicts;
  std::uint64_t lines = 0;  ///< number of lines in the conflict list
  /// lines <= quota; otherwise the cell is too small to be refined, or the blocks are exhausted
  bool quota_reached = false;
};

/// A (1/r)-cutting of `cell` against the runs `list` of the other chain: halves cells, filters and
/// counts their conflict lists, and refines them while they are over the quota. Leaves out cells
/// with an empty list. The blocks cell x conflicts, together with those cleared strictly or
/// offered, hold all pairs. Nearer halves come first. When the blocks are exhausted, cells stay as
/// they are.
std::vector<Cell> cut(Blocks& blocks, GridAxis side, CellNode cell, const std::vector<CellNode>& list,
                      const CuttingSize& size, LineSearch& search);

/// Offers the grid's nearest planes to the search's best.
void closest_by_cutting(const Grid& grid, LineSearch& search, const CuttingSize& size = {});

// The sampled cutting, in closest_lines.cpp: the same answer, in the paper's own shape.
//                                                           [AGHRS, section 2.2; proofs/cutting.md]
// How     a random sample of r log2(r + 1) lines of one chain guides how the other is cut into
//         cells: a cell is halved while some line of the sample may approach it. Then its whole
//         conflict list is counted, line by line; over the quota |L|/r it is refined. Roles swap,
//         subproblems come in random order, and a naive scan ends it.
// Why     for study, and as a cross-check. It is not the sample that makes it fast, but the
//         conflict lists, which are counted anyway.

/// As closest_by_cutting.
void closest_by_sampling(const Grid& grid, LineSearch& search, const SampledSize& size = {});

}  // namespace fathom::lines
