// SPDX-License-Identifier: GPL-3.0-or-later
// The exact pipeline against the exact alternatives, in one run: the hull of all vertex
// differences, CGAL's Gaussian map overlay, and the double-filtered scan over all pairs of edges
// (hulls included on every side). After the times it prints their ratios to the pipeline's.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#ifdef FATHOM_SGM
#include "tests/oracles/sgm/sgm_oracle.hpp"
#endif
#include "tests/benchmark/times_reporter.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using Solver = void (*)(const Case&);

void pipeline(const Case& input) { benchmark::DoNotOptimize(testing::exact_depth(input.a.points, input.b.points)); }

void hull_of_differences(const Case& input) {
  benchmark::DoNotOptimize(penetration_depth(input.a.points, input.b.points, {.method = Method::naive}));
}

void filtered_scan(const Case& input) {
  const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
  benchmark::DoNotOptimize(depth::nearest_facets_scan(polytope::convex_hull(placed.a.points()),
                                                      polytope::convex_hull(placed.b.points()), placed.exponent()));
}

#ifdef FATHOM_SGM
void gaussian_map_overlay(const Case& input) {
  benchmark::DoNotOptimize(oracles::sgm_oracle(input.a.points, input.b.points));
}
#endif

struct Contender {
  const char* name;
  Solver solve;
  unsigned largest;  ///< size up to which it is run: beyond that one call takes many seconds
};

constexpr Contender contenders[] = {
    {"pipeline", pipeline, 10000},
    {"filtered_scan", filtered_scan, 4000},
    {"hull_of_differences", hull_of_differences, 400},
#ifdef FATHOM_SGM
    {"gaussian_map_overlay", gaussian_map_overlay, 400},
#endif
};

void register_all(const char* family, std::initializer_list<unsigned> sizes) {
  for (const unsigned size : sizes) {
    const Case input = families::find_family(family)->make(1, size);
    for (const Contender& contender : contenders) {
      if (size > contender.largest) continue;
      const std::string name = std::string(family) + "/" + std::to_string(size) + "/" + contender.name;
      benchmark::RegisterBenchmark(name.c_str(), [input, solve = contender.solve](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) solve(input);
      })->Unit(benchmark::kMillisecond);
    }
  }
}

// Remembers each case's times, to print ratios at the end.
class RatioReporter : public benchmarks::TimesReporter {
 public:
  RatioReporter() : TimesReporter(Time::real) {}

  void Finalize() override {
    std::printf("\ntime as a multiple of the pipeline's\n");
    for (const auto& [instance, times] : this->times()) {
      const auto base = times.find("pipeline");
      if (base == times.end()) continue;
      std::printf("%-28s", instance.c_str());
      for (const auto& [contender, time] : times) {
        if (contender != "pipeline") std::printf("  %s %.2f", contender.c_str(), time / base->second);
      }
      std::printf("\n");
    }
  }
};

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::register_all("random_sphere", {20, 100, 400, 1000, 4000, 10000});
  fathom::register_all("crossed_fans", {20, 100, 400, 1000, 4000});
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  fathom::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
}
