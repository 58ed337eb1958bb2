// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/nearest_facets.hpp"

#include <array>

#include "kernels/context.hpp"
#include "kernels/parallel.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"
#include "reference/vertex_facet/vertex_facet.hpp"

namespace fathom {
namespace {

constexpr std::size_t worth_a_thread = 4096;  // edges

// Hands reports on to Options::progress.
class Progress : public Monitor {
 public:
  explicit Progress(const Options& options) : options_(options) {}
  void report(std::string_view stage, double share) override {
    if (options_.progress && !options_.progress(std::string(stage), share)) stopped_ = true;
  }
  [[nodiscard]] bool stopped() override { return stopped_; }

 private:
  const Options& options_;
  bool stopped_ = false;
};

// One run of the pipeline: what is common to both hemispheres.
class Pipeline {
 public:
  Pipeline(const Polytope& a, const Polytope& b, long exponent, const Options& options, Counters& counters)
      : a_(a),
        b_(b),
        options_(options),
        progress_(options),
        context_(&progress_),
        counters_(counters),
        in_two_threads_(a.edges.size() + b.edges.size() >= worth_a_thread),
        lines_a_(a, exponent),
        lines_b_(b, exponent) {
    run_both(
        in_two_threads_, [&] { of_minus_a_ = gaussian_diagram_of_reflection(a); }, [&] { of_b_ = gaussian_diagram(b); });
    if (options.validate) {
      insist(validate(of_minus_a_, a, true));
      insist(validate(of_b_, b, false));
    }
  }

  NearestPlanes run() {
    std::array<Charts, 2> hemispheres;
    in_both("charts", [&](std::size_t i, Context&) { hemispheres[i] = charts(both_hemispheres[i]); });
    for (const Charts& charts : hemispheres) offer_vertex_facets(charts);
    std::array<CanonicalSubsets, 2> subsets;
    in_both("canonical subsets", [&](std::size_t i, Context& context) { subsets[i] = canonical_subsets(context, hemispheres[i]); });
    for (std::size_t i = 0; i < 2; ++i) offer_crossing_edges(subsets[i], hemispheres[i], 0.5 * static_cast<double>(i));
    counters_ += context_.counters;
    counters_.seed = context_.counters.seed;
    return std::move(nearest_);
  }

 private:
  // Calls work(0, context) and work(1, context), one for each hemisphere. Only the calling thread reports.
  template <class Work>
  void in_both(const char* stage, const Work& work) {
    context_.report(stage);
    Context worker = context_.worker();
    run_both(
        in_two_threads_, [&] { work(0, context_); }, [&] { work(1, worker); });
    context_.join(worker);
  }

  Charts charts(Hemisphere hemisphere) const {
    Charts charts = make_charts(of_minus_a_, of_b_, chart_frame(hemisphere), options_.perturbation);
    if (options_.validate) insist(validate(charts));
    return charts;
  }

  void offer_vertex_facets(const Charts& charts) {
    context_.report("vertex-facet pairs");
    const std::vector<VertexFacetPair> pairs = vertex_facet_pairs(charts);
    if (options_.validate) insist(validate(pairs, charts, a_, b_));
    context_.counters.vertex_facet_pairs += pairs.size();
    offer(pairs, charts, a_, b_, nearest_);
  }

  void offer_crossing_edges(const CanonicalSubsets& subsets, const Charts& charts, double share) {
    const LineScene scene(charts, lines_a_, lines_b_);
    if (options_.validate) {
      insist(validate(subsets, charts));
      insist(validate_separation(subsets, scene));
      for (std::size_t i = 0; i < subsets.size(); ++i) insist(validate(Grid(subsets[i], scene)));
    }
    const CanonicalSubsets::Sums sums = subsets.sums();
    context_.counters.canonical_pairs += subsets.size();
    context_.counters.sum_a += sums.a;
    context_.counters.sum_b += sums.b;
    context_.counters.crossings += sums.product;
    closest_lines(context_, subsets, scene, nearest_, {options_.closest_lines, options_.seed, share, share + 0.5});
  }

  const Polytope& a_;
  const Polytope& b_;
  const Options& options_;
  Progress progress_;
  Context context_;
  Counters& counters_;
  bool in_two_threads_;
  GaussianDiagram of_minus_a_, of_b_;
  EdgeLinesOfA lines_a_;
  EdgeLinesOfB lines_b_;
  NearestPlanes nearest_;
};

}  // namespace

NearestPlanes nearest_facets(const Polytope& a, const Polytope& b, long exponent, const Options& options, Counters& counters) {
  return Pipeline(a, b, exponent, options, counters).run();
}

}  // namespace fathom
