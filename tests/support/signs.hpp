// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels' signs as -1, 0 and 1.
#pragma once

#include "kernels/predicates/perturbed_kernel.hpp"

namespace fathom::testing {

template <class Kernel>
struct SignsOf {
  Kernel kernel;

  template <class... Directions>
  int side_of_equator(const Directions&... d) const {
    return kernels::to_int(kernel.side_of_equator(d...));
  }
  template <class... Directions>
  int x_order(const Directions&... d) const {
    return kernels::to_int(kernel.x_order(d...));
  }
  template <class... Directions>
  int side_of_arc(const Directions&... d) const {
    return kernels::to_int(kernel.side_of_arc(d...));
  }
  template <class... Directions>
  int order_on_vertical(const Directions&... d) const {
    return kernels::to_int(kernel.order_on_vertical(d...));
  }
  template <class... Directions>
  int order_at_infinity(const Directions&... d) const {
    return kernels::to_int(kernel.order_at_infinity(d...));
  }
};

/// Where nobody reads the counts.
inline PredicateCounts uncounted;

inline SignsOf<kernels::UnperturbedKernel> unperturbed(PredicateCounts& counts = uncounted) {
  return {kernels::UnperturbedKernel(counts)};
}
inline SignsOf<kernels::PerturbedKernel> perturbed(const kernels::Perturbation& perturbation,
                                                   PredicateCounts& counts = uncounted) {
  return {kernels::PerturbedKernel(perturbation, counts)};
}

}  // namespace fathom::testing
