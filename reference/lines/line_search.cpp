// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/line_search.hpp"

#include <limits>

namespace fathom {

LineSearch::LineSearch(const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest, Counters& counters,
                       const std::function<bool(double)>& keep_going, std::uint64_t seed)
    : a_(&a), b_(&b), nearest_(&nearest), counters_(&counters), keep_going_(&keep_going), random_(seed) {
  counters.seed = seed;
  tighten();
}

void LineSearch::scan(std::span<const std::uint32_t> of_a, std::span<const std::uint32_t> of_b) {
  // The longer side runs in the inner loop.
  if (of_a.size() <= of_b.size()) {
    block_.gather(b_->images(), of_b);
    for (const std::uint32_t e : of_a) {
      not_farther(a_->images(), e, block_, bound_.above, unsure_);
      for (const std::uint32_t k : unsure_) offer(e, of_b[k]);
    }
  } else {
    block_.gather(a_->images(), of_a);
    for (const std::uint32_t f : of_b) {
      not_farther(b_->images(), f, block_, bound_.above, unsure_);
      for (const std::uint32_t k : unsure_) offer(of_a[k], f);
    }
  }
  const std::uint64_t pairs = static_cast<std::uint64_t>(of_a.size()) * of_b.size();
  counters_->pairs_evaluated += pairs;
  work(pairs);
}

void LineSearch::scan(const Grid& grid, const LineImages& rows, std::span<const std::uint32_t> chosen, const LineImages& columns,
                      LineRun run) {
  for (const std::uint32_t i : chosen) {
    not_farther(rows, i, columns, run.first, run.last, bound_.above, unsure_);
    for (const std::uint32_t j : unsure_) offer(grid.edge_of_row(i), grid.edge_of_column(j));
  }
  const std::uint64_t pairs = static_cast<std::uint64_t>(chosen.size()) * run.size();
  counters_->pairs_evaluated += pairs;
  work(pairs);
}

void LineSearch::offer(std::uint32_t of_a, std::uint32_t of_b) {
  if (truncated_bound_ && surely_farther(a_->truncated(), of_a, b_->truncated(), of_b, *truncated_bound_)) return;
  ++counters_->pairs_exact;
  if (!offer_edges(*a_, of_a, *b_, of_b, *nearest_)) return;
  // A tie comes as one more direction; only a nearer plane leaves a single one.
  if (nearest_->directions().size() == 1) {
    ++improvements_;
    tighten();
  }
}

bool LineSearch::proceed(double share) {
  share_ = share;
  since_asked_ = 0;
  if (!stopped_ && *keep_going_) stopped_ = !(*keep_going_)(share_);
  return !stopped_;
}

void LineSearch::work(std::uint64_t amount) {
  since_asked_ += amount;
  if (since_asked_ >= std::uint64_t{1} << 22) proceed(share_);
}

void LineSearch::tighten() {
  bound_ = nearest_->empty() ? LineBound{std::numeric_limits<double>::infinity(), 0}
                             : line_bound(nearest_->numerator(), nearest_->denominator(), a_->images().exponent());
  if (nearest_->empty() || a_->truncated().empty() || b_->truncated().empty()) return;
  truncated_bound_ = a_->truncated().bound(nearest_->numerator(), nearest_->denominator());
}

}  // namespace fathom
