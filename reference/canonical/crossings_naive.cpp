// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs, and what the family of canonical pairs must say about them.
#include <algorithm>
#include <map>

#include "kernels/filter.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/gaussian/crossing.hpp"

namespace fathom {

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossings_naive(const Charts& charts) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  const GaussianDiagram& a = charts.diagram(Colour::a);
  const GaussianDiagram& b = charts.diagram(Colour::b);
  for (std::uint32_t i = 0; i < a.arcs.size(); ++i) {
    for (std::uint32_t j = 0; j < b.arcs.size(); ++j) {
      const Direction& d = a.arcs[i].circle;
      const Direction& g = b.arcs[j].circle;
      for (const int sign : perturbed_crossings(charts.perturbation, a, a.arcs[i], b, b.arcs[j])) {
        if (sign * perturbed_order_at_infinity(charts.perturbation, d, g, charts.frame.z) > 0) result.emplace_back(i, j);
      }
    }
  }
  return result;
}

Report validate(const CanonicalSubsets& subsets, const Charts& charts) {
  Report report;
  const GaussianDiagram& a = charts.diagram(Colour::a);
  const GaussianDiagram& b = charts.diagram(Colour::b);
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
