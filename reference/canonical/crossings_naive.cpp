// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs.
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/gaussian/crossing.hpp"

namespace fathom {

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossings_naive(const Charts& charts) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  PredicateCounts uncounted;
  const PerturbedKernel kernel(charts.perturbation, uncounted);
  const GaussianDiagram& a = charts.diagram(Colour::a);
  const GaussianDiagram& b = charts.diagram(Colour::b);
  for (std::uint32_t i = 0; i < a.arcs.size(); ++i) {
    for (std::uint32_t j = 0; j < b.arcs.size(); ++j) {
      const Direction& d = a.arcs[i].circle;
      const Direction& g = b.arcs[j].circle;
      for (const Sign sign : perturbed_crossings(kernel, a, a.arcs[i], b, b.arcs[j])) {
        if (sign * kernel.order_at_infinity(d, g, charts.frame.z) == Sign::positive) result.emplace_back(i, j);
      }
    }
  }
  return result;
}

}  // namespace fathom
