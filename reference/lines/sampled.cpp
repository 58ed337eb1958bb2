// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/sampled.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>

namespace fathom {
namespace {

using Lines = std::vector<std::uint32_t>;

// Cells of so few lines are never refined.
constexpr std::size_t always_few = 8;

class Engine {
 public:
  Engine(const Grid& grid, LineSearch& search, const SampledSize& size) : clearing_(grid), search_(search), size_(size) {}

  void run() {
    Lines rows(clearing_.grid().rows()), columns(clearing_.grid().columns());
    std::iota(rows.begin(), rows.end(), 0U);
    std::iota(columns.begin(), columns.end(), 0U);
    solve(true, rows, columns);
  }

 private:
  struct Cell {
    Lines lines, conflicts;
    LineFrame frame;
  };

  // Cuts `lines` against `list`, swaps the roles, and so on. Each swap's lists are shorter, by the quota or by `few`.
  void solve(bool rows, const Lines& lines, const Lines& list) {
    if (lines.size() * list.size() <= size_.base || std::max(lines.size(), list.size()) <= always_few) {
      scan(rows ? lines : list, rows ? list : lines);
      return;
    }
    std::vector<Cell> cells = cut(rows, lines, list);
    std::ranges::shuffle(cells, search_.random());
    const std::uint64_t known = search_.improvements();
    for (Cell& cell : cells) {
      if (search_.stopped()) return;
      // Can it still beat the best?
      if (search_.improvements() != known) cell.conflicts = conflicts(rows, cell, cell.conflicts);
      if (!cell.conflicts.empty()) solve(!rows, cell.conflicts, cell.lines);
    }
  }

  std::vector<Cell> cut(bool rows, const Lines& lines, const Lines& list) {
    const Lines sample = sample_of(list);
    const std::size_t few = std::max(always_few, lines.size() / (size_.r * size_.r * size_.r)), quota = list.size() / size_.r;
    Counters& counters = search_.counters();
    std::vector<Cell> done, pending;
    pending.push_back(cell(rows, lines, list));
    while (!pending.empty() && !search_.stopped()) {
      Cell top = std::move(pending.back());
      pending.pop_back();
      ++counters.cells;
      const bool small = top.lines.size() <= few;
      if (small || conflicts(rows, top, sample).empty()) {
        top.conflicts = conflicts(rows, top, top.conflicts);
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
      pending.push_back(cell(rows, Lines(middle, top.lines.end()), top.conflicts));
      pending.push_back(cell(rows, Lines(top.lines.begin(), middle), std::move(top.conflicts)));
    }
    return done;
  }

  Cell cell(bool rows, Lines lines, Lines conflicts) {
    LineFrame frame = line_frame(rows ? clearing_.rows() : clearing_.columns(), lines);
    return {std::move(lines), std::move(conflicts), frame};
  }

  Lines sample_of(const Lines& list) {
    Lines sample;
    std::ranges::sample(list, std::back_inserter(sample), static_cast<std::ptrdiff_t>(size_.r * std::bit_width(size_.r)), search_.random());
    return sample;
  }

  // The lines that are not proved to be strictly farther than the best from all lines of the cell.
  Lines conflicts(bool rows, const Cell& cell, const Lines& list) {
    Lines result;
    for (const std::uint32_t line : list) {
      if (!clears(rows, cell, line)) result.push_back(line);
    }
    return result;
  }

  bool clears(bool rows, const Cell& cell, std::uint32_t line) {
    const std::span<const std::uint32_t> one(&line, 1), many(cell.lines);
    Counters& counters = search_.counters();
    ++counters.block_tests;
    search_.work(16);
    if (clearing_.vertex_clears(rows ? many : one, rows ? one : many, search_.nearest(), search_.bound())) {
      ++counters.vertex_clears;
      return true;
    }
    ++counters.frame_tests;
    const LineFrame other = line_frame(rows ? clearing_.columns() : clearing_.rows(), one);
    const bool clear = frames_beyond(rows ? cell.frame : other, rows ? other : cell.frame, search_.bound().above);
    counters.frame_clears += clear;
    return clear;
  }

  void scan(const Lines& rows, const Lines& columns) {
    const Grid& grid = clearing_.grid();
    Lines of_a, of_b;
    for (const std::uint32_t i : rows) of_a.push_back(grid.edge_of_row(i));
    for (const std::uint32_t j : columns) of_b.push_back(grid.edge_of_column(j));
    search_.scan(of_a, of_b);
  }

  Clearing clearing_;
  LineSearch& search_;
  const SampledSize& size_;
};

}  // namespace

void closest_by_sampling(const Grid& grid, LineSearch& search, const SampledSize& size) {
  ++search.counters().grids_cut;
  Engine(grid, search, size).run();
}

}  // namespace fathom
