// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical pairs: each with its closest lines, found by a separate search, because the run
// discards pairs that cannot be the nearest; the pair of the first optimum; and the cutting of one
// pair.

#include <algorithm>
#include <stdexcept>

#include "kernels/number/rational.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/cutting.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

// The limit of the engines: pairs with more crossings are cut.
constexpr std::uint64_t scanned = 2048;
// Pairs with few crossings are scanned exactly, because starting a search would take longer.
constexpr std::uint64_t few = 16;

template <class Arc>
Indices edges_of(std::span<const Arc> arcs, const chart::ColourChart& chart) {
  Indices edges;
  for (const Arc arc : arcs) edges.push_back(chart.arcs[chart::ChartArcId(arc.value)].arc.value);
  return edges;
}

StagedPair staged_pair(const canonical::CanonicalPair& pair, Index chart, const chart::Charts& charts) {
  StagedPair staged;
  staged.chart = chart;
  staged.stored_of_a = pair.stored_of == gaussian::Colour::a;
  staged.rising = pair.rising;
  staged.a = edges_of(pair.a, charts.of.a);
  staged.b = edges_of(pair.b, charts.of.b);
  if (pair.strip.first > 0) staged.strip[0] = pair.strip.first - 1;
  if (pair.strip.last <= charts.walls.size()) staged.strip[1] = pair.strip.last - 1;
  return staged;
}

// The search in one hemisphere.
class ClosestOfPairs {
 public:
  ClosestOfPairs(const StagesSource& subject, const chart::Charts& charts, const lines::EdgeLinesOfA& a,
                 const lines::EdgeLinesOfB& b)
      : subject_(subject), scene_(charts, a, b) {}

  std::optional<ClosestPair> of(const canonical::CanonicalPair& pair) {
    kernels::NearestPlanes nearest;
    lines::SearchTrace trace;
    if (pair.crossings() <= few) {
      look_at_all(pair, nearest, trace);
    } else {
      kernels::Context context = subject_.context.worker();
      lines::LineSearch search(context, scene_, nearest, 1, &trace);
      if (pair.crossings() <= scanned) {
        search.scan(pair.a, pair.b);
      } else {
        lines::closest_by_cutting(lines::Grid(pair, scene_), search);
      }
    }
    if (!trace.nearest) return std::nullopt;  // all lines are parallel
    const mpz_class& unit = subject_.pair.denominator;
    const mpq_class squared = kernels::ratio(nearest.numerator(), nearest.denominator() * unit * unit);
    return ClosestPair{scene_.a.edge(trace.nearest->a).value, scene_.b.edge(trace.nearest->b).value,
                       subject_.placing.length(squared), squared};
  }

 private:
  void look_at_all(const canonical::CanonicalPair& pair, kernels::NearestPlanes& nearest, lines::SearchTrace& trace) {
    for (const chart::ChartArcOfA e : pair.a) {
      for (const chart::ChartArcOfB f : pair.b) {
        if (lines::offer_arcs(scene_, e, f, nearest) && nearest.directions().size() == 1) trace.nearest = {e, f};
      }
    }
  }

  const StagesSource& subject_;
  lines::LineScene scene_;
};

PairFate fate_of(lines::Treatment treatment) {
  switch (treatment) {
    case lines::Treatment::scanned: return PairFate::scanned;
    case lines::Treatment::cleared: return PairFate::cleared;
    case lines::Treatment::cut: return PairFate::cut;
  }
  return PairFate::none;
}

// ---- the origin of the first optimum: a facet of one body, or the crossing of two arcs ----

// Returns the face of a hull spanned by these input points; `normal` is its outward normal if it is
// a facet.
StagedFeature feature_of(const polytope::Polytope& hull, const std::vector<std::uint32_t>& points,
                         const Vector& normal) {
  const auto vertex = [&](std::uint32_t point) {
    return static_cast<Index>(std::ranges::lower_bound(hull.input_ids, point) - hull.input_ids.begin());
  };
  if (points.size() == 1) return {StagedFeatureKind::vertex, vertex(points[0])};
  if (points.size() == 2) {
    const Index p = vertex(points[0]), q = vertex(points[1]);
    const auto joins = [&](const polytope::Edge& e) {
      return (e.from.value == p && e.to.value == q) || (e.from.value == q && e.to.value == p);
    };
    const auto edge = std::ranges::find_if(hull.edges, joins);
    if (edge != hull.edges.end()) return {StagedFeatureKind::edge, static_cast<Index>(edge - hull.edges.begin())};
  }
  for (Index i = 0; i < hull.facets.size(); ++i) {
    if (hull.facets[polytope::FacetId(i)].normal == normal) return {StagedFeatureKind::facet, i};
  }
  throw std::logic_error("the features of an optimum are no faces of the hulls");
}

WinnerKind kind_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::facet_vertex:
    case ContactKind::facet_edge:
    case ContactKind::facet_facet: return WinnerKind::facet_of_a;
    case ContactKind::vertex_facet:
    case ContactKind::edge_facet: return WinnerKind::facet_of_b;
    default: return WinnerKind::edges;
  }
}

bool holds(const Indices& edges, Index edge) { return std::ranges::find(edges, edge) != edges.end(); }

using Blocks = std::vector<lines::SearchTrace::Block>;

// ---- the cutting of one pair, level by level ----

// Returns that of the search; or a finer one for a picture, if the search scanned the pair.

// The least number of crossings: a smaller grid is not worth a picture.
constexpr std::uint64_t least_crossings = 4;
// The most blocks: more could not be distinguished, nor printed.
constexpr std::size_t most_blocks = 4000;
// The number of blocks that a cutting for a picture should have at most, approximately.
constexpr std::uint64_t wanted_blocks = 256;

std::optional<Index> pair_to_cut(const Stages& stages) {
  if (stages.winner && stages.winner->pair && stages.pairs[*stages.winner->pair].crossings() >= least_crossings)
    return stages.winner->pair;
  const auto largest = std::ranges::max_element(stages.pairs, {}, &StagedPair::crossings);
  if (largest == stages.pairs.end() || largest->crossings() < least_crossings || !largest->closest) return std::nullopt;
  return static_cast<Index>(largest - stages.pairs.begin());
}

Blocks as_searched(const lines::SearchTrace& trace, std::size_t pair) {
  Blocks blocks;
  std::ranges::copy_if(trace.blocks, std::back_inserter(blocks), [&](const auto& block) { return block.pair == pair; });
  return blocks;
}

// Cuts the grid down to about the wanted number of blocks. It starts with the facets of step 1, as
// the search does.
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

std::array<Index, 2> run_of(const kernels::LineRun& run) {
  return {static_cast<Index>(run.first), static_cast<Index>(run.last)};
}

BlockFate block_fate_of(lines::Treatment treatment) {
  switch (treatment) {
    case lines::Treatment::scanned: return BlockFate::scanned;
    case lines::Treatment::cleared: return BlockFate::cleared;
    case lines::Treatment::cut: return BlockFate::refined;
  }
  return BlockFate::scanned;
}

std::vector<StagedLevel> levels_of(const Blocks& blocks, const StagedPair& pair) {
  const auto place = [](const Indices& edges, Index edge) {
    return static_cast<Index>(std::ranges::find(edges, edge) - edges.begin());
  };
  const Index row = place(pair.a, pair.closest->a), column = place(pair.b, pair.closest->b);
  const auto holds = [](const std::array<Index, 2>& run, Index i) { return run[0] <= i && i < run[1]; };
  std::vector<StagedLevel> levels;
  for (const lines::SearchTrace::Block& block : blocks) {
    if (block.level >= levels.size()) levels.resize(block.level + 1);
    StagedBlock staged{run_of(block.rows), run_of(block.columns), block_fate_of(block.treatment)};
    if (staged.fate != BlockFate::refined && holds(staged.rows, row) && holds(staged.columns, column))
      staged.fate = BlockFate::won;
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

void add_pairs(const StagesSource& subject, Stages& stages) {
  const depth::ExactStages& exact = subject.exact;
  const bool searched = exact.depth.penetration() != nullptr;
  const lines::EdgeLinesOfA a(exact.hulls.a, subject.pair.exponent());
  const lines::EdgeLinesOfB b(exact.hulls.b, subject.pair.exponent());
  for (Index h = 0; h < exact.charts.size(); ++h) {
    ClosestOfPairs closest(subject, exact.charts[h], a, b);
    for (std::size_t k = 0; k < exact.subsets[h].size(); ++k) {
      if (k % 256 == 0) subject.context.check();
      const canonical::CanonicalPair pair = exact.subsets[h][k];
      StagedPair& staged = stages.pairs.emplace_back(staged_pair(pair, h, exact.charts[h]));
      if (!searched) continue;
      staged.closest = closest.of(pair);
      staged.evaluated = exact.traces[h].pairs[k].evaluated;
      staged.fate = fate_of(exact.traces[h].pairs[k].treatment);
    }
  }
}

void add_winner(const StagesSource& subject, const Depth& depth, Stages& stages) {
  if (!depth.penetration()) return;
  const Optimum& first = depth.optima().front();
  StagedWinner winner{kind_of(first.contact.kind), std::nullopt,
                      feature_of(subject.exact.hulls.a, first.contact.a, -first.direction),
                      feature_of(subject.exact.hulls.b, first.contact.b, first.direction)};
  for (Index i = 0; winner.kind == WinnerKind::edges && i < stages.pairs.size(); ++i) {
    const StagedPair& pair = stages.pairs[i];
    if (holds(pair.a, winner.a.index) && holds(pair.b, winner.b.index)) winner.pair = i;
  }
  stages.winner = winner;
}

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
    blocks =
        cut_for_picture(subject, subject.exact.charts[pair.chart], subject.exact.subsets[pair.chart][of_hemisphere]);
  }
  cutting.levels = levels_of(blocks, pair);
  stages.cutting = std::move(cutting);
}

}  // namespace fathom::stages
