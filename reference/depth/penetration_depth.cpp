// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/penetration_depth.hpp"

#include <array>
#include <functional>

#include "kernels/parallel.hpp"
#include "kernels/predicates/filter.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"
#include "reference/vertex_facet/vertex_facet.hpp"

namespace fathom {
namespace {

constexpr std::size_t worth_a_thread = 4096;  // edges

// Calls work(0, context) and work(1, context), one for each hemisphere, in two threads if there are many edges.
template <class Work>
void in_both(Context& context, bool in_two_threads, const Work& work) {
  Context worker = context.worker();
  run_both(
      in_two_threads, [&] { work(0, context); }, [&] { work(1, worker); });
  context.join(worker);
}

// The facet planes of P nearest to O, which is in the interior of P.
NearestPlanes nearest_facets(Context& context, const Hulls& hulls, long exponent, const ExactOptions& options) {
  const Polytope &a = hulls.a, &b = hulls.b;
  const bool in_two_threads = a.edges.size() + b.edges.size() >= worth_a_thread;
  const PredicateCounts before = predicate_counts();

  GaussianDiagram of_minus_a, of_b;
  run_both(
      in_two_threads, [&] { of_minus_a = gaussian_diagram_of_reflection(a); }, [&] { of_b = gaussian_diagram(b); });
  if (options.validate) {
    insist(validate(of_minus_a, a, true));
    insist(validate(of_b, b, false));
  }

  std::array<Charts, 2> hemispheres;
  context.report("charts");
  in_both(context, in_two_threads, [&](std::size_t i, Context&) {
    hemispheres[i] = make_charts(of_minus_a, of_b, chart_frame(i == 1), options.perturbation);
    if (options.validate) insist(validate(hemispheres[i]));
  });

  NearestPlanes nearest;
  context.report("vertex-facet pairs");
  for (const Charts& charts : hemispheres) {
    const std::vector<VertexFacetPair> pairs = vertex_facet_pairs(charts);
    if (options.validate) insist(validate(pairs, charts, a, b));
    context.counters.vertex_facet_pairs += pairs.size();
    offer(pairs, charts, a, b, nearest);
  }

  std::array<CanonicalSubsets, 2> subsets;
  in_both(context, in_two_threads, [&](std::size_t i, Context& own) {
    subsets[i] = canonical_subsets(hemispheres[i], [&](double share) { return own.report("canonical subsets", share), true; });
    const CanonicalSubsets::Sums sums = subsets[i].sums();
    own.counters.canonical_pairs += subsets[i].size();
    own.counters.sum_a += sums.a;
    own.counters.sum_b += sums.b;
    own.counters.crossings += sums.product;
  });

  const EdgeLines lines_a(a, exponent), lines_b(b, exponent);
  for (std::size_t i = 0; i < 2; ++i) {
    const Charts& charts = hemispheres[i];
    if (options.validate) {
      insist(validate(subsets[i], charts));
      insist(validate_separation(subsets[i], lines_a, lines_b, charts.frame.z.exact()));
      for (std::size_t k = 0; k < subsets[i].size(); ++k) insist(validate(Grid(subsets[i][k], charts, lines_a, lines_b), charts));
    }
    const auto report = [&](double share) { return context.report("closest lines", (static_cast<double>(i) + share) / 2), true; };
    closest_lines(subsets[i], charts, lines_a, lines_b, nearest, context.counters, {options.closest_lines, options.seed, report});
  }
  context.counters.predicates += predicate_counts() - before;
  return nearest;
}

}  // namespace

Depth penetration_depth(Context& context, const PlacedPair& pair, const ExactOptions& options) {
  Depth depth{facts_of(pair), {}, Method::exact, {}};
  if (!answer_apart(context, pair, options.validate, depth)) {
    const Hulls hulls = hulls_of(context, pair, options.validate, depth);
    const NearestPlanes nearest = nearest_facets(context, hulls, pair.exponent(), options);
    depth.outcome = penetration_along(pair, {nearest.directions().begin(), nearest.directions().end()});
  }
  depth.counters = context.counters;
  return depth;
}

}  // namespace fathom
