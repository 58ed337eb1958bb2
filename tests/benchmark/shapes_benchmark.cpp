// SPDX-License-Identifier: GPL-3.0-or-later
// Curved shapes in random poses: the time to find bounds of their signed depth to 2^-40 of the extent and to write their certificate, of the
// median pair; the calls of the support and the bytes of certificates that it takes; and those of pairs with a continuum of optima.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "tests/support/random_shapes.hpp"

namespace fathom {
namespace {

using testing::ShapeMaker;
using Pairs = std::vector<std::pair<Shape, Shape>>;

struct Costs {
  double milliseconds, calls, bytes;
};

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Costs costs(const std::pair<Shape, Shape>& pair) {
  const auto& [a, b] = pair;
  const double start = processor_time();
  const std::string text = certificate_text(a, b, signed_depth(a, b));
  const double end = processor_time();
  kernels::Context context;
  return {end - start, static_cast<double>(curved::signed_bounds(context, a, b).support_calls), static_cast<double>(text.size())};
}

double quantile(std::vector<Costs>& all, double Costs::*member, double share) {
  std::sort(all.begin(), all.end(), [member](const Costs& x, const Costs& y) { return x.*member < y.*member; });
  return all[std::min(all.size() - 1, static_cast<std::size_t>(share * static_cast<double>(all.size())))].*member;
}

void add(const std::string& name, Pairs pairs) {
  const auto shared = std::make_shared<const Pairs>(std::move(pairs));
  benchmark::RegisterBenchmark(
      name.c_str(),
      [shared](benchmark::State& state) {
        for ([[maybe_unused]] auto _ : state) {
          std::vector<Costs> all;
          for (const auto& pair : *shared) all.push_back(costs(pair));
          state.SetIterationTime(1e-3 * quantile(all, &Costs::milliseconds, 0.5));
          state.counters["ms_p90"] = quantile(all, &Costs::milliseconds, 0.9);
          for (const auto& [share, suffix] : {std::pair{0.5, "_median"}, std::pair{0.9, "_p90"}, std::pair{1.0, "_max"}}) {
            state.counters[std::string("calls") + suffix] = quantile(all, &Costs::calls, share);
            state.counters[std::string("bytes") + suffix] = quantile(all, &Costs::bytes, share);
          }
        }
      })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(3);
}

// Quaternions and all lengths are doubles, or of a few digits. Centers are at most `reach` apart along each axis.
void add_random(const char* kind_a, const char* kind_b, unsigned bits, std::int64_t reach) {
  ShapeMaker make{families::Random(7), bits};
  Pairs pairs;
  while (pairs.size() < 100) {
    Shape a = make.posed(make.shape(kind_a), 0);
    pairs.emplace_back(std::move(a), make.posed(make.shape(kind_b), reach));
  }
  add(std::string(kind_a) + "-" + kind_b + (bits > 30 ? ", doubles, " : ", few digits, ") + (reach == 1 ? "deep" : "mostly apart"),
      std::move(pairs));
}

void add_all() {
  for (const auto& [a, b] : {std::pair{"cylinder", "cylinder"}, std::pair{"cone", "box"}, std::pair{"cylinder", "box"},
                             std::pair{"ellipsoid", "cylinder"}, std::pair{"ellipsoid", "ellipsoid"}}) {
    add_random(a, b, 50, 1);
    add_random(a, b, 50, 5);
    add_random(a, b, 4, 1);
  }
  const auto at = [](const Shape& shape, const mpq_class& x) { return moved(shape, rigid_pose({1, 0, 0, 0}, {x, 0, 0})); };
  const Shape bar = cylinder(1, 4), ball = ellipsoid({1, 1, mpq_class(1000001, 1000000)});
  add("coaxial cylinders", {{bar, bar}});
  add("parallel cylinders, 1/1000 off", {{bar, at(bar, mpq_class(1, 1000))}});
  add("parallel cylinders, 1/10 off", {{bar, at(bar, mpq_class(1, 10))}});
  add("nearly balls, 1 off", {{ball, at(ball, 1)}});
  add("nearly balls, 1/10 off", {{ball, at(ball, mpq_class(1, 10))}});
  add("nearly balls, concentric", {{ball, ball}});
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
