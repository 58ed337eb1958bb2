// SPDX-License-Identifier: GPL-3.0-or-later
// PENETRATION-DEPTH, step by step. What the paper says of the sphere of directions is done in two charts, one for each hemisphere.
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

namespace fathom::depth {
namespace {

constexpr std::size_t worth_a_thread = 4096;  // edges

template <class T>
using PerHemisphere = std::array<T, 2>;

/// Finds the facet planes of P nearest to O, which is in the interior of P. A facet of P is the sum of a facet of one body and a vertex of
/// the other, or it is spanned by an edge of each: steps 1 and 2 offer the planes of these two kinds.
class NearestFacets {
 public:
  NearestFacets(kernels::Context& context, const polytope::PlacedPair& pair, const Hulls& hulls, const ExactOptions& options)
      : context_(context), pair_(pair), a_(hulls.a), b_(hulls.b), options_(options) {}

  kernels::NearestPlanes find() {
    make_diagrams();
    make_charts_of_both();
    kernels::NearestPlanes nearest;
    offer_vertex_facet_pairs(nearest);  // step 1
    make_canonical_subsets();
    offer_closest_lines(nearest);  // step 2
    return nearest;
  }

 private:
  void make_diagrams() {
    kernels::run_both(
        in_two_threads(), context_, [&](kernels::Context&) { of_minus_a_ = gaussian::gaussian_diagram_of_reflection(a_); },
        [&](kernels::Context&) { of_b_ = gaussian::gaussian_diagram(b_); });
    if (!options_.validate) return;
    kernels::insist(gaussian::validate(of_minus_a_, a_, gaussian::Colour::a));
    kernels::insist(gaussian::validate(of_b_, b_, gaussian::Colour::b));
  }

  // "Computing F": the overlay of both diagrams is never built, its crossings are found chart by chart.
  void make_charts_of_both() {
    context_.report("charts");
    in_both_hemispheres([&](kernels::Context& own, std::size_t i) {
      charts_[i] = chart::make_charts(own, of_minus_a_, of_b_, chart::chart_frame(chart::both_hemispheres[i]), options_.perturbation);
      if (options_.validate) kernels::insist(chart::validate(charts_[i]));
    });
  }

  void offer_vertex_facet_pairs(kernels::NearestPlanes& nearest) {
    context_.report("vertex-facet pairs");
    for (const chart::Charts& charts : charts_) {
      const std::vector<vertex_facet::VertexFacetPair> pairs = vertex_facet::vertex_facet_pairs(charts);
      if (options_.validate) kernels::insist(vertex_facet::validate(pairs, charts, a_, b_));
      context_.counters.vertex_facet_pairs += pairs.size();
      vertex_facet::offer(pairs, charts, a_, b_, nearest);
    }
  }

  // (A_i, B_i): every edge of A_i crosses every edge of B_i on the sphere, and each crossing is in one of them (C1 to C5).
  void make_canonical_subsets() {
    in_both_hemispheres([&](kernels::Context& own, std::size_t i) {
      subsets_[i] = canonical::canonical_subsets(own, charts_[i]);
      const canonical::CanonicalSubsets::Sums sums = subsets_[i].sums();
      own.counters.canonical_pairs += subsets_[i].size();
      own.counters.sum_a += sums.a;
      own.counters.sum_b += sums.b;
      own.counters.crossings += sums.product;
    });
  }

  // The facet spanned by two crossing edges is as far from O as their lines are from each other (Lemma 2.2).
  void offer_closest_lines(kernels::NearestPlanes& nearest) {
    const lines::EdgeLinesOfA lines_a(a_, pair_.exponent());
    const lines::EdgeLinesOfB lines_b(b_, pair_.exponent());
    for (std::size_t i = 0; i < 2; ++i) {
      const lines::LineScene scene(charts_[i], lines_a, lines_b);
      if (options_.validate) insist_on_grids(subsets_[i], charts_[i], scene);
      const double share = 0.5 * static_cast<double>(i);
      lines::closest_lines(context_, subsets_[i], scene, nearest, {options_.closest_lines, options_.seed, share, share + 0.5});
    }
  }

  static void insist_on_grids(const canonical::CanonicalSubsets& subsets, const chart::Charts& charts, const lines::LineScene& scene) {
    kernels::insist(canonical::validate(subsets, charts));
    kernels::insist(lines::validate_separation(subsets, scene));  // C4, Lemma 2.3
    for (std::size_t k = 0; k < subsets.size(); ++k) kernels::insist(lines::validate(lines::Grid(subsets[k], scene)));
  }

  [[nodiscard]] bool in_two_threads() const { return a_.edges.size() + b_.edges.size() >= worth_a_thread; }

  template <class Work>
  void in_both_hemispheres(const Work& work) {
    kernels::run_both(
        in_two_threads(), context_, [&](kernels::Context& own) { work(own, 0); }, [&](kernels::Context& own) { work(own, 1); });
  }

  kernels::Context& context_;
  const polytope::PlacedPair& pair_;
  const polytope::Polytope &a_, &b_;
  const ExactOptions& options_;
  gaussian::GaussianDiagram of_minus_a_, of_b_;
  PerHemisphere<chart::Charts> charts_;
  PerHemisphere<canonical::CanonicalSubsets> subsets_;
};

}  // namespace

Depth penetration_depth(kernels::Context& context, const polytope::PlacedPair& pair, const ExactOptions& options) {
  Depth depth{facts_of(pair), {}, Method::exact, {}};
  if (!answer_apart(context, pair, options.validate, depth)) {
    const Hulls hulls = hulls_of(context, pair, options.validate, depth);
    const kernels::NearestPlanes nearest = NearestFacets(context, pair, hulls, options).find();
    depth.outcome = penetration_along(pair, {nearest.directions().begin(), nearest.directions().end()});  // step 3
  }
  depth.counters = context.counters;
  return depth;
}

}  // namespace fathom::depth
