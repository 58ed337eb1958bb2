// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on one lattice.
// Output  everything that the exact method makes on its way to the depth, kept: for pictures, and for those who look into a run.
//                                                                                             [AGHRS, PENETRATION-DEPTH, section 2.2]
#pragma once

#include <array>
#include <memory>

#include "kernels/nearest.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/search_trace.hpp"

namespace fathom::depth {

/// In the order of chart::both_hemispheres.
template <class T>
using PerHemisphere = std::array<T, 2>;

/// The stages of a run. That over bodies that do not penetrate ends before the hulls: then these, the diagrams, charts and canonical
/// subsets are made after it, and not counted in the answer. The charts refer to the diagrams, so it stays where it is.
struct ExactStages {
  Depth depth;
  Hulls hulls;
  gaussian::PerColour<gaussian::GaussianDiagram> diagrams;  ///< those of -A and of B
  PerHemisphere<chart::Charts> charts;
  kernels::NearestPlanes of_facets;  ///< the nearest planes after step 1: facets against vertices
  PerHemisphere<canonical::CanonicalSubsets> subsets;
  PerHemisphere<lines::SearchTrace> traces;  ///< of the search for closest lines; empty unless the bodies penetrate

  ExactStages() = default;
  ExactStages(const ExactStages&) = delete;
  ExactStages& operator=(const ExactStages&) = delete;
};

/// Returns what penetration_depth returns, in `depth`, and the stages before it.
std::unique_ptr<ExactStages> exact_stages(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options = {});

}  // namespace fathom::depth
