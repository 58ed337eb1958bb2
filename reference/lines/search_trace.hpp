// SPDX-License-Identifier: GPL-3.0-or-later
// What a search for closest lines did, for those who want to see it. The search writes here if it is given one, and never reads it: neither
// the answer nor the work depends on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/filters/line_scan.hpp"
#include "reference/chart/chart.hpp"
#include "reference/lines/cell_tree.hpp"

namespace fathom::lines {

/// What became of a canonical pair, or of a block of its grid.
enum class Treatment : std::uint8_t { scanned, cleared, cut };

struct SearchTrace {
  /// For each canonical pair of the hemisphere.
  struct OfPair {
    Treatment treatment = Treatment::scanned;
    std::uint64_t evaluated = 0;  ///< pairs of lines whose distance was looked at, in this pair
  };
  /// A block that the cutting engine left, and how many cuts led to it: rows and columns of the grid. `cut`: it was refined.
  struct Block {
    std::uint32_t level;
    bool of_rows;  ///< whether the last cut before it was of the rows; true at level 0
    kernels::LineRun rows, columns;
    Treatment treatment;
  };
  /// The arcs that were nearest when the search last found nearer ones.
  struct Nearest {
    chart::ChartArcOfA a;
    chart::ChartArcOfB b;
  };

  std::vector<OfPair> pairs;
  std::vector<Block> blocks;  ///< of the grids that were cut, in the order of the work
  std::optional<Nearest> nearest;
};

}  // namespace fathom::lines
