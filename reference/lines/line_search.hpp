// SPDX-License-Identifier: GPL-3.0-or-later
// What all engines share: the one global best, the bound that the filters compare with, the naive
// scan, and the counts of work.
#pragma once

#include <optional>
#include <random>

#include "kernels/context.hpp"
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

}  // namespace fathom::lines
