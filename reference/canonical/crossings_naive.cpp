// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs, and what the family of canonical pairs must say about them.
#include <algorithm>
#include <map>

#include "reference/canonical/canonical_subsets.hpp"
#include "reference/gaussian/crossing.hpp"

namespace fathom {

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossings_naive(const Charts& charts) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  const GaussianDiagram& a = charts.diagram(Colour::a);
  const GaussianDiagram& b = charts.diagram(Colour::b);
  for (std::uint32_t i = 0; i < a.arcs.size(); ++i) {
    for (std::uint32_t j = 0; j < b.arcs.size(); ++j) {
      for (const int sign : strict_crossings(a, a.arcs[i], b, b.arcs[j])) {
        const Vector w = cross(a.arcs[i].circle.exact(), b.arcs[j].circle.exact());
        if (sign * sgn(dot(w, charts.frame.z.exact())) > 0) result.emplace_back(i, j);
      }
    }
  }
  return result;
}

Report validate(const CanonicalSubsets& subsets, const Charts& charts, bool general_position) {
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
  for (const auto& crossing : crossings_naive(charts)) {
    const auto found = reported.find(crossing);
    const std::string name = "(" + std::to_string(crossing.first) + "," + std::to_string(crossing.second) + ")";
    if (!report.expect(found != reported.end(), "C3: crossing pair " + name + " is not reported")) continue;
    report.expect(!general_position || found->second == 1, "crossing pair " + name + " is reported more than once");
    reported.erase(found);
  }
  for (const auto& [pair, count] : reported) {
    const std::string name = "(" + std::to_string(pair.first) + "," + std::to_string(pair.second) + ")";
    report.expect(!general_position && touch(a, a.arcs[pair.first], b, b.arcs[pair.second]), "C2: reported pair " + name + " does not cross");
  }
  return report;
}

}  // namespace fathom
