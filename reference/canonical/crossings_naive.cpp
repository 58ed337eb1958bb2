// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs.
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/gaussian/crossing.hpp"

namespace fathom {

std::vector<std::pair<EdgeOfA, EdgeOfB>> crossings_naive(const Charts& charts) {
  std::vector<std::pair<EdgeOfA, EdgeOfB>> result;
  PredicateCounts uncounted;
  const PerturbedKernel kernel(charts.perturbation, uncounted);
  const GaussianDiagram &a = *charts.of.a.diagram, &b = *charts.of.b.diagram;
  for (const ArcId i : a.arcs.ids()) {
    for (const ArcId j : b.arcs.ids()) {
      const Direction& d = a.arcs[i].circle;
      const Direction& g = b.arcs[j].circle;
      for (const Sign sign : perturbed_crossings(kernel, a, a.arcs[i], b, b.arcs[j])) {
        if (sign * kernel.order_at_infinity(d, g, charts.frame.z) == Sign::positive) result.emplace_back(i.value, j.value);
      }
    }
  }
  return result;
}

}  // namespace fathom
