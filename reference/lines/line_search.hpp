// SPDX-License-Identifier: GPL-3.0-or-later
// What all engines share: the one global best, the bound that the filters compare with, the naive scan, and the work done so far.
#pragma once

#include <functional>
#include <optional>
#include <random>

#include "kernels/counters.hpp"
#include "kernels/filters/corner_bound.hpp"
#include "reference/lines/grid.hpp"

namespace fathom {

class LineSearch {
 public:
  /// `keep_going` is called now and then with the share done; false stops the search.
  LineSearch(const EdgeLines& a, const EdgeLines& b, NearestPlanes& nearest, Counters& counters,
             const std::function<bool(double)>& keep_going, std::uint64_t seed);

  /// All pairs of two sets of edges.
  void scan(std::span<const std::uint32_t> of_a, std::span<const std::uint32_t> of_b);
  /// All pairs of the rows `chosen` and the columns [run.first, run.last), given the grid's images.
  void scan(const Grid& grid, const LineImages& rows, std::span<const std::uint32_t> chosen, const LineImages& columns, LineRun run);
  /// One pair, in exact arithmetic, unless the first bits of long coordinates show already that it is farther.
  void offer(std::uint32_t of_a, std::uint32_t of_b);

  /// The squared distance of the nearest planes so far, in images and exact.
  [[nodiscard]] const LineBound& bound() const { return bound_; }
  [[nodiscard]] const NearestPlanes& nearest() const { return *nearest_; }
  [[nodiscard]] Counters& counters() const { return *counters_; }
  /// How often the best has become nearer.
  [[nodiscard]] std::uint64_t improvements() const { return improvements_; }
  [[nodiscard]] std::mt19937_64& random() { return random_; }

  /// Sets the share that is done, and asks whether to go on. A stopped search stays stopped.
  bool proceed(double share);
  /// Counts a piece of work, and asks from time to time.
  void work(std::uint64_t amount);
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  void tighten();

  const EdgeLines* a_;
  const EdgeLines* b_;
  NearestPlanes* nearest_;
  Counters* counters_;
  const std::function<bool(double)>* keep_going_;
  LineBound bound_;
  std::optional<mpz_class> truncated_bound_;  // where coordinates are long
  LineImages block_;
  std::vector<std::uint32_t> unsure_;
  std::mt19937_64 random_;
  std::uint64_t improvements_ = 0;
  double share_ = 0;
  std::uint64_t since_asked_ = 0;
  bool stopped_ = false;
};

}  // namespace fathom
