// SPDX-License-Identifier: GPL-3.0-or-later
// What a search for closest lines did, for those who want to see it. The search writes here if it is given one, and never reads it: neither
// the answer nor the work depends on it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernels/filters/line_filter.hpp"
#include "reference/chart/chart.hpp"
#include "reference/lines/grid.hpp"

namespace fathom::lines {

/// What became of a canonical pair, or of a block of its grid.
enum class Treatment : std::uint8_t { scanned, cleared, cut };

struct SearchTrace {
  /// For each canonical pair of the hemisphere.
  struct OfPair {
    Treatment treatment = Treatment::scanned;
    std::uint64_t evaluated = 0;  ///< pairs of lines whose distance was looked at, in this pair
  };
  /// A block of a grid that was cut. Level 0 is the whole grid; the blocks of a level partition those of the level before that were cut in
  /// their turn.
  struct Block {
    std::size_t pair;
    std::uint32_t level;
    GridAxis side;  ///< whose chain was cut into the blocks of this level; rows at level 0
    kernels::LineRun rows, columns;
    Treatment treatment;
  };
  /// The arcs of the latest crossing that was nearer than all before it, or as near and in the one direction known.
  struct Nearest {
    chart::ChartArcOfA a;
    chart::ChartArcOfB b;
  };

  std::vector<OfPair> pairs;
  std::vector<Block> blocks;  ///< in the order of the work
  std::optional<Nearest> nearest;

  /// Where the search is: in the grid of this pair, so many cuts deep.
  std::size_t pair = 0;
  std::uint32_t level = 0;
};

}  // namespace fathom::lines
