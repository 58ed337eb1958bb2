// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on one lattice.
// Output  their exact penetration depth, by the exact method; and all that it makes on its way, for
//         those who look into a run. [AGHRS, PENETRATION-DEPTH, section 2.2]
// Time    near-linear in the size of the bodies, except for the closest lines where very many edges
//         cross; AGHRS, Theorem 2.5.
#pragma once

#include <array>
#include <memory>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/nearest.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/depth/apart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/vertex_facet/vertex_facet.hpp"

namespace fathom::depth {

struct ExactOptions {
  ClosestLines closest_lines = ClosestLines::cutting;
  std::uint64_t seed = 1;                            ///< of the closest lines' random order
  std::optional<std::size_t> optima = std::nullopt;  ///< how many optima are listed; not set: all
  bool validate = false;  ///< run `validate` on every stage and throw std::logic_error on any broken law; slow
  kernels::Perturbation perturbation;  ///< how coincidences are resolved; results do not depend on it
};

/// Returns the answer, with the counters of `context`.
Depth penetration_depth(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options = {});

/// In the order of chart::both_hemispheres.
template <class T>
using PerHemisphere = std::array<T, 2>;

/// The stages of a run. That over bodies that do not penetrate ends before the hulls: then these,
/// the diagrams, charts and canonical subsets are made after it, and not counted in the answer. The
/// charts refer to the diagrams, so it stays where it is.
struct ExactStages : Beginning {
  gaussian::PerColour<gaussian::GaussianDiagram> diagrams;  ///< those of -A and of B
  PerHemisphere<chart::Charts> charts;
  PerHemisphere<std::vector<vertex_facet::VertexFacetPair>> pairs;
  kernels::NearestPlanes of_facets;  ///< the nearest planes after step 1: facets against vertices
  PerHemisphere<canonical::CanonicalSubsets> subsets;
  PerHemisphere<lines::SearchTrace> traces;  ///< of the search for closest lines; empty unless the bodies penetrate

  ExactStages() = default;
  ExactStages(const ExactStages&) = delete;
  ExactStages& operator=(const ExactStages&) = delete;
};

/// Returns what penetration_depth returns, in `depth`, and the stages before it. The pair must
/// outlive them.
std::unique_ptr<ExactStages> exact_stages(kernels::Context& context, const polytope::PlacedPair& pair,
                                          const ExactOptions& options = {});

}  // namespace fathom::depth
