// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on one lattice.
// Output  their exact penetration depth, by the exact method; and all that it makes on its way, for
//         those who look into a run. [AGHRS, PENETRATION-DEPTH, section 2.2]
// Time    near-linear in the size of the bodies, except for the closest lines where very many edges
//         cross; AGHRS, Theorem 2.5.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/nearest.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "kernels/vector.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/depth/apart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/polytope/polytope.hpp"
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

// The naive twins: of the whole pipeline the convex hull of all vertex differences, P itself, facet
// by facet; of the stages after the hulls all pairs of features; of the gap all facets of P.

/// squared: depth^2 in the unit of the input, in lowest terms; 0 unless penetrating. directions:
/// primitive outward normals of the nearest facets of P, sorted lexicographically; empty unless
/// penetrating.
struct NaiveDepth {
  Status status = Status::disjoint;
  mpq_class squared;
  std::vector<Vector> directions;
  friend bool operator==(const NaiveDepth&, const NaiveDepth&) = default;
};

/// Where O lies in P = B (+) (-A) for finite sets of integer points, in the time of a hull of mn
/// points, where m and n count the extreme points. Bodies of any rank. Throws std::invalid_argument
/// when one is empty.
NaiveDepth naive_depth(std::span<const Vector> a, std::span<const Vector> b);

/// The facet planes of P nearest to O, given the hulls of A and of B, with O in the interior of P:
/// facets of A or of B against vertices, and crossing edges. The quadratic twin of the stages from
/// Gaussian diagrams to closest lines: every facet normal against every vertex, every edge against
/// every edge by an exact test of its arcs, all in exact arithmetic. O(mn).
kernels::NearestPlanes nearest_facets_naive(const polytope::Polytope& a, const polytope::Polytope& b);

/// A twin as other libraries would write it: every edge against every edge, with the double filter.
/// O(mn), a few nanoseconds a pair. `exponent` bounds the coordinates: |c| <= 2^exponent.
kernels::NearestPlanes nearest_facets_scan(const polytope::Polytope& a, const polytope::Polytope& b, long exponent);

/// The twin of second_nearest_squared. Looks at all facets of the hull of all vertex differences.
/// Throws std::invalid_argument unless the bodies penetrate.
std::optional<mpq_class> second_nearest_squared_naive(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::depth
