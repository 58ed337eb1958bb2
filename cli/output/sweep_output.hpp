// SPDX-License-Identifier: GPL-3.0-or-later
// How the work of the exact method grows: for people (a table), for spreadsheets (CSV), and as a chart.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fathom/depth.hpp"

namespace fathom::cli {

/// The exact method on one pair.
struct SweepRow {
  unsigned size;  ///< as it was asked for
  Status status;
  Counters counters;
  std::vector<std::uint64_t> evaluated = {};  ///< pairs of lines, by each engine of the sweep
  std::optional<double> seconds = {};

  [[nodiscard]] std::uint64_t edges() const { return counters.edges_a + counters.edges_b; }
  [[nodiscard]] std::uint64_t sum() const { return counters.sum_a + counters.sum_b; }
  [[nodiscard]] std::uint64_t cleared() const { return counters.vertex_clears + counters.frame_clears + counters.wide_clears; }
};

struct Sweep {
  std::string family;
  std::uint64_t seed;
  bool timed;
  std::vector<ClosestLines> engines = {};  ///< that are compared; empty: the usual one alone
};

// Lines are without their newlines.

std::string sweep_text_header(const Sweep& sweep);
std::string sweep_text_row(const Sweep& sweep, const SweepRow& row);
/// "growth", and the exponent of each column.
std::string sweep_text_growth(const Sweep& sweep, const std::vector<SweepRow>& rows);
std::string sweep_csv_header(const Sweep& sweep);
std::string sweep_csv_row(const Sweep& sweep, const SweepRow& row);
/// A file of SVG.
std::string sweep_svg(const Sweep& sweep, const std::vector<SweepRow>& rows);

}  // namespace fathom::cli
