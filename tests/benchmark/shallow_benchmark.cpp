// SPDX-License-Identifier: GPL-3.0-or-later
// Shallow penetrations of large bodies: the exact pipeline, SHALLOW-PENETRATION from the points on,
// and one query of bodies that are made ready, A moving from query to query. Unit spheres of random
// points, centres 1.98 apart.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "reference/approximate/shallow.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom {
namespace {

constexpr unsigned largest_for_pipeline = 10000;

Case spheres(unsigned points) {
  families::Random random(points);
  const Body a = families::random_sphere_body(random, points), b = families::random_sphere_body(random, points);
  return {"spheres", a, families::translated(b, {mpq_class(99, 50), 0, 0})};
}

/// Two bodies made ready.
struct Ready {
  explicit Ready(const Case& input, const mpq_class& delta)
      : placed(polytope::place(input.a.points, input.b.points)),
        hull_a(polytope::convex_hull(placed.a.points())),
        hull_b(polytope::convex_hull(placed.b.points())),
        a(hull_a),
        b(hull_b),
        bodies(context, a, b, delta) {}
  kernels::Context context;
  polytope::PlacedPair placed;
  polytope::Polytope hull_a, hull_b;
  polytope::Hierarchy a, b;
  approximate::ShallowPenetration bodies;
};

void query(benchmark::State& state, const Case& input, const mpq_class& delta) {
  Ready ready(input, delta);
  long moved = 0;
  std::uint64_t facets = 0, queries = 0;
  for ([[maybe_unused]] auto _ : state) {
    const approximate::ShallowResult result = ready.bodies.query(ready.context, {0, moved, -moved});
    moved = (moved + 977) % 100000;
    facets += result.facets;
    ++queries;
  }
  state.counters["queries/s"] = benchmark::Counter(static_cast<double>(queries), benchmark::Counter::kIsRate);
  state.counters["facets visited"] = static_cast<double>(facets) / static_cast<double>(queries);
}

void register_size(unsigned size) {
  const auto input = std::make_shared<const Case>(spheres(size));
  const std::string name = "spheres/" + std::to_string(size) + "/";
  if (size <= largest_for_pipeline) {
    benchmark::RegisterBenchmark((name + "pipeline").c_str(), [input](benchmark::State& state) {
      for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(testing::exact_depth(input->a.points, input->b.points));
    })->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark((name + "shallow").c_str(), [input](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(shallow_depth(input->a.points, input->b.points));
  })->Unit(benchmark::kMillisecond);
  for (const char* delta : {"1/4", "1"}) {
    benchmark::RegisterBenchmark((name + "query, delta " + delta).c_str(), [input, delta](benchmark::State& state) {
      query(state, *input, mpq_class(delta));
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  for (const unsigned size : {1000U, 10000U, 100000U}) fathom::register_size(size);
  benchmark::RunSpecifiedBenchmarks();
}
