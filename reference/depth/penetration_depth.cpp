// SPDX-License-Identifier: GPL-3.0-or-later
// PENETRATION-DEPTH, step by step. What the paper says of the sphere of directions is done in two charts, one for each hemisphere.
// exact_stages of exact_stages.hpp is the same run, whose stages are kept.
#include "reference/depth/penetration_depth.hpp"

#include <utility>
#include <vector>

#include "kernels/parallel.hpp"
#include "reference/depth/contact.hpp"
#include "reference/depth/exact_stages.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"
#include "reference/vertex_facet/vertex_facet.hpp"

namespace fathom::depth {
namespace {

constexpr std::size_t worth_a_thread = 4096;  // edges

using Diagrams = gaussian::PerColour<gaussian::GaussianDiagram>;  // those of -A and of B

/// What every step gets beside the results of the steps before it.
struct Run {
  kernels::Context& context;
  const ExactOptions& options;
  bool two_threads;

  Run(kernels::Context& used, const ExactOptions& wanted, const Hulls& hulls)
      : context(used), options(wanted), two_threads(hulls.a.edges.size() + hulls.b.edges.size() >= worth_a_thread) {}
};

template <class Work>
void in_both_hemispheres(const Run& run, const Work& work) {
  kernels::run_both(
      run.two_threads, run.context, [&](kernels::Context& own) { work(own, 0); }, [&](kernels::Context& own) { work(own, 1); });
}

Diagrams gaussian_diagrams(const Run& run, const Hulls& hulls) {
  Diagrams diagrams;
  kernels::run_both(
      run.two_threads, run.context, [&](kernels::Context&) { diagrams.a = gaussian::gaussian_diagram_of_reflection(hulls.a); },
      [&](kernels::Context&) { diagrams.b = gaussian::gaussian_diagram(hulls.b); });
  if (run.options.validate) {
    kernels::insist(gaussian::validate(diagrams.a, hulls.a, gaussian::Colour::a));
    kernels::insist(gaussian::validate(diagrams.b, hulls.b, gaussian::Colour::b));
  }
  return diagrams;
}

// "Computing F": the overlay of both diagrams is never built, its crossings are found chart by chart.
PerHemisphere<chart::Charts> make_charts(const Run& run, const Diagrams& diagrams) {
  run.context.report("charts");
  PerHemisphere<chart::Charts> charts;
  in_both_hemispheres(run, [&](kernels::Context& own, std::size_t i) {
    const chart::Frame frame = chart::chart_frame(chart::both_hemispheres[i]);
    charts[i] = chart::make_charts(own, diagrams.a, diagrams.b, frame, run.options.perturbation);
    if (run.options.validate) kernels::insist(chart::validate(charts[i]));
  });
  return charts;
}

void offer_vertex_facet_pairs(const Run& run, const Hulls& hulls, const PerHemisphere<chart::Charts>& charts,
                              kernels::NearestPlanes& nearest) {
  run.context.report("vertex-facet pairs");
  for (const chart::Charts& hemisphere : charts) {
    const std::vector<vertex_facet::VertexFacetPair> pairs = vertex_facet::vertex_facet_pairs(hemisphere);
    if (run.options.validate) kernels::insist(vertex_facet::validate(pairs, hemisphere, hulls.a, hulls.b));
    run.context.counters.vertex_facet_pairs += pairs.size();
    vertex_facet::offer(pairs, hemisphere, hulls.a, hulls.b, nearest);
  }
}

// (A_i, B_i): every edge of A_i crosses every edge of B_i on the sphere, and each crossing is in one of them (C1 to C5).
PerHemisphere<canonical::CanonicalSubsets> canonical_subsets(const Run& run, const PerHemisphere<chart::Charts>& charts) {
  PerHemisphere<canonical::CanonicalSubsets> subsets;
  in_both_hemispheres(run, [&](kernels::Context& own, std::size_t i) {
    subsets[i] = canonical::canonical_subsets(own, charts[i]);
    const canonical::CanonicalSubsets::Sums sums = subsets[i].sums();
    own.counters.canonical_pairs += subsets[i].size();
    own.counters.sum_a += sums.a;
    own.counters.sum_b += sums.b;
    own.counters.crossings += sums.product;
  });
  return subsets;
}

void insist_on_grids(const canonical::CanonicalSubsets& subsets, const chart::Charts& charts, const lines::LineScene& scene) {
  kernels::insist(canonical::validate(subsets, charts));
  kernels::insist(lines::validate_separation(subsets, scene));  // C4, Lemma 2.3
  for (std::size_t k = 0; k < subsets.size(); ++k) kernels::insist(lines::validate(lines::Grid(subsets[k], scene)));
}

/// The lines through the edges of both bodies.
struct LinesOfEdges {
  lines::EdgeLinesOfA a;
  lines::EdgeLinesOfB b;
  LinesOfEdges(const Hulls& hulls, long exponent) : a(hulls.a, exponent), b(hulls.b, exponent) {}
};

// The facet spanned by two crossing edges is as far from O as their lines are from each other (Lemma 2.2).
void offer_closest_lines(const Run& run, const LinesOfEdges& of_edges, const PerHemisphere<chart::Charts>& charts,
                         const PerHemisphere<canonical::CanonicalSubsets>& subsets, kernels::NearestPlanes& nearest,
                         PerHemisphere<lines::SearchTrace>* traces) {
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const lines::LineScene scene(charts[i], of_edges.a, of_edges.b);
    if (run.options.validate) insist_on_grids(subsets[i], charts[i], scene);
    const double share = 0.5 * static_cast<double>(i);
    lines::ClosestLinesOptions options{run.options.closest_lines, run.options.seed, share, share + 0.5};
    if (traces) options.trace = &(*traces)[i];
    lines::closest_lines(run.context, subsets[i], scene, nearest, options);
  }
}

// Fills in the stages and the answer; of bodies that do not penetrate, only the answer. If `traced`, keeps what the search does.
void run_exact(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options, bool traced, ExactStages& stages) {
  Depth& depth = stages.depth = {facts_of(pair), {}, Method::exact, {}};
  if (!answer_apart(context, pair, options.validate, depth)) {
    // O is in the interior of P. A facet of P is the sum of a facet of one body and a vertex of the other, or it is spanned by an edge of
    // each: steps 1 and 2 offer the planes of these two kinds.
    const Hulls& hulls = stages.hulls = hulls_of(context, pair, options.validate, depth);
    const Run run(context, options, hulls);
    stages.diagrams = gaussian_diagrams(run, hulls);
    stages.charts = make_charts(run, stages.diagrams);
    kernels::NearestPlanes nearest;
    offer_vertex_facet_pairs(run, hulls, stages.charts, nearest);  // step 1
    if (traced) stages.of_facets = nearest;
    stages.subsets = canonical_subsets(run, stages.charts);
    offer_closest_lines(run, {hulls, pair.exponent()}, stages.charts, stages.subsets, nearest,
                        traced ? &stages.traces : nullptr);                                                               // step 2
    depth.outcome = penetration_along(pair, {nearest.directions().begin(), nearest.directions().end()}, options.optima);  // step 3
  }
  depth.counters = context.counters;
}

// What a run over bodies that do not penetrate leaves out, but for the search; counted apart.
void add_topology(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options, ExactStages& stages) {
  kernels::Context own = context.worker();
  BodyFacts uncounted;
  stages.hulls = hulls_of(own, pair, options.validate, uncounted);
  const Run run(own, options, stages.hulls);
  stages.diagrams = gaussian_diagrams(run, stages.hulls);
  stages.charts = make_charts(run, stages.diagrams);
  stages.subsets = canonical_subsets(run, stages.charts);
}

}  // namespace

Depth penetration_depth(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options) {
  ExactStages stages;
  run_exact(context, pair, options, false, stages);
  return std::move(stages.depth);
}

std::unique_ptr<ExactStages> exact_stages(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options) {
  auto stages = std::make_unique<ExactStages>();
  run_exact(context, pair, options, true, *stages);
  if (!stages->depth.penetration()) add_topology(context, pair, options, *stages);
  return stages;
}

}  // namespace fathom::depth
