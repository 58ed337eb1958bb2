// SPDX-License-Identifier: GPL-3.0-or-later
// PENETRATION-DEPTH, step by step. What the paper says of the sphere of directions is done in two
// charts, one for each hemisphere.
#include "reference/depth/penetration_depth.hpp"

#include <utility>
#include <vector>

#include "kernels/context.hpp"
#include "reference/depth/contact.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"

namespace fathom::depth {
namespace {

constexpr std::size_t edges_worth_a_thread = 4096;

/// A run, in which every stage finds those before it.
struct Run {
  ExactStages& made;
  const ExactOptions& options;
  bool traced;                     ///< whether the search for closest lines is kept
  kernels::NearestPlanes nearest;  ///< of the planes that the steps have offered so far

  [[nodiscard]] bool two_threads() const {
    return made.hulls.a.edges.size() + made.hulls.b.edges.size() >= edges_worth_a_thread;
  }
};

template <class Work>
void in_both_hemispheres(kernels::Context& context, const Run& run, const Work& work) {
  kernels::run_both(
      run.two_threads(), context, [&](kernels::Context& own) { work(own, 0); },
      [&](kernels::Context& own) { work(own, 1); });
}

void make_diagrams(kernels::Context& context, Run& run) {
  ExactStages& made = run.made;
  kernels::run_both(
      run.two_threads(), context,
      [&](kernels::Context&) { made.diagrams.a = gaussian::gaussian_diagram_of_reflection(made.hulls.a); },
      [&](kernels::Context&) { made.diagrams.b = gaussian::gaussian_diagram(made.hulls.b); });
}

void insist_on_diagrams(const Run& run) {
  kernels::insist(gaussian::validate(run.made.diagrams.a, run.made.hulls.a, gaussian::Colour::a));
  kernels::insist(gaussian::validate(run.made.diagrams.b, run.made.hulls.b, gaussian::Colour::b));
}

// "Computing F": the overlay of both diagrams is never built, its crossings are found chart by
// chart.
void make_charts(kernels::Context& context, Run& run) {
  context.report("charts");
  ExactStages& made = run.made;
  in_both_hemispheres(context, run, [&](kernels::Context& own, std::size_t i) {
    const chart::Frame frame = chart::chart_frame(chart::both_hemispheres[i]);
    made.charts[i] = chart::make_charts(own, made.diagrams.a, made.diagrams.b, frame, run.options.perturbation);
  });
}

void insist_on_charts(const Run& run) {
  for (const chart::Charts& hemisphere : run.made.charts) kernels::insist(chart::validate(hemisphere));
}

void make_vertex_facet_pairs(kernels::Context& context, Run& run) {
  context.report("vertex-facet pairs");
  for (std::size_t i = 0; i < run.made.charts.size(); ++i) {
    run.made.pairs[i] = vertex_facet::vertex_facet_pairs(run.made.charts[i]);
    context.counters.vertex_facet_pairs += run.made.pairs[i].size();
  }
}

void insist_on_vertex_facet_pairs(const Run& run) {
  const auto& [a, b] = run.made.hulls;
  for (std::size_t i = 0; i < run.made.charts.size(); ++i)
    kernels::insist(vertex_facet::validate(run.made.pairs[i], run.made.charts[i], a, b));
}

void offer_vertex_facet_pairs(kernels::Context&, Run& run) {
  const auto& [a, b] = run.made.hulls;
  for (std::size_t i = 0; i < run.made.charts.size(); ++i)
    vertex_facet::offer(run.made.pairs[i], run.made.charts[i], a, b, run.nearest);
  if (run.traced) run.made.of_facets = run.nearest;
}

// (A_i, B_i): every edge of A_i crosses every edge of B_i on the sphere, and each crossing is in
// one of them (C1 to C5).
void make_canonical_subsets(kernels::Context& context, Run& run) {
  in_both_hemispheres(context, run, [&](kernels::Context& own, std::size_t i) {
    canonical::CanonicalSubsets& subsets = run.made.subsets[i] = canonical::canonical_subsets(own, run.made.charts[i]);
    const canonical::CanonicalSubsets::Sums sums = subsets.sums();
    own.counters.canonical_pairs += subsets.size();
    own.counters.sum_a += sums.a;
    own.counters.sum_b += sums.b;
    own.counters.crossings += sums.product;
  });
}

/// The lines through the edges of both bodies.
struct LinesOfEdges {
  lines::EdgeLinesOfA a;
  lines::EdgeLinesOfB b;
  explicit LinesOfEdges(const ExactStages& made)
      : a(made.hulls.a, made.pair->exponent()), b(made.hulls.b, made.pair->exponent()) {}
};

void insist_on_canonical_subsets(const Run& run) {
  const LinesOfEdges of_edges(run.made);
  for (std::size_t i = 0; i < run.made.charts.size(); ++i) {
    const canonical::CanonicalSubsets& subsets = run.made.subsets[i];
    kernels::insist(canonical::validate(subsets, run.made.charts[i]));
    const lines::LineScene scene(run.made.charts[i], of_edges.a, of_edges.b);
    kernels::insist(lines::validate_separation(subsets, scene));  // C4, Lemma 2.3
    for (std::size_t k = 0; k < subsets.size(); ++k) kernels::insist(lines::validate(lines::Grid(subsets[k], scene)));
  }
}

// The facet spanned by two crossing edges is as far from O as their lines are from each other
// (Lemma 2.2).
void offer_closest_lines(kernels::Context& context, Run& run) {
  const LinesOfEdges of_edges(run.made);
  for (std::size_t i = 0; i < run.made.charts.size(); ++i) {
    const lines::LineScene scene(run.made.charts[i], of_edges.a, of_edges.b);
    const double share = 0.5 * static_cast<double>(i);
    lines::ClosestLinesOptions options{run.options.closest_lines, run.options.seed, share, share + 0.5};
    if (run.traced) options.trace = &run.made.traces[i];
    lines::closest_lines(context, run.made.subsets[i], scene, run.nearest, options);
  }
}

void find_contacts(kernels::Context&, Run& run) {
  run.made.depth.outcome = penetration_along(*run.made.pair, run.nearest.directions(), run.options.optima);
}

// O is in the interior of P. A facet of P is the sum of a facet of one body and a vertex of the
// other, or it is spanned by an edge of each: steps 1 and 2 offer the planes of these two kinds.
constexpr Stage<Run> exact_method[] = {
    {make_diagrams, insist_on_diagrams},
    {make_charts, insist_on_charts},
    {make_vertex_facet_pairs, insist_on_vertex_facet_pairs},
    {offer_vertex_facet_pairs, nullptr},  // step 1
    {make_canonical_subsets, insist_on_canonical_subsets},
    {offer_closest_lines, nullptr},  // step 2
    {find_contacts, nullptr},        // step 3
};

// What a run over bodies that do not penetrate leaves out, except for the search.
constexpr Stage<Run> topology[] = {{make_diagrams, insist_on_diagrams},
                                   {make_charts, insist_on_charts},
                                   {make_canonical_subsets, insist_on_canonical_subsets}};

void run_exact(kernels::Context& context, Run& run) {
  ExactStages& made = run.made;
  made.depth.method = Method::exact;
  if (begin(context, made, run.options.validate)) run_stages<Run>(context, run, exact_method, run.options.validate);
  made.depth.counters = context.counters;
}

// What it counts is the context's, and not the answer's.
void add_topology(kernels::Context& context, Run& run) {
  kernels::Context own = context.worker();
  BodyFacts uncounted;
  run.made.hulls = hulls_of(own, *run.made.pair, uncounted);
  run_stages<Run>(own, run, topology, run.options.validate);
  context.join(own);
}

}  // namespace

Depth penetration_depth(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options) {
  ExactStages stages;
  stages.pair = &pair;
  Run run{stages, options, false, {}};
  run_exact(context, run);
  return std::move(stages.depth);
}

std::unique_ptr<ExactStages> exact_stages(kernels::Context& context, const polytope::PlacedPair& pair,
                                          const ExactOptions& options) {
  auto stages = std::make_unique<ExactStages>();
  stages->pair = &pair;
  Run run{*stages, options, true, {}};
  run_exact(context, run);
  if (!stages->depth.penetration()) add_topology(context, run);
  return stages;
}

}  // namespace fathom::depth
