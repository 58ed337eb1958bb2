// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs.
#include "kernels/predicates/filter.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/gaussian/crossing.hpp"

namespace fathom {

std::vector<std::pair<EdgeOfA, EdgeOfB>> crossings_naive(const Charts& charts) {
  std::vector<std::pair<EdgeOfA, EdgeOfB>> result;
  const GaussianDiagram &a = *charts.of.a.diagram, &b = *charts.of.b.diagram;
  for (const ArcId i : a.arcs.ids()) {
    for (const ArcId j : b.arcs.ids()) {
      const Direction& d = a.arcs[i].circle;
      const Direction& g = b.arcs[j].circle;
      for (const int sign : perturbed_crossings(charts.perturbation, a, a.arcs[i], b, b.arcs[j])) {
        if (sign * perturbed_order_at_infinity(charts.perturbation, d, g, charts.frame.z) > 0) result.emplace_back(i.value, j.value);
      }
    }
  }
  return result;
}

}  // namespace fathom
