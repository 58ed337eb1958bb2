// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates: the time to find the depth with its proof, to write it and to check it, per family
// and size, beside the exact method and, on hulls of at most 64 vertices, Bullet's EPA, all in one
// run. Then: processor time as a multiple of the others'. Points go in as doubles where doubles
// hold them, as rationals elsewhere; one workspace serves all calls.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#ifdef FATHOM_BULLET
#include "tests/benchmark/bullet_epa.hpp"
#endif
#include "tests/benchmark/times_reporter.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

using Doubles = std::vector<std::array<double, 3>>;

/// A pair in both forms; doubles only if they are exact.
struct Pair {
  const Case& input;
  Doubles a, b;

  explicit Pair(const Case& c) : input(c) {
    const auto exact = [](const mpq_class& q) { return std::isfinite(q.get_d()) && exact_value(q.get_d()) == q; };
    const auto fits = [&](const Body& body) {
      return std::ranges::all_of(body.points, [&](const Point& p) { return exact(p.x) && exact(p.y) && exact(p.z); });
    };
    if (!fits(c.a) || !fits(c.b)) return;
    for (const Point& p : c.a.points) a.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
    for (const Point& p : c.b.points) b.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
  }
};

Options options_with_workspace() {
  static Workspace workspace;
  Options options;
  options.workspace = &workspace;
  return options;
}

Depth certified(const Pair& pair) {
  const Options options = options_with_workspace();
  return pair.a.empty() ? penetration_depth(pair.input.a.points, pair.input.b.points, options)
                        : penetration_depth(pair.a, pair.b, options);
}

std::string proof(const Pair& pair) {
  const Depth depth = certified(pair);
  return pair.a.empty() ? certificate_text(pair.input.a.points, pair.input.b.points, depth)
                        : certificate_text(pair.a, pair.b, depth);
}

/// Penetrating pairs of one family and size, with their certificates.
struct Set {
  std::deque<Case> cases;
  std::vector<Pair> pairs;
  std::vector<std::string> texts;
  std::size_t facets = 0, bytes = 0;
};

void fill(Set& set, const families::Family& family, unsigned size, std::size_t count) {
  for (std::uint64_t seed = 1; set.cases.size() < count && seed < 20 * count; ++seed) {
    Case input = family.make(seed, size);
    const Depth depth = penetration_depth(input.a.points, input.b.points);
    if (depth.status() != Status::penetrating) continue;
    const Certificate certificate = make_certificate(input.a.points, input.b.points, depth);
    set.texts.push_back(certificate_text(certificate));
    set.facets += certificate.inner.facets.size();
    set.bytes += set.texts.back().size();
    set.cases.push_back(std::move(input));
    set.pairs.emplace_back(set.cases.back());
  }
}

/// Registers work(i) on the pairs of a set, one after another; a time is that of one pair.
template <class Work>
void add(const std::string& instance, const std::string& contender, const std::shared_ptr<const Set>& set, Work work) {
  benchmark::RegisterBenchmark((instance + "/" + contender).c_str(), [set, work](benchmark::State& state) {
    std::size_t i = 0;
    for ([[maybe_unused]] auto _ : state) work(i++ % set->cases.size());
    state.counters["facets"] = static_cast<double>(set->facets) / static_cast<double>(set->cases.size());
    state.counters["bytes"] = static_cast<double>(set->bytes) / static_cast<double>(set->cases.size());
  })->Unit(benchmark::kMicrosecond);
}

void add_instance(const families::Family& family, unsigned size, std::size_t count, bool with_pipeline) {
  const auto filled = std::make_shared<Set>();
  fill(*filled, family, size, count);
  const std::shared_ptr<const Set> set = filled;
  if (set->cases.empty()) return;
  const std::string instance = std::string(family.name) + "/" + std::to_string(size);
  add(instance, "answer", set, [set](std::size_t i) { benchmark::DoNotOptimize(certified(set->pairs[i])); });
  add(instance, "text", set, [set](std::size_t i) { benchmark::DoNotOptimize(proof(set->pairs[i])); });
  add(instance, "check", set, [set](std::size_t i) { benchmark::DoNotOptimize(fathom_check::verify(set->texts[i])); });
  if (with_pipeline)
    add(instance, "pipeline", set, [set](std::size_t i) {
      benchmark::DoNotOptimize(testing::exact_depth(set->cases[i].a.points, set->cases[i].b.points));
    });
#ifdef FATHOM_BULLET
  if (size > 64) return;
  const auto pairs = std::make_shared<std::vector<benchmarks::BulletPair>>();
  for (const Case& input : set->cases) pairs->emplace_back(input);
  add(instance, "bullet_epa", set, [pairs](std::size_t i) { benchmark::DoNotOptimize((*pairs)[i].depth()); });
#endif
}

// Remembers each instance's times, to print ratios at the end.
class RatioReporter : public benchmarks::TimesReporter {
 public:
  RatioReporter() : TimesReporter(Time::processor) {}

  void Finalize() override {
    std::printf("\nprocessor time of the answer, of answer and text, and of the check, as a multiple of\n");
    std::array<double, 3> logarithms{};
    std::size_t families = 0;
    for (const auto& [instance, times] : this->times()) {
      if (!times.contains("answer") || !times.contains("text") || !times.contains("check")) continue;
      std::printf("%-28s", instance.c_str());
      for (const auto& [contender, time] : times) {
        if (contender != "pipeline" && contender != "bullet_epa") continue;
        const std::array<double, 3> ratios{times.at("answer") / time, times.at("text") / time,
                                           times.at("check") / time};
        std::printf("  %s %.2f %.2f %.2f", contender.c_str(), ratios[0], ratios[1], ratios[2]);
        if (contender != "bullet_epa" || !instance.ends_with("/20")) continue;
        for (std::size_t i = 0; i < ratios.size(); ++i) logarithms[i] += std::log(ratios[i]);
        ++families;
      }
      std::printf("\n");
    }
    if (families == 0) return;
    std::printf("geometric mean of %zu families, 20 points  bullet_epa", families);
    for (const double sum : logarithms) std::printf(" %.2f", std::exp(sum / static_cast<double>(families)));
    std::printf("\n");
  }
};

void add_all() {
  for (const families::Family& family : families::families()) {
    for (const unsigned size : {20U, 200U}) add_instance(family, size, 8, true);
  }
  add_instance(*families::find_family("random_sphere"), 64, 8, true);
  for (const char* name : {"random_sphere", "random_ball", "needles", "plates", "prisms_posed", "crossed_fans"})
    add_instance(*families::find_family(name), 1000, 2, true);
  for (const char* name : {"random_sphere", "random_ball"})
    add_instance(*families::find_family(name), 100000, 1, false);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  fathom::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
}
