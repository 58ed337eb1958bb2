// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical pairs, each with its closest lines: a search of its own for each, since that of the run drops what cannot be the nearest.
#include "kernels/number/rational.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/cutting.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

// As in the engines: pairs with more crossings are cut.
constexpr std::uint64_t scanned = 2048;
// Of few crossings each is looked at exactly: a search would take longer to begin.
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

// One hemisphere.
class ClosestOfPairs {
 public:
  ClosestOfPairs(const StagesSource& subject, const chart::Charts& charts, const lines::EdgeLinesOfA& a, const lines::EdgeLinesOfB& b)
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
    if (!trace.nearest) return std::nullopt;  // all are parallel
    const mpz_class& unit = subject_.pair.denominator;
    const mpq_class squared = kernels::ratio(nearest.numerator(), nearest.denominator() * unit * unit);
    return ClosestPair{scene_.a.edge(trace.nearest->a).value, scene_.b.edge(trace.nearest->b).value, subject_.placing.length(squared),
                       squared};
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

}  // namespace fathom::stages
