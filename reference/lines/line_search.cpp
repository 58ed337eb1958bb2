// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/line_search.hpp"

#include <limits>

namespace fathom::lines {
namespace {

// Of the pairs that the filter in binary64 leaves, so many may turn out to be farther before wide
// floats look at them first: most searches leave few pairs, and nearly all of these are nearer.
constexpr std::uint64_t few_farther = 64;

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

}  // namespace fathom::lines
