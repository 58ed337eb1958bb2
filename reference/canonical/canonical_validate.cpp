// SPDX-License-Identifier: GPL-3.0-or-later
// Checks what the canonical pairs say about all pairs of arcs, and the grid that each canonical pair forms.
#include <map>
#include <set>
#include <string>

#include "reference/canonical/canonical_subsets.hpp"
#include "reference/canonical/query_filing.hpp"
#include "reference/chart/chart.hpp"

namespace fathom::canonical {
namespace {

kernels::Sign orientation(const chart::ChartArc& arc) { return arc.flipped ? kernels::Sign::negative : kernels::Sign::positive; }

// Query q crosses s further left than query r does, both in one sense: at q's crossing with s, a rising r is still below s and a falling
// one above it. The crossing has the direction +-(d_q x d_s), and in either sense det(d_q, d_s, d_r) < 0, all d oriented upward.
bool crosses_first(const kernels::PerturbedKernel& kernel, const chart::Charts& charts, gaussian::Colour of_queries,
                   const chart::ChartArc& q, const chart::ChartArc& r, const chart::ChartArc& s) {
  const chart::ColourChart &queries = charts.of[of_queries], &stored = charts.of[gaussian::other(of_queries)];
  const kernels::Sign sign = kernel.order_at_infinity(queries.circle(q), stored.circle(s), queries.circle(r));
  return orientation(q) * orientation(r) * orientation(s) * sign == kernels::Sign::negative;
}

// The arcs of one side of a pair, or none if one of them is not an arc of the chart.
std::vector<const chart::ChartArc*> arcs_of(const chart::ColourChart& chart, const auto& ids) {
  std::vector<const chart::ChartArc*> arcs;
  for (const auto id : ids) {
    if (id.value >= chart.arcs.size()) return {};
    arcs.push_back(&chart.arcs[chart::ChartArcId(id.value)]);
  }
  return arcs;
}

void check_grid(kernels::Report& report, const kernels::PerturbedKernel& kernel, const chart::Charts& charts, const CanonicalPair& pair,
                const gaussian::PerColour<std::vector<const chart::ChartArc*>>& arcs) {
  const gaussian::Colour of_stored = pair.stored_of, of_queries = gaussian::other(of_stored);
  const std::vector<const chart::ChartArc*>&stored = arcs[of_stored], &queries = arcs[of_queries];
  for (std::size_t i = 1; i < stored.size(); ++i) {
    report.expect(chart::above_same_colour(kernel, charts, of_stored, *stored[i], *stored[i - 1]) == kernels::Sign::positive,
                  "stored arcs are not in height order");
  }
  for (const chart::ChartArc* s : stored) {
    for (std::size_t k = 0; k < queries.size(); ++k) {
      const bool from_below = chart::above_far_left(kernel, charts, of_queries, *queries[k], of_stored, *s) == kernels::Sign::negative;
      report.expect(from_below == pair.rising, "a query crosses in the other sense");
      report.expect(k == 0 || crosses_first(kernel, charts, of_queries, *queries[k - 1], *queries[k], *s),
                    "queries are not in the order in which they cross");
    }
  }
}

// In the strip the query comes from one side of the stored arc and leaves on the other, unless it ends in there.
bool crosses_inside(const kernels::PerturbedKernel& kernel, const chart::Charts& charts, const CanonicalPair& pair,
                    const chart::ChartArc& query, Strip of_query, const chart::ChartArc& stored) {
  const gaussian::Colour of_queries = gaussian::other(pair.stored_of);
  const auto above_at = [&](std::uint32_t wall) {
    const chart::Wall& w = charts.walls[chart::WallId(wall - 1)];
    return chart::above_on_wall(kernel, charts, of_queries, query, pair.stored_of, stored, w) == kernels::Sign::positive;
  };
  const bool from = pair.strip.first <= of_query.first || above_at(pair.strip.first) != pair.rising;
  const bool to = pair.strip.last >= of_query.last || above_at(pair.strip.last) == pair.rising;
  return from && to && of_query.overlaps(pair.strip);
}

void check_strip(kernels::Report& report, const kernels::PerturbedKernel& kernel, const chart::Charts& charts, const CanonicalPair& pair) {
  const gaussian::Colour of_queries = gaussian::other(pair.stored_of);
  const auto ids = [&](gaussian::Colour colour) {
    std::vector<chart::ChartArcId> result;
    const auto copy = [&](const auto& arcs) {
      for (const auto arc : arcs) result.emplace_back(arc.value);
    };
    colour == gaussian::Colour::a ? copy(pair.a) : copy(pair.b);
    return result;
  };
  const std::vector<chart::ChartArcId> queries = ids(of_queries);
  const bool inside = pair.strip.first < pair.strip.last && pair.strip.last <= charts.walls.size() + 1;
  if (!report.expect(inside, "a strip is none of the chart")) return;
  for (const chart::ChartArcId s : ids(pair.stored_of)) {
    report.expect(pair.strip.within(strips_of(charts, pair.stored_of, s)), "a stored arc does not span the strip");
    for (const chart::ChartArcId q : queries) {
      report.expect(crosses_inside(kernel, charts, pair, charts.of[of_queries].arcs[q], strips_of(charts, of_queries, q),
                                   charts.of[pair.stored_of].arcs[s]),
                    "a crossing is outside the strip");
    }
  }
}

void check_once(kernels::Report& report, const std::vector<const chart::ChartArc*>& arcs) {
  report.expect(std::set(arcs.begin(), arcs.end()).size() == arcs.size(), "C1: an edge occurs twice in a set");
}

}  // namespace

kernels::Report validate(const CanonicalSubsets& subsets, const chart::Charts& charts) {
  kernels::Report report;
  PredicateCounts uncounted;
  const kernels::PerturbedKernel kernel(charts.perturbation, uncounted);
  std::map<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>, int> reported;
  for (std::size_t k = 0; k < subsets.size(); ++k) {
    const CanonicalPair pair = subsets[k];
    report.expect(!pair.a.empty() && !pair.b.empty(), "a canonical pair has an empty side");
    const gaussian::PerColour<std::vector<const chart::ChartArc*>> arcs{arcs_of(charts.of.a, pair.a), arcs_of(charts.of.b, pair.b)};
    if (!report.expect(arcs.a.size() == pair.a.size() && arcs.b.size() == pair.b.size(), "C1: an id is not an arc of the chart")) continue;
    check_once(report, arcs.a);
    check_once(report, arcs.b);
    check_strip(report, kernel, charts, pair);
    check_grid(report, kernel, charts, pair, arcs);
    for (const chart::ChartArc* e : arcs.a) {
      for (const chart::ChartArc* f : arcs.b) ++reported[{gaussian::EdgeOfA(e->arc.value), gaussian::EdgeOfB(f->arc.value)}];
    }
  }
  const auto name = [](const std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>& pair) {
    return "(" + std::to_string(pair.first.value) + "," + std::to_string(pair.second.value) + ")";
  };
  for (const auto& crossing : crossings_naive(charts)) {
    report.expect(reported[crossing] > 0, "C3: crossing pair " + name(crossing) + " is not reported");
    report.expect(reported[crossing] <= 1, "crossing pair " + name(crossing) + " is reported more than once");
    reported.erase(crossing);
  }
  for (const auto& [pair, count] : reported) report.expect(false, "C2: reported pair " + name(pair) + " does not cross");
  return report;
}

}  // namespace fathom::canonical
