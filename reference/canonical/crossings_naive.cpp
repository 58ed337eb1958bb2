// SPDX-License-Identifier: GPL-3.0-or-later
// All pairs of arcs.
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::canonical {

std::vector<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>> crossings_naive(const chart::Charts& charts) {
  std::vector<std::pair<gaussian::EdgeOfA, gaussian::EdgeOfB>> result;
  PredicateCounts uncounted;
  const kernels::PerturbedKernel kernel(charts.perturbation, uncounted);
  const gaussian::GaussianDiagram &a = *charts.of.a.diagram, &b = *charts.of.b.diagram;
  for (const gaussian::ArcId i : a.arcs.ids()) {
    for (const gaussian::ArcId j : b.arcs.ids()) {
      const kernels::Direction& d = a.arcs[i].circle;
      const kernels::Direction& g = b.arcs[j].circle;
      for (const kernels::Sign sign : gaussian::perturbed_crossings(kernel, a, a.arcs[i], b, b.arcs[j])) {
        if (sign * kernel.order_at_infinity(d, g, charts.frame.z) == kernels::Sign::positive) result.emplace_back(i.value, j.value);
      }
    }
  }
  return result;
}

}  // namespace fathom::canonical
