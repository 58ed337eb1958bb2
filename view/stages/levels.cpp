// SPDX-License-Identifier: GPL-3.0-or-later
// The cutting of one canonical pair, level by level: that of the search, or a finer one for a picture if the search scanned the pair.
#include <algorithm>

#include "reference/lines/cutting.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

using Blocks = std::vector<lines::SearchTrace::Block>;

// A smaller grid is no picture.
constexpr std::uint64_t least_crossings = 4;
// More blocks are too many to see, and to print.
constexpr std::size_t most_blocks = 4000;
// About how many blocks a cutting for a picture may have at most.
constexpr std::uint64_t wanted_blocks = 256;

std::optional<Index> pair_to_cut(const Stages& stages) {
  if (stages.winner && stages.winner->pair && stages.pairs[*stages.winner->pair].crossings() >= least_crossings) return stages.winner->pair;
  const auto largest = std::ranges::max_element(stages.pairs, {}, &StagedPair::crossings);
  if (largest == stages.pairs.end() || largest->crossings() < least_crossings || !largest->closest) return std::nullopt;
  return static_cast<Index>(largest - stages.pairs.begin());
}

Blocks as_searched(const lines::SearchTrace& trace, std::size_t pair) {
  Blocks blocks;
  std::ranges::copy_if(trace.blocks, std::back_inserter(blocks), [&](const auto& block) { return block.pair == pair; });
  return blocks;
}

// Cuts the grid until about as many blocks as wanted are left at the most. It starts with the facets of step 1, as the search does.
Blocks cut_for_picture(const StagesSource& subject, const chart::Charts& charts, const canonical::CanonicalPair& pair) {
  const lines::EdgeLinesOfA a(subject.exact.hulls.a, subject.pair.exponent());
  const lines::EdgeLinesOfB b(subject.exact.hulls.b, subject.pair.exponent());
  const lines::LineScene scene(charts, a, b);
  kernels::Context context = subject.context.worker();
  kernels::NearestPlanes nearest = subject.exact.of_facets;
  lines::SearchTrace trace;
  lines::LineSearch search(context, scene, nearest, 1, &trace);
  lines::CuttingSize size;
  size.few = 1;
  size.base = std::max<std::uint64_t>(1, pair.crossings() / wanted_blocks);
  lines::closest_by_cutting(lines::Grid(pair, scene), search, size);
  return std::move(trace.blocks);
}

std::array<Index, 2> run_of(const kernels::LineRun& run) { return {static_cast<Index>(run.first), static_cast<Index>(run.last)}; }

BlockFate fate_of(lines::Treatment treatment) {
  switch (treatment) {
    case lines::Treatment::scanned: return BlockFate::scanned;
    case lines::Treatment::cleared: return BlockFate::cleared;
    case lines::Treatment::cut: return BlockFate::refined;
  }
  return BlockFate::scanned;
}

std::vector<StagedLevel> levels_of(const Blocks& blocks, const StagedPair& pair) {
  const auto place = [](const Indices& edges, Index edge) { return static_cast<Index>(std::ranges::find(edges, edge) - edges.begin()); };
  const Index row = place(pair.a, pair.closest->a), column = place(pair.b, pair.closest->b);
  const auto holds = [](const std::array<Index, 2>& run, Index i) { return run[0] <= i && i < run[1]; };
  std::vector<StagedLevel> levels;
  for (const lines::SearchTrace::Block& block : blocks) {
    if (block.level >= levels.size()) levels.resize(block.level + 1);
    StagedBlock staged{run_of(block.rows), run_of(block.columns), fate_of(block.treatment)};
    if (staged.fate != BlockFate::refined && holds(staged.rows, row) && holds(staged.columns, column)) staged.fate = BlockFate::won;
    StagedLevel& level = levels[block.level];
    if (block.level > 0) level.cut_a = block.side == lines::GridAxis::rows;
    level.blocks.push_back(staged);
  }
  for (StagedLevel& level : levels) {
    std::ranges::sort(level.blocks, {}, [](const StagedBlock& block) { return std::pair(block.rows, block.columns); });
  }
  return levels;
}

}  // namespace

void add_cutting(const StagesSource& subject, Stages& stages) {
  if (!subject.exact.depth.penetration()) return;
  const std::optional<Index> chosen = pair_to_cut(stages);
  if (!chosen) return;
  const StagedPair& pair = stages.pairs[*chosen];
  const std::size_t of_hemisphere = pair.chart == 0 ? *chosen : *chosen - subject.exact.subsets[0].size();
  StagedCutting cutting{*chosen, stages.winner && stages.winner->pair == chosen, true, {}};
  Blocks blocks = as_searched(subject.exact.traces[pair.chart], of_hemisphere);
  if (blocks.empty() || blocks.size() > most_blocks) {
    cutting.as_searched = false;
    blocks = cut_for_picture(subject, subject.exact.charts[pair.chart], subject.exact.subsets[pair.chart][of_hemisphere]);
  }
  cutting.levels = levels_of(blocks, pair);
  stages.cutting = std::move(cutting);
}

}  // namespace fathom::stages
