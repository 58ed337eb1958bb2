// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/cutting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom::lines {
namespace {

// Of the pairs that the filter in binary64 leaves, so many may turn out to be farther before wide
// floats look at them first: most searches leave few pairs, and nearly all of these are nearer.
constexpr std::uint64_t few_farther = 64;

using Node = CellNode;

// A frame test costs as much as some hundred pairs; and where it seldom clears, it is tried on few
// blocks only.
constexpr std::uint64_t worth_a_frame = 1024;

// What tests cost, in pairs scanned: about two nanoseconds. An offer is a pair that the filter in
// binary64 has left.
constexpr std::uint64_t vertex_cost = 16, frame_cost = 256, wide_cost = 16384, wide_line_cost = 800, offer_cost = 96;

// How far below 0 margins may be for wide floats to help: that of the smooth frames, by rounding in
// binary64, and that with the lines' own noise. Beyond, the block is too large, or it holds pairs
// that are nearer than the best.
constexpr double rounding_margin = 0x1p-43, noise_margin = 0x1p-30;

// The offset test may leave this many pairs for each line of a block.
constexpr std::size_t left_for_each = 4;

int level(Node k) { return std::bit_width(k); }

// Notes what became of a block, if the search has a trace.
void note(const Blocks& blocks, GridAxis side, Node cell, Node run, std::uint32_t level, GridAxis cut,
          Treatment treatment, LineSearch& search) {
  SearchTrace* const trace = search.trace();
  if (!trace) return;
  const auto [row, column] = rows_and_columns(side, cell, run);
  trace->blocks.push_back({trace->pair, level, cut, blocks.tree(GridAxis::rows).run(row),
                           blocks.tree(GridAxis::columns).run(column), treatment});
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
    if (search_.trace())
      note(blocks_, side_, cell, run, search_.trace()->level + 1, side_, Treatment::cleared, search_);
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
class CuttingSearch {
 public:
  CuttingSearch(const Grid& grid, LineSearch& search, const CuttingSize& size)
      : blocks_(grid, size.allowance), search_(search), size_(size) {}

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
    // The nearest cell comes first; the order of the others is random, so that improvements of the
    // best are few.
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
    search_.scan(blocks_.clearing(), blocks_.tree(GridAxis::rows).run(row),
                 blocks_.tree(GridAxis::columns).run(column));
  }

  Blocks blocks_;
  LineSearch& search_;
  const CuttingSize& size_;
};

}  // namespace

LineSearch::LineSearch(kernels::Context& context, const LineScene& scene, kernels::NearestPlanes& nearest,
                       std::uint64_t seed, SearchTrace* trace)
    : context_(context),
      scene_(scene),
      nearest_(nearest),
      wide_a_(scene.a.wide()),
      wide_b_(scene.b.wide()),
      random_(seed),
      trace_(trace) {
  counters().seed = seed;
  tighten();
}

void LineSearch::scan(std::span<const chart::ChartArcOfA> of_a, std::span<const chart::ChartArcOfB> of_b) {
  const kernels::LineImages &a = scene_.a.images(), &b = scene_.b.images();
  // The longer side runs in the inner loop.
  if (of_a.size() <= of_b.size()) {
    block_.gather(b, of_b);
    for (const chart::ChartArcOfA e : of_a) {
      kernels::not_farther(a, e.value, block_, bound_.above, unsure_);
      for (const std::uint32_t k : unsure_) offer(e, of_b[k]);
    }
  } else {
    block_.gather(a, of_a);
    for (const chart::ChartArcOfB f : of_b) {
      kernels::not_farther(b, f.value, block_, bound_.above, unsure_);
      for (const std::uint32_t k : unsure_) offer(of_a[k], f);
    }
  }
  const std::uint64_t pairs = std::uint64_t{of_a.size()} * of_b.size();
  counters().pairs_evaluated += pairs;
  work(pairs);
}

void LineSearch::scan(const Clearing& clearing, kernels::LineRun rows, kernels::LineRun columns) {
  const Grid& grid = clearing.grid();
  for (std::size_t i = rows.first; i < rows.last; ++i) {
    kernels::not_farther(clearing.rows(), i, clearing.columns(), columns, bound_.above, unsure_);
    for (const std::uint32_t j : unsure_) offer(grid.row(i), grid.column(j));
  }
  const std::uint64_t pairs = std::uint64_t{rows.size()} * columns.size();
  counters().pairs_evaluated += pairs;
  work(pairs);
}

void LineSearch::offer(chart::ChartArcOfA e, chart::ChartArcOfB f) {
  ++offers_;
  if (farther_ >= few_farther && kernels::surely_farther(wide_a_[e.value], wide_b_[f.value], wide_bound())) return;
  ++counters().pairs_exact;
  if (!offer_arcs(scene_, e, f, nearest_)) {
    ++farther_;
    return;
  }
  // A tie comes as one more direction; only a nearer plane leaves a single one.
  if (nearest_.directions().size() == 1) {
    ++improvements_;
    if (trace_) trace_->nearest = {e, f};
    tighten();
  }
}

void LineSearch::work(std::uint64_t amount) {
  since_check_ += amount;
  if (since_check_ < std::uint64_t{1} << 22) return;
  since_check_ = 0;
  context_.check();
}

void LineSearch::tighten() {
  bound_ = nearest_.empty()
               ? kernels::LineBound{std::numeric_limits<double>::infinity(), 0}
               : kernels::line_bound(nearest_.numerator(), nearest_.denominator(), scene_.a.images().exponent());
  wide_bound_.reset();
}

const kernels::WideFloat& LineSearch::wide_bound() {
  if (!wide_bound_)
    wide_bound_ = kernels::wide_bound(nearest_.numerator(), nearest_.denominator(), scene_.a.images().exponent());
  return *wide_bound_;
}

Blocks::Wide::Wide(const Grid& grid, const std::array<CellTree, 2>& trees)
    : rows(grid.wide_rows()), columns(grid.wide_columns()), frames{{trees[0], rows}, {trees[1], columns}} {}

Blocks::Blocks(const Grid& grid, std::uint64_t allowance)
    : clearing_(grid),
      trees_{CellTree(grid.rows()), CellTree(grid.columns())},
      frames_{{trees_[0], clearing_.rows()}, {trees_[1], clearing_.columns()}} {
  const std::uint64_t crossings = std::uint64_t{grid.rows()} * grid.columns();
  test_account_.free = crossings / 8 + allowance;
}

std::uint64_t Blocks::credit(const LineSearch& search) const {
  return offers_before_ ? (search.offers() - *offers_before_) * offer_cost / 8 : 0;
}

bool Blocks::exhausted(const LineSearch& search) const { return !test_account_.worth_trying(credit(search)); }

bool Blocks::clears(GridAxis side, Node cell, Node opposite, LineSearch& search) {
  if (exhausted(search)) return false;
  if (!offers_before_) offers_before_ = search.offers();
  Counters& counters = search.counters();
  ++counters.block_tests;
  spend(test_account_, vertex_cost, search);
  if (clearing_.vertex_clears(block(side, cell, opposite), search.nearest(), search.bound())) {
    ++counters.vertex_clears;
    return true;
  }
  const std::uint64_t pairs = tree(side).size(cell) * tree(other(side)).size(opposite);
  if (pairs < worth_a_frame || !frames_promise(search)) return false;
  const auto [row, column] = rows_and_columns(side, cell, opposite);
  if (!frames_clear(row, column, search)) return false;
  test_account_.saved += pairs;
  return true;
}

// Where one in 16 clears its block, or finds it nearly tied, they are tried on all blocks, or where
// pairs cost so much that they may as well be; else on one in 16.
bool Blocks::frames_promise(const LineSearch& search) const {
  return 16 * frames_held_ >= frames_tried_ || search.counters().block_tests % 16 == 0 ||
         frame_cost * frames_tried_ <= credit(search);
}

// In binary64; then, if precision or the lines' own noise may be what is wrong, in wide floats.
bool Blocks::frames_clear(Node row, Node column, LineSearch& search) {
  Counters& counters = search.counters();
  ++counters.frame_tests;
  ++frames_tried_;
  spend(test_account_, frame_cost, search);
  const double bound = search.bound().above;
  if (!std::isfinite(bound)) return false;
  const auto sketched = kernels::frames_margin(frames_.rows.sketch(row), frames_.columns.sketch(column), bound);
  if (!sketched || *sketched < -noise_margin) return false;
  if (*sketched > 0 && kernels::frames_beyond(frames_.rows.whole(row), frames_.columns.whole(column), bound)) {
    ++counters.frame_clears;
    ++frames_held_;
    return true;
  }
  const std::uint64_t offers = offers_expected(row, column, bound);
  if (offers == 0 || !nearly_tied(row, column, bound)) return false;
  ++frames_held_;
  const std::size_t lines = tree(GridAxis::rows).size(row) + tree(GridAxis::columns).size(column);
  if (offers * offer_cost < wide_cost + wide_line_cost * lines) return false;
  wide_account_.free = std::max(wide_account_.free, 16 * wide_cost + offers * offer_cost / 8);
  if (!wide_account_.worth_trying(credit(search)) || !wide_clears(row, column, search)) return false;
  wide_account_.saved += offers * offer_cost;
  return true;
}

// By the pairs of few lines; 0 if these are too few to tell.
std::uint64_t Blocks::offers_expected(Node row, Node column, double bound) const {
  std::uint64_t left = 0;
  const auto rows = frames_.rows.few_lines(row), columns = frames_.columns.few_lines(column);
  for (const std::uint32_t i : rows) {
    for (const std::uint32_t j : columns)
      left += !kernels::surely_farther(clearing_.rows(), i, clearing_.columns(), j, bound);
  }
  return left < 4 ? 0
                  : left * tree(GridAxis::rows).size(row) * tree(GridAxis::columns).size(column) /
                        (rows.size() * columns.size());
}

bool Blocks::nearly_tied(Node row, Node column, double bound) {
  const auto smooth =
      kernels::frames_margin(frames_.rows.sketch(row).smooth(), frames_.columns.sketch(column).smooth(), bound);
  return smooth && *smooth > -rounding_margin;
}

// Sketches tell whether a test of the whole may hold.
bool Blocks::wide_clears(Node row, Node column, LineSearch& search) {
  ++search.counters().wide_tests;
  spend(wide_account_, wide_cost, search);
  if (!wide_) wide_ = std::make_unique<Wide>(clearing_.grid(), trees_);
  const auto margin =
      kernels::frames_margin(wide_->frames.rows.sketch(row), wide_->frames.columns.sketch(column), search.wide_bound());
  if (margin && *margin > 0 && whole_clears(row, column, search)) return true;
  return offsets_may_clear(row, column, search.wide_bound()) && offsets_clear(row, column, search);
}

template <class Test>
bool Blocks::counting_lines(LineSearch& search, Test test) {
  const auto framed = [this] { return wide_->frames.rows.lines_framed() + wide_->frames.columns.lines_framed(); };
  const std::uint64_t before = framed();
  const bool clear = test();
  spend(wide_account_, wide_line_cost * (framed() - before), search);
  return clear;
}

bool Blocks::whole_clears(Node row, Node column, LineSearch& search) {
  const bool clear = counting_lines(search, [&] {
    const auto margin =
        kernels::frames_margin(wide_->frames.rows.whole(row), wide_->frames.columns.whole(column), search.wide_bound());
    return margin && *margin > 0;
  });
  search.counters().wide_clears += clear;
  return clear;
}

// If many pairs of a sketch are left, too many of all would be.
bool Blocks::offsets_may_clear(Node row, Node column, const kernels::WideFloat& bound) {
  CellFrames<kernels::WideLines>&rows = wide_->frames.rows, &columns = wide_->frames.columns;
  const auto smooth = kernels::margin_model(rows.sketch(row).smooth(), columns.sketch(column).smooth(), bound);
  if (!smooth) return false;
  const auto few_rows = rows.few_lines(row), few_columns = columns.few_lines(column);
  const std::size_t m = tree(GridAxis::rows).size(row), n = tree(GridAxis::columns).size(column);
  const std::size_t most = 1 + few_rows.size() * few_columns.size() * left_for_each * (m + n) / (m * n);
  return kernels::pairs_left({wide_->rows, few_rows, rows.sketch(row)},
                             {wide_->columns, few_columns, columns.sketch(column)}, bound, *smooth, most)
      .has_value();
}

bool Blocks::offsets_clear(Node row, Node column, LineSearch& search) {
  return counting_lines(search, [&] {
    CellFrames<kernels::WideLines>&frames_of_rows = wide_->frames.rows, &frames_of_columns = wide_->frames.columns;
    const kernels::FramedRun rows{wide_->rows, tree(GridAxis::rows).lines(row), frames_of_rows.whole(row)};
    const kernels::FramedRun columns{wide_->columns, tree(GridAxis::columns).lines(column),
                                     frames_of_columns.whole(column)};
    const auto smooth = kernels::margin_model(rows.frame.smooth(), columns.frame.smooth(), search.wide_bound());
    if (!smooth) return false;
    const std::size_t lines = rows.run.size() + columns.run.size();
    spend(wide_account_, wide_line_cost * lines, search);
    const auto left = kernels::pairs_left(rows, columns, search.wide_bound(), *smooth, left_for_each * lines);
    if (!left) return false;
    Counters& counters = search.counters();
    ++counters.offset_blocks;
    counters.offset_pairs += left->size();
    counters.pairs_evaluated += left->size();
    for (const auto& [i, j] : *left) search.offer(clearing_.grid().row(i), clearing_.grid().column(j));
    return true;
  });
}

void Blocks::spend(Account& account, std::uint64_t pairs, LineSearch& search) {
  account.spent += pairs;
  search.work(pairs);
}

double Blocks::estimate(GridAxis side, Node cell, Node opposite) const {
  return clearing_.estimate(block(side, cell, opposite));
}

kernels::Block Blocks::block(GridAxis side, Node cell, Node opposite) const {
  const auto [row, column] = rows_and_columns(side, cell, opposite);
  return {kernels::side_of(tree(GridAxis::rows).run(row)), kernels::side_of(tree(GridAxis::columns).run(column))};
}

std::vector<Cell> cut(Blocks& blocks, GridAxis side, Node cell, const std::vector<Node>& list, const CuttingSize& size,
                      LineSearch& search) {
  return Cutter(blocks, side, size, search).cut(cell, list);
}

void closest_by_cutting(const Grid& grid, LineSearch& search, const CuttingSize& size) {
  ++search.counters().grids_cut;
  CuttingSearch(grid, search, size).run();
}

}  // namespace fathom::lines
