// SPDX-License-Identifier: GPL-3.0-or-later
// What a family of canonical pairs must say about all pairs of arcs, and the grid that each pair forms.
#include <algorithm>
#include <array>
#include <map>

#include "reference/canonical/canonical_subsets.hpp"

namespace fathom {
namespace {

// The chart arc of each edge that has one.
class ArcOfEdge {
 public:
  explicit ArcOfEdge(const Charts& charts) : charts_(charts) {
    for (const Colour c : {Colour::a, Colour::b}) {
      std::vector<std::uint32_t>& index = index_[static_cast<std::size_t>(c)];
      index.resize(charts.diagram(c).arcs.size(), at_infinity);
      for (std::uint32_t i = 0; i < charts.arcs_of(c).size(); ++i) index[charts.arcs_of(c)[i].arc] = i;
    }
  }

  /// Null if there is none.
  [[nodiscard]] const ChartArc* operator()(Colour c, std::uint32_t edge) const {
    const std::vector<std::uint32_t>& index = index_[static_cast<std::size_t>(c)];
    return edge < index.size() && index[edge] != at_infinity ? &charts_.arcs_of(c)[index[edge]] : nullptr;
  }

 private:
  const Charts& charts_;
  std::array<std::vector<std::uint32_t>, 2> index_;
};

Sign orientation(const ChartArc& arc) { return arc.flipped ? Sign::negative : Sign::positive; }

// Query q crosses s further left than query r does, both in one sense: at q's crossing with s, a rising r is still below s and a falling
// one above it. The crossing has the direction +-(d_q x d_s), and in either sense det(d_q, d_s, d_r) < 0, all d oriented upward.
bool crosses_first(const PerturbedKernel& kernel, const Charts& charts, Colour of_queries, const ChartArc& q, const ChartArc& r,
                   const ChartArc& s) {
  const Sign sign =
      kernel.order_at_infinity(charts.circle(of_queries, q), charts.circle(other(of_queries), s), charts.circle(of_queries, r));
  return orientation(q) * orientation(r) * orientation(s) * sign == Sign::negative;
}

void check_grid(Report& report, const PerturbedKernel& kernel, const Charts& charts, const ArcOfEdge& arc_of_edge,
                const CanonicalPair& pair) {
  const Colour of_stored = pair.stored_of, of_queries = other(of_stored);
  const auto stored = [&](std::size_t i) { return arc_of_edge(of_stored, pair.stored[i]); };
  const auto query = [&](std::size_t i) { return arc_of_edge(of_queries, pair.queries[i]); };
  bool here = true;
  for (std::size_t i = 0; i < pair.stored.size(); ++i) here = here && stored(i) != nullptr;
  for (std::size_t i = 0; i < pair.queries.size(); ++i) here = here && query(i) != nullptr;
  if (!report.expect(here, "an edge of a canonical pair has no arc in the hemisphere")) return;
  for (std::size_t i = 1; i < pair.stored.size(); ++i) {
    report.expect(above_same_colour(kernel, charts, of_stored, *stored(i), *stored(i - 1)) == Sign::positive,
                  "stored arcs are not in height order");
  }
  for (std::size_t i = 0; i < pair.stored.size(); ++i) {
    for (std::size_t k = 0; k < pair.queries.size(); ++k) {
      const bool from_below = above_far_left(kernel, charts, of_queries, *query(k), of_stored, *stored(i)) == Sign::negative;
      report.expect(from_below == pair.rising, "a query crosses in the other sense");
      report.expect(k == 0 || crosses_first(kernel, charts, of_queries, *query(k - 1), *query(k), *stored(i)),
                    "queries are not in the order in which they cross");
    }
  }
}

}  // namespace

Report validate(const CanonicalSubsets& subsets, const Charts& charts) {
  Report report;
  PredicateCounts uncounted;
  const PerturbedKernel kernel(charts.perturbation, uncounted);
  const GaussianDiagram& a = charts.diagram(Colour::a);
  const GaussianDiagram& b = charts.diagram(Colour::b);
  const ArcOfEdge arc_of_edge(charts);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> reported;
  for (std::size_t k = 0; k < subsets.size(); ++k) {
    const CanonicalPair pair = subsets[k];
    report.expect(!pair.stored.empty() && !pair.queries.empty(), "a canonical pair has an empty side");
    for (const auto& side : {pair.edges_of_a(), pair.edges_of_b()}) {
      std::vector<std::uint32_t> sorted(side.begin(), side.end());
      std::ranges::sort(sorted);
      report.expect(std::ranges::adjacent_find(sorted) == sorted.end(), "C1: an edge occurs twice in a set");
      report.expect(sorted.empty() || sorted.back() < (side.data() == pair.edges_of_a().data() ? a : b).arcs.size(),
                    "C1: an index is not an edge");
    }
    check_grid(report, kernel, charts, arc_of_edge, pair);
    for (const std::uint32_t i : pair.edges_of_a()) {
      for (const std::uint32_t j : pair.edges_of_b()) ++reported[{i, j}];
    }
  }
  const auto name = [](const std::pair<std::uint32_t, std::uint32_t>& pair) {
    return "(" + std::to_string(pair.first) + "," + std::to_string(pair.second) + ")";
  };
  for (const auto& crossing : crossings_naive(charts)) {
    report.expect(reported[crossing] > 0, "C3: crossing pair " + name(crossing) + " is not reported");
    report.expect(reported[crossing] <= 1, "crossing pair " + name(crossing) + " is reported more than once");
    reported.erase(crossing);
  }
  for (const auto& [pair, count] : reported) report.expect(false, "C2: reported pair " + name(pair) + " does not cross");
  return report;
}

}  // namespace fathom
