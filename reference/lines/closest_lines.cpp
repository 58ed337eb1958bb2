// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/closest_lines.hpp"

#include <algorithm>

#include "reference/lines/cutting.hpp"

namespace fathom::lines {
namespace {

// Canonical pairs with at most this many crossings are scanned without asking the vertex test
// first.
constexpr std::uint64_t tiny = 64;
// Of each large pair, the crossings of about this many rows with as many columns are looked at
// first.
constexpr std::size_t stride_lines = 32;

// Every k-th arc, for about stride_lines of them.
template <class Arc>
std::vector<Arc> strided(std::span<const Arc> arcs, std::mt19937_64& random) {
  const std::size_t step = std::max<std::size_t>(1, arcs.size() / stride_lines);
  std::vector<Arc> chosen;
  for (std::size_t i = random() % step; i < arcs.size(); i += step) chosen.push_back(arcs[i]);
  return chosen;
}

// One global best over all canonical pairs: small pairs first, then the large ones, promising ones
// first.
class PairScan {
 public:
  PairScan(kernels::Context& context, const canonical::CanonicalSubsets& subsets, const LineScene& scene,
           kernels::NearestPlanes& nearest, const ClosestLinesOptions& options)
      : context_(context),
        subsets_(subsets),
        scene_(scene),
        search_(context, scene, nearest, options.seed, options.trace),
        options_(options) {
    if (options.trace) options.trace->pairs.resize(subsets.size());
  }

  void scan_all() {
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if (i % 1024 == 0) report(i, subsets_.size());
      scan(i);
    }
  }

  void run() {
    const canonical::CanonicalSubsets::Sums sums = subsets_.sums();
    report(0, 1);
    std::uint64_t done = 0;
    const auto finished = [&](std::size_t i) {
      done += subsets_[i].a.size() + subsets_[i].b.size();
      if (i % 64 == 0) report(done, sums.a + sums.b);
    };
    std::vector<Promise> large;
    for (std::size_t i = 0; i < subsets_.size(); ++i) {
      if (!start(i)) {
        finished(i);
      } else if (!clears(i)) {
        large.push_back({promise(i), i});
      }
    }
    std::ranges::sort(large, {}, [](const Promise& p) { return std::pair(p.squared, p.pair); });
    for (const Promise& p : large) {
      if (!clears(p.pair)) cut(p.pair);
      finished(p.pair);
    }
  }

 private:
  struct Promise {
    double squared;
    std::size_t pair;
  };

  void report(std::uint64_t done, std::uint64_t all) {
    const double share = static_cast<double>(done) / static_cast<double>(all);
    context_.report("closest lines", options_.first_share + share * (options_.last_share - options_.first_share));
  }

  Grid grid(std::size_t i) const { return Grid(subsets_[i], scene_); }

  bool clears(std::size_t i) {
    const bool clear = vertex_clears(grid(i), search_.nearest(), search_.bound());
    if (clear) note(i, Treatment::cleared, 0);
    return clear;
  }

  void scan(std::size_t i) {
    const canonical::CanonicalPair pair = subsets_[i];
    search_.scan(pair.a, pair.b);
    note(i, Treatment::scanned, pair.crossings());
  }

  // In the trace: how pair i was dealt with, and how many pairs of lines that took beside those
  // before.
  void note(std::size_t i, Treatment treatment, std::uint64_t evaluated) {
    if (!options_.trace) return;
    SearchTrace::OfPair& pair = options_.trace->pairs[i];
    pair.treatment = treatment;
    pair.evaluated += evaluated;
  }

  // Deals with a pair that is small; tells whether it is large.
  bool start(std::size_t i) {
    const canonical::CanonicalPair pair = subsets_[i];
    if (pair.crossings() > options_.scanned) return true;
    if (pair.crossings() <= tiny || !clears(i)) scan(i);
    return false;
  }

  // Looks at a part of the pair, and estimates how near its nearest crossing is.
  double promise(std::size_t i) {
    const canonical::CanonicalPair pair = subsets_[i];
    const std::vector<chart::ChartArcOfA> of_a = strided(pair.a, search_.random());
    const std::vector<chart::ChartArcOfB> of_b = strided(pair.b, search_.random());
    search_.scan(of_a, of_b);
    note(i, Treatment::cut, std::uint64_t{of_a.size()} * of_b.size());
    double least = std::numeric_limits<double>::infinity();
    for (const chart::ChartArcOfA e : of_a) {
      for (const chart::ChartArcOfB f : of_b) {
        least = std::min(least,
                         kernels::estimated_squared_distance(scene_.a.images(), e.value, scene_.b.images(), f.value));
      }
    }
    return least;
  }

  void cut(std::size_t i) {
    const std::uint64_t before = context_.counters.pairs_evaluated;
    if (options_.trace) options_.trace->pair = i;
    if (options_.engine == ClosestLines::cutting) {
      closest_by_cutting(grid(i), search_, options_.cutting_size);
    } else {
      closest_by_sampling(grid(i), search_, options_.sampled_size);
    }
    note(i, Treatment::cut, context_.counters.pairs_evaluated - before);
  }

  kernels::Context& context_;
  const canonical::CanonicalSubsets& subsets_;
  const LineScene& scene_;
  LineSearch search_;
  const ClosestLinesOptions& options_;
};

}  // namespace

void closest_lines(kernels::Context& context, const canonical::CanonicalSubsets& subsets, const LineScene& scene,
                   kernels::NearestPlanes& nearest, const ClosestLinesOptions& options) {
  PairScan scan(context, subsets, scene, nearest, options);
  if (options.engine == ClosestLines::naive) {
    scan.scan_all();
  } else {
    scan.run();
  }
}

kernels::Report validate_separation(const canonical::CanonicalSubsets& subsets, const LineScene& scene) {
  kernels::Report report;
  for (std::size_t k = 0; k < subsets.size(); ++k) {
    const canonical::CanonicalPair pair = subsets[k];
    for (const chart::ChartArcOfA e : pair.a) {
      for (const chart::ChartArcOfB f : pair.b) {
        const Vector w = cross(scene.a.direction(e), scene.b.direction(f));
        const mpz_class height = dot(scene.b.point(f) - scene.a.point(e), w);
        report.expect(sgn(height) * sgn(dot(w, scene.pole)) >= 0 && (is_zero(w) || height != 0),
                      "C4: edge " + std::to_string(scene.b.edge(f).value) + " of B is not above edge " +
                          std::to_string(scene.a.edge(e).value) + " of A");
      }
    }
  }
  return report;
}

}  // namespace fathom::lines
