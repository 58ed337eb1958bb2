// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/penetration_depth.hpp"

#include <array>

#include "kernels/parallel.hpp"
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

// The facet planes of P nearest to O, which is in the interior of P.
NearestPlanes nearest_facets(Context& context, const Hulls& hulls, long exponent, const ExactOptions& options) {
  const Polytope &a = hulls.a, &b = hulls.b;
  const bool in_two_threads = a.edges.size() + b.edges.size() >= worth_a_thread;
  // Calls work(context, 0) and work(context, 1), one for each hemisphere.
  const auto in_both = [&](const auto& work) {
    run_both(
        in_two_threads, context, [&](Context& own) { work(own, 0); }, [&](Context& own) { work(own, 1); });
  };

  GaussianDiagram of_minus_a, of_b;
  run_both(
      in_two_threads, context, [&](Context&) { of_minus_a = gaussian_diagram_of_reflection(a); },
      [&](Context&) { of_b = gaussian_diagram(b); });
  if (options.validate) {
    insist(validate(of_minus_a, a, true));
    insist(validate(of_b, b, false));
  }

  std::array<Charts, 2> hemispheres;
  context.report("charts");
  in_both([&](Context& own, std::size_t i) {
    hemispheres[i] = make_charts(own, of_minus_a, of_b, chart_frame(both_hemispheres[i]), options.perturbation);
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
  in_both([&](Context& own, std::size_t i) {
    subsets[i] = canonical_subsets(own, hemispheres[i]);
    const CanonicalSubsets::Sums sums = subsets[i].sums();
    own.counters.canonical_pairs += subsets[i].size();
    own.counters.sum_a += sums.a;
    own.counters.sum_b += sums.b;
    own.counters.crossings += sums.product;
  });

  const EdgeLinesOfA lines_a(a, exponent);
  const EdgeLinesOfB lines_b(b, exponent);
  for (std::size_t i = 0; i < 2; ++i) {
    const LineScene scene(hemispheres[i], lines_a, lines_b);
    if (options.validate) {
      insist(validate(subsets[i], hemispheres[i]));
      insist(validate_separation(subsets[i], scene));
      for (std::size_t k = 0; k < subsets[i].size(); ++k) insist(validate(Grid(subsets[i][k], scene)));
    }
    const double share = 0.5 * static_cast<double>(i);
    closest_lines(context, subsets[i], scene, nearest, {options.closest_lines, options.seed, share, share + 0.5});
  }
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
