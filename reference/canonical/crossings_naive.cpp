// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs.
#include "kernels/predicates/filter.hpp"
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

}  // namespace fathom
