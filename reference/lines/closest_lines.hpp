// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the canonical pairs (A_i, B_i) of one hemisphere, and its scene.
// Output  the nearest of all planes aff(e (+) (-e')): the closest pairs of lines in L_i x L'_i, all
//         ties kept.                                                             [AGHRS, Lemma 2.2]
// Engines cutting, sampled, naive: one answer. The naive one looks at every pair, through a double
// filter that leaves near ties to exact
//         arithmetic. The others scan small canonical pairs in this way, and ask of each large one
//         whether it can beat the best at all.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/line_filter.hpp"
#include "kernels/nearest.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/lines/grid.hpp"

namespace fathom::lines {

/// How finely the cutting engine cuts. Only the work depends on it.
struct CuttingSize {
  std::uint64_t r = 4;        ///< the conflict list of a cell holds at most a share 1/r of the lines
  std::uint64_t few = 16;     ///< cells with at most this many lines are not refined
  std::uint64_t base = 1024;  ///< blocks of at most this many pairs are scanned
  /// What the block tests of a grid may cost beyond an eighth of its crossings before the rest of
  /// it is scanned, in pairs scanned.
  std::uint64_t allowance = std::uint64_t{1} << 20;
};

/// The same for the sampled cutting; its cells are not refined below max(8, n / r^3) of n lines.
struct SampledSize {
  std::uint64_t r = 8;
  std::uint64_t base = 2048;
};

// What a search for closest lines did, for those who want to see it. The search writes here if it
// is given one, and never reads it: neither the answer nor the work depends on it.

/// What became of a canonical pair, or of a block of its grid.
enum class Treatment : std::uint8_t { scanned, cleared, cut };

struct SearchTrace {
  /// For each canonical pair of the hemisphere.
  struct OfPair {
    Treatment treatment = Treatment::scanned;
    std::uint64_t evaluated = 0;  ///< pairs of lines whose distance was looked at, in this pair
  };
  /// A block of a grid that was cut. Level 0 is the whole grid; the blocks of a level partition
  /// those of the level before that were cut in their turn.
  struct Block {
    std::size_t pair;
    std::uint32_t level;
    GridAxis side;  ///< whose chain was cut into the blocks of this level; rows at level 0
    kernels::LineRun rows, columns;
    Treatment treatment;
  };
  /// The arcs of the latest crossing that was nearer than all before it, or as near and in the one
  /// direction known.
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

struct ClosestLinesOptions {
  ClosestLines engine = ClosestLines::cutting;
  /// Of the random order of subproblems. Only the work depends on it.
  std::uint64_t seed = 1;
  /// The part of the stage "closest lines" that this call is, for reports.
  double first_share = 0, last_share = 1;
  /// Canonical pairs with at most this many crossings are scanned, unless they are cleared as a
  /// whole.
  std::uint64_t scanned = 2048;
  CuttingSize cutting_size = {};
  SampledSize sampled_size = {};
  /// Gets what the search does; may be null.
  SearchTrace* trace = nullptr;
};

/// Offers the nearest planes of all canonical pairs to `nearest`, which holds one global best; what
/// it already holds helps. Reports the stage "closest lines".
void closest_lines(kernels::Context& context, const canonical::CanonicalSubsets& subsets, const LineScene& scene,
                   kernels::NearestPlanes& nearest, const ClosestLinesOptions& options = {});

/// C4 as a sign: for each pair of each canonical pair, <p_e - p_e', w> > 0 for the normal w of both
/// edges with <w,z> > 0, z the pole. Skips parallel edges, and crossings on the equator, which have
/// no such w. O(sum |A_i| |B_i|).                                                [AGHRS, Lemma 2.3]
[[nodiscard]] kernels::Report validate_separation(const canonical::CanonicalSubsets& subsets, const LineScene& scene);

}  // namespace fathom::lines
