// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/nearest_facets.hpp"

#include <array>
#include <atomic>
#include <functional>

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

// One run of the pipeline: what is common to both hemispheres.
class Pipeline {
 public:
  Pipeline(const Polytope& a, const Polytope& b, long exponent, const Options& options, Counters& counters)
      : a_(a),
        b_(b),
        options_(options),
        counters_(counters),
        in_two_threads_(a.edges.size() + b.edges.size() >= worth_a_thread),
        lines_a_(a, exponent),
        lines_b_(b, exponent) {
    run_both(
        in_two_threads_, context_, [&](Context&) { of_minus_a_ = gaussian_diagram_of_reflection(a); },
        [&](Context&) { of_b_ = gaussian_diagram(b); });
    if (options.validate) {
      insist(validate(of_minus_a_, a, true));
      insist(validate(of_b_, b, false));
    }
  }

  NearestPlanes run() {
    std::array<Charts, 2> hemispheres;
    in_both("charts", [&](Context& context, std::size_t i, const auto&) { hemispheres[i] = charts(context, i == 1); });
    for (const Charts& charts : hemispheres) offer_vertex_facets(charts);
    std::array<CanonicalSubsets, 2> subsets;
    in_both("canonical subsets", [&](Context& context, std::size_t i, const auto& keep_going) {
      subsets[i] = canonical_subsets(context, hemispheres[i], keep_going);
    });
    counters_.predicates += context_.counters.predicates;
    for (std::size_t i = 0; i < 2; ++i) offer_crossing_edges(subsets[i], hemispheres[i], 0.5 * static_cast<double>(i));
    return std::move(nearest_);
  }

 private:
  void progress(const char* stage, double share) const {
    if (options_.progress && !options_.progress(stage, share)) throw Interrupted();
  }

  // Calls work(context, 0, keep_going) and work(context, 1, keep_going), one for each hemisphere. Only the calling thread talks; the other one hears from it
  // whether to go on.
  template <class Work>
  void in_both(const char* stage, const Work& work) {
    progress(stage, 0);
    std::atomic<bool> stopped = false;
    const std::function<bool(double)> talk = [&](double share) {
      if (options_.progress && !options_.progress(stage, share)) stopped = true;
      return !stopped;
    };
    const std::function<bool(double)> listen = [&](double) { return !stopped; };
    run_both(
        in_two_threads_, context_, [&](Context& context) { work(context, 0, talk); }, [&](Context& context) { work(context, 1, listen); });
    if (stopped) throw Interrupted();
  }

  Charts charts(Context& context, bool lower) const {
    Charts charts = make_charts(context, of_minus_a_, of_b_, chart_frame(lower), options_.perturbation);
    if (options_.validate) insist(validate(charts));
    return charts;
  }

  void offer_vertex_facets(const Charts& charts) {
    progress("vertex-facet pairs", 0);
    const std::vector<VertexFacetPair> pairs = vertex_facet_pairs(charts);
    if (options_.validate) insist(validate(pairs, charts, a_, b_));
    counters_.vertex_facet_pairs += pairs.size();
    offer(pairs, charts, a_, b_, nearest_);
  }

  void offer_crossing_edges(const CanonicalSubsets& subsets, const Charts& charts, double share) {
    if (options_.validate) {
      insist(validate(subsets, charts));
      insist(validate_separation(subsets, lines_a_, lines_b_, charts.frame.z.exact()));
      for (std::size_t i = 0; i < subsets.size(); ++i) insist(validate(Grid(subsets[i], charts, lines_a_, lines_b_), charts));
    }
    const CanonicalSubsets::Sums sums = subsets.sums();
    counters_.canonical_pairs += subsets.size();
    counters_.sum_a += sums.a;
    counters_.sum_b += sums.b;
    counters_.crossings += sums.product;
    const auto keep_going = [&](double done) {
      progress("closest lines", share + done / 2);
      return true;
    };
    closest_lines(subsets, charts, lines_a_, lines_b_, nearest_, counters_, {options_.closest_lines, options_.seed, keep_going});
  }

  const Polytope& a_;
  const Polytope& b_;
  const Options& options_;
  Counters& counters_;
  Context context_;
  bool in_two_threads_;
  GaussianDiagram of_minus_a_, of_b_;
  EdgeLines lines_a_, lines_b_;
  NearestPlanes nearest_;
};

}  // namespace

NearestPlanes nearest_facets(const Polytope& a, const Polytope& b, long exponent, const Options& options, Counters& counters) {
  return Pipeline(a, b, exponent, options, counters).run();
}

}  // namespace fathom
