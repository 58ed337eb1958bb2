// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/closest_lines.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "kernels/filters/line_frame.hpp"
#include "reference/lines/cutting.hpp"

namespace fathom::lines {

namespace {

// Canonical pairs with at most this many crossings are scanned without asking the vertex test
// first.
constexpr std::uint64_t tiny = 64;
// Of each large pair, the crossings of about this many rows with as many columns are looked at
// first.
constexpr std::size_t stride_lines = 32;

// Every k-th arc, for about stride_lines of them.
template <class Arc>
std::vector<Arc> strided(std::span<const Arc> arcs, std::mt19937_64& random) {
  const std::size_t step = std::max<std::size_t>(1, arcs.size() / stride_lines);
  std::vector<Arc> chosen;
  for (std::size_t i = random() % step; i < arcs.size(); i += step) chosen.push_back(arcs[i]);
  return chosen;
}

// One global best over all canonical pairs: small pairs first, then the large ones, promising ones
// first.
class PairScan {
 public:
  PairScan(kernels::Context& context, const canonical::CanonicalSubsets& subsets, const LineScene& scene,
           kernels::NearestPlanes& nearest, const ClosestLinesOptions& options)
      : context_(context),
        subsets_(subsets),
        scene_(scene),
        search_(context, scene, nearest, options.seed, options.trace),
        options_(options) {
    if (options.trace) options.trace->pairs.resize(subsets.size());
  }

  void scan_all() {
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if (i % 1024 == 0) report(i, subsets_.size());
      scan(i);
    }
  }

  void run() {
    const canonical::CanonicalSubsets::Sums sums = subsets_.sums();
    report(0, 1);
    std::uint64_t done = 0;
    const auto finished = [&](std::size_t i) {
      done += subsets_[i].a.size() + subsets_[i].b.size();
      if (i % 64 == 0) report(done, sums.a + sums.b);
    };
    std::vector<Promise> large;
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if (!start(i)) {
        finished(i);
      } else if (!clears(i)) {
        large.push_back({promise(i), i});
      }
    }
    std::ranges::sort(large, {}, [](const Promise& p) { return std::pair(p.squared, p.pair); });
    for (const Promise& p : large) {
      if (!clears(p.pair)) cut(p.pair);
      finished(p.pair);
    }
  }

 private:
  struct Promise {
    double squared;
    std::size_t pair;
  };

  void report(std::uint64_t done, std::uint64_t all) {
    const double share = static_cast<double>(done) / static_cast<double>(all);
    context_.report("closest lines", options_.first_share + share * (options_.last_share - options_.first_share));
  }

  Grid grid(std::size_t i) const { return Grid(subsets_[i], scene_); }

  bool clears(std::size_t i) {
    const bool clear = vertex_clears(grid(i), search_.nearest(), search_.bound());
    if (clear) note(i, Treatment::cleared, 0);
    return clear;
  }

  void scan(std::size_t i) {
    const canonical::CanonicalPair pair = subsets_[i];
    search_.scan(pair.a, pair.b);
    note(i, Treatment::scanned, pair.crossings());
  }

  // In the trace: how pair i was dealt with, and how many pairs of lines that took beside those
  // before.
  void note(std::size_t i, Treatment treatment, std::uint64_t evaluated) {
    if (!options_.trace) return;
    SearchTrace::OfPair& pair = options_.trace->pairs[i];
    pair.treatment = treatment;
    pair.evaluated += evaluated;
  }

  // Deals with a pair that is small; tells whether it is large.
  bool start(std::size_t i) {
    const canonical::CanonicalPair pair = subsets_[i];
    if (pair.crossings() > options_.scanned) return true;
    if (pair.crossings() <= tiny || !clears(i)) scan(i);
    return false;
  }

  // Looks at a part of the pair, and estimates how near its nearest crossing is.
  double promise(std::size_t i) {
    const canonical::CanonicalPair pair = subsets_[i];
    const std::vector<chart::ChartArcOfA> of_a = strided(pair.a, search_.random());
    const std::vector<chart::ChartArcOfB> of_b = strided(pair.b, search_.random());
    search_.scan(of_a, of_b);
    note(i, Treatment::cut, std::uint64_t{of_a.size()} * of_b.size());
    double least = std::numeric_limits<double>::infinity();
    for (const chart::ChartArcOfA e : of_a) {
      for (const chart::ChartArcOfB f : of_b) {
        least = std::min(least,
                         kernels::estimated_squared_distance(scene_.a.images(), e.value, scene_.b.images(), f.value));
      }
    }
    return least;
  }

  void cut(std::size_t i) {
    const std::uint64_t before = context_.counters.pairs_evaluated;
    if (options_.trace) options_.trace->pair = i;
    if (options_.engine == ClosestLines::cutting) {
      closest_by_cutting(grid(i), search_, options_.cutting_size);
    } else {
      closest_by_sampling(grid(i), search_, options_.sampled_size);
    }
    note(i, Treatment::cut, context_.counters.pairs_evaluated - before);
  }

  kernels::Context& context_;
  const canonical::CanonicalSubsets& subsets_;
  const LineScene& scene_;
  LineSearch search_;
  const ClosestLinesOptions& options_;
};

}  // namespace

void closest_lines(kernels::Context& context, const canonical::CanonicalSubsets& subsets, const LineScene& scene,
                   kernels::NearestPlanes& nearest, const ClosestLinesOptions& options) {
  PairScan scan(context, subsets, scene, nearest, options);
  if (options.engine == ClosestLines::naive) {
    scan.scan_all();
  } else {
    scan.run();
  }
}

kernels::Report validate_separation(const canonical::CanonicalSubsets& subsets, const LineScene& scene) {
  kernels::Report report;
  for (std::size_t k = 0; k < subsets.size(); ++k) {
    const canonical::CanonicalPair pair = subsets[k];
    for (const chart::ChartArcOfA e : pair.a) {
      for (const chart::ChartArcOfB f : pair.b) {
        const Vector w = cross(scene.a.direction(e), scene.b.direction(f));
        const mpz_class height = dot(scene.b.point(f) - scene.a.point(e), w);
        report.expect(sgn(height) * sgn(dot(w, scene.pole)) >= 0 && (is_zero(w) || height != 0),
                      "C4: edge " + std::to_string(scene.b.edge(f).value) + " of B is not above edge " +
                          std::to_string(scene.a.edge(e).value) + " of A");
      }
    }
  }
  return report;
}

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
