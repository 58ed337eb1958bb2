// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/cutting.hpp"

#include <algorithm>

namespace fathom::lines {
namespace {

using Node = CellNode;

int level(Node k) { return std::bit_width(k); }

// Notes what became of a block, if the search has a trace.
void note(const Blocks& blocks, GridAxis side, Node cell, Node run, std::uint32_t level, GridAxis cut, Treatment treatment,
          LineSearch& search) {
  SearchTrace* const trace = search.trace();
  if (!trace) return;
  const auto [row, column] = rows_and_columns(side, cell, run);
  trace->blocks.push_back(
      {trace->pair, level, cut, blocks.tree(GridAxis::rows).run(row), blocks.tree(GridAxis::columns).run(column), treatment});
}

// One cutting in the making.
class Cutter {
 public:
  Cutter(Blocks& blocks, GridAxis side, const CuttingSize& size, LineSearch& search)
      : blocks_(blocks), side_(side), size_(size), search_(search) {}

  std::vector<Cell> cut(Node cell, const std::vector<Node>& list) {
    quota_ = lines_of(list) / size_.r;
    if (own().size(cell) <= size_.few) return {Cell{cell, list, lines_of(list), false}};
    halve(cell, list);
    return std::move(cells_);
  }

 private:
  const CellTree& own() { return blocks_.tree(side_); }
  const CellTree& opposite() { return blocks_.tree(other(side_)); }

  std::uint64_t lines_of(const std::vector<Node>& list) {
    std::uint64_t lines = 0;
    for (const Node run : list) lines += opposite().size(run);
    return lines;
  }

  // Recursion as deep as the tree: logarithmic.
  void halve(Node cell, const std::vector<Node>& list) {
    std::array<Node, 2> halves{2 * cell, 2 * cell + 1};
    if (nearest_estimate(halves[1], list) < nearest_estimate(halves[0], list)) std::swap(halves[0], halves[1]);
    for (const Node half : halves) {
      Cell part{half, filter(half, list)};
      part.lines = lines_of(part.conflicts);
      part.quota_reached = part.lines <= quota_;
      ++search_.counters().cells;
      ++search_.counters().quota_checks;
      if (part.conflicts.empty()) continue;
      if (part.quota_reached || own().size(half) <= size_.few || blocks_.exhausted(search_)) {
        search_.counters().few_cells += !part.quota_reached;
        cells_.push_back(std::move(part));
      } else {
        ++search_.counters().quota_refinements;
        halve(half, part.conflicts);
      }
    }
  }

  // The runs of the list, no coarser than the cell, that are not cleared.
  std::vector<Node> filter(Node cell, const std::vector<Node>& list) {
    std::vector<Node> kept, pending(list.rbegin(), list.rend());
    while (!pending.empty()) {
      const Node run = pending.back();
      pending.pop_back();
      if (blocks_.clears(side_, cell, run, search_)) {
        note_cleared(cell, run);
        continue;
      }
      if (level(run) < level(cell) && opposite().size(run) > size_.few && !blocks_.exhausted(search_)) {
        pending.push_back(2 * run + 1);
        pending.push_back(2 * run);
      } else {
        kept.push_back(run);
      }
    }
    return kept;
  }

  void note_cleared(Node cell, Node run) {
    if (search_.trace()) note(blocks_, side_, cell, run, search_.trace()->level + 1, side_, Treatment::cleared, search_);
  }

  double nearest_estimate(Node cell, const std::vector<Node>& list) {
    double least = std::numeric_limits<double>::infinity();
    for (const Node run : list) least = std::min(least, blocks_.estimate(side_, cell, run));
    return least;
  }

  Blocks& blocks_;
  GridAxis side_;
  const CuttingSize& size_;
  LineSearch& search_;
  std::uint64_t quota_ = 0;
  std::vector<Cell> cells_;
};

// The search over one grid: cut, swap the roles, cut, ..., scan.
class Engine {
 public:
  Engine(const Grid& grid, LineSearch& search, const CuttingSize& size) : blocks_(grid, size.allowance), search_(search), size_(size) {}

  void run() { solve(GridAxis::rows, CellTree::root, {CellTree::root}, 0); }

 private:
  // Recursion as deep as both trees.
  void solve(GridAxis side, Node cell, const std::vector<Node>& list, std::uint32_t level) {
    std::uint64_t lines = 0, longest = blocks_.tree(side).size(cell);
    const std::uint64_t across = longest;
    for (const Node run : list) {
      const std::uint64_t along = blocks_.tree(other(side)).size(run);
      lines += along;
      longest = std::max(longest, along);
    }
    if (across * lines <= size_.base || longest <= size_.few || blocks_.exhausted(search_)) {
      for (const Node run : list) {
        note(blocks_, side, cell, run, level, cut_before(side, level), Treatment::scanned, search_);
        scan(side, cell, run);
      }
      return;
    }
    for (const Node run : list) note(blocks_, side, cell, run, level, cut_before(side, level), Treatment::cut, search_);
    if (search_.trace()) search_.trace()->level = level;
    std::vector<Cell> cells = cut(blocks_, side, cell, list, size_, search_);
    // The nearest cell comes first; the order of the others is random, so that improvements of the best are few.
    if (cells.size() > 2) std::shuffle(cells.begin() + 1, cells.end(), search_.random());
    const std::uint64_t known = search_.improvements();
    for (const Cell& part : cells) {
      for (const Node run : part.conflicts) {
        // Can it still beat the best?
        if (search_.improvements() != known && blocks_.clears(side, part.cell, run, search_)) {
          note(blocks_, side, part.cell, run, level + 1, side, Treatment::cleared, search_);
          continue;
        }
        solve(other(side), run, {part.cell}, level + 1);
      }
    }
  }

  // The cut that led to blocks which are now to be cut along `side`.
  static GridAxis cut_before(GridAxis side, std::uint32_t level) { return level == 0 ? GridAxis::rows : other(side); }

  void scan(GridAxis side, Node cell, Node run) {
    const auto [row, column] = rows_and_columns(side, cell, run);
    search_.scan(blocks_.clearing(), blocks_.tree(GridAxis::rows).run(row), blocks_.tree(GridAxis::columns).run(column));
  }

  Blocks blocks_;
  LineSearch& search_;
  const CuttingSize& size_;
};

}  // namespace

std::vector<Cell> cut(Blocks& blocks, GridAxis side, Node cell, const std::vector<Node>& list, const CuttingSize& size,
                      LineSearch& search) {
  return Cutter(blocks, side, size, search).cut(cell, list);
}

void closest_by_cutting(const Grid& grid, LineSearch& search, const CuttingSize& size) {
  ++search.counters().grids_cut;
  Engine(grid, search, size).run();
}

}  // namespace fathom::lines
