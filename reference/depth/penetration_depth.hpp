// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on one lattice.
// Output  their exact penetration depth, by the exact method.                                [AGHRS, PENETRATION-DEPTH, section 2.2]
// Time    near-linear in the size of the bodies, except for the closest lines where very many edges cross; AGHRS, Theorem 2.5.
#pragma once

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "reference/polytope/placed_pair.hpp"

namespace fathom::depth {

struct ExactOptions {
  ClosestLines closest_lines = ClosestLines::cutting;
  std::uint64_t seed = 1;                            ///< of the closest lines' random order
  std::optional<std::size_t> optima = std::nullopt;  ///< how many optima are listed; not set: all
  bool validate = false;                             ///< run `validate` on every stage and throw std::logic_error on any broken law; slow
  kernels::Perturbation perturbation;                ///< how coincidences are resolved; results do not depend on it
};

/// Returns the answer, with the counters of `context`.
Depth penetration_depth(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options = {});

}  // namespace fathom::depth
