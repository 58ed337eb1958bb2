// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <numeric>

#include "kernels/filters/line_frame.hpp"
#include "reference/lines/cutting.hpp"

namespace fathom::lines {
namespace {

using Lines = std::vector<std::uint32_t>;

// Cells of at most this many lines are not refined.
constexpr std::size_t always_few = 8;

// `side` tells whose lines a cell holds; conflicts are lines of the other chain.
class SampledSearch {
 public:
  SampledSearch(const Grid& grid, LineSearch& search, const SampledSize& size)
      : clearing_(grid), search_(search), size_(size) {}

  void run() {
    Lines rows(clearing_.grid().rows()), columns(clearing_.grid().columns());
    std::iota(rows.begin(), rows.end(), 0U);
    std::iota(columns.begin(), columns.end(), 0U);
    solve(GridAxis::rows, rows, columns);
  }

 private:
  struct Cell {
    Lines lines, conflicts;
    kernels::LineFrame<double> frame;
  };

  // Cuts `lines` against `list`, swaps the roles, and so on. Each swap's lists are shorter, by the
  // quota or by `few`.
  void solve(GridAxis side, const Lines& lines, const Lines& list) {
    if (lines.size() * list.size() <= size_.base || std::max(lines.size(), list.size()) <= always_few) {
      const auto [rows, columns] = rows_and_columns(side, lines, list);
      scan(rows, columns);
      return;
    }
    std::vector<Cell> cells = cut(side, lines, list);
    std::ranges::shuffle(cells, search_.random());
    const std::uint64_t known = search_.improvements();
    for (Cell& cell : cells) {
      // Can it still beat the best?
      if (search_.improvements() != known) cell.conflicts = conflicts(side, cell, cell.conflicts);
      if (!cell.conflicts.empty()) solve(other(side), cell.conflicts, cell.lines);
    }
  }

  std::vector<Cell> cut(GridAxis side, const Lines& lines, const Lines& list) {
    const Lines sample = sample_of(list);
    const std::size_t few = std::max(always_few, lines.size() / (size_.r * size_.r * size_.r)),
                      quota = list.size() / size_.r;
    Counters& counters = search_.counters();
    std::vector<Cell> done, pending;
    pending.push_back(cell(side, lines, list));
    while (!pending.empty()) {
      Cell top = std::move(pending.back());
      pending.pop_back();
      ++counters.cells;
      const bool small = top.lines.size() <= few;
      if (small || conflicts(side, top, sample).empty()) {
        top.conflicts = conflicts(side, top, top.conflicts);
        ++counters.quota_checks;
        if (top.conflicts.empty()) continue;
        if (small || top.conflicts.size() <= quota) {
          counters.few_cells += top.conflicts.size() > quota;
          done.push_back(std::move(top));
          continue;
        }
        ++counters.quota_refinements;
      }
      const auto middle = top.lines.begin() + static_cast<std::ptrdiff_t>(top.lines.size() / 2);
      pending.push_back(cell(side, Lines(middle, top.lines.end()), top.conflicts));
      pending.push_back(cell(side, Lines(top.lines.begin(), middle), std::move(top.conflicts)));
    }
    return done;
  }

  Cell cell(GridAxis side, Lines lines, Lines conflicts) {
    const kernels::LineFrame<double> frame = kernels::line_frame(images(side), lines);
    return {std::move(lines), std::move(conflicts), frame};
  }

  Lines sample_of(const Lines& list) {
    Lines sample;
    std::ranges::sample(list, std::back_inserter(sample),
                        static_cast<std::ptrdiff_t>(size_.r * std::bit_width(size_.r)), search_.random());
    return sample;
  }

  // The lines that are not proved to be strictly farther than the best from all lines of the cell.
  Lines conflicts(GridAxis side, const Cell& cell, const Lines& list) {
    Lines result;
    for (const std::uint32_t line : list) {
      if (!clears(side, cell, line)) result.push_back(line);
    }
    return result;
  }

  bool clears(GridAxis side, const Cell& cell, std::uint32_t line) {
    Counters& counters = search_.counters();
    ++counters.block_tests;
    search_.work(16);
    const kernels::BlockSide own = side_of(cell.lines), one{line, line, line};
    const auto [rows, columns] = rows_and_columns(side, own, one);
    if (clearing_.vertex_clears({rows, columns}, search_.nearest(), search_.bound())) {
      ++counters.vertex_clears;
      return true;
    }
    ++counters.frame_tests;
    const kernels::LineFrame<double> opposite = kernels::line_frame(images(other(side)), {&line, 1});
    const auto [row_frame, column_frame] = rows_and_columns(side, cell.frame, opposite);
    const bool clear = kernels::frames_beyond(row_frame, column_frame, search_.bound().above);
    counters.frame_clears += clear;
    return clear;
  }

  void scan(const Lines& rows, const Lines& columns) {
    const Grid& grid = clearing_.grid();
    std::vector<chart::ChartArcOfA> of_a;
    std::vector<chart::ChartArcOfB> of_b;
    for (const std::uint32_t i : rows) of_a.push_back(grid.row(i));
    for (const std::uint32_t j : columns) of_b.push_back(grid.column(j));
    search_.scan(of_a, of_b);
  }

  const kernels::LineImages& images(GridAxis side) const {
    return side == GridAxis::rows ? clearing_.rows() : clearing_.columns();
  }

  Clearing clearing_;
  LineSearch& search_;
  const SampledSize& size_;
};

}  // namespace

void closest_by_sampling(const Grid& grid, LineSearch& search, const SampledSize& size) {
  ++search.counters().grids_cut;
  SampledSearch(grid, search, size).run();
}

}  // namespace fathom::lines
