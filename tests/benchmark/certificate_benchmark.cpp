// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates: the time to find the depth with its proof, to write it and to check it, per family and size, beside the exact method and,
// on hulls of 20 vertices, Bullet's EPA, all in one run. Then: processor time, with and without the check, as a multiple of the others'.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fathom/certificate.hpp"
#ifdef FATHOM_BULLET
#include "tests/benchmark/bullet_epa.hpp"
#endif
#include "tests/benchmark/times_reporter.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"

namespace fathom {
namespace {

/// Penetrating pairs of one family and size, with their certificates.
struct Set {
  std::vector<Case> cases;
  std::vector<std::string> texts;
  std::size_t facets = 0, bytes = 0;
};

Depth certified(const Case& input) { return penetration_depth(input.a.points, input.b.points); }

std::string proof(const Case& input) { return certificate_text(make_certificate(input.a.points, input.b.points, certified(input))); }

Set make_set(const families::Family& family, unsigned size, std::size_t count) {
  Set set;
  for (std::uint64_t seed = 1; set.cases.size() < count && seed < 20 * count; ++seed) {
    Case input = family.make(seed, size);
    const Depth depth = certified(input);
    if (depth.status() != Status::penetrating) continue;
    const Certificate certificate = make_certificate(input.a.points, input.b.points, depth);
    set.texts.push_back(certificate_text(certificate));
    set.facets += certificate.inner.facets.size();
    set.bytes += set.texts.back().size();
    set.cases.push_back(std::move(input));
  }
  return set;
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
  const auto set = std::make_shared<const Set>(make_set(family, size, count));
  if (set->cases.empty()) return;
  const std::string instance = std::string(family.name) + "/" + std::to_string(size);
  add(instance, "answer", set, [set](std::size_t i) { benchmark::DoNotOptimize(certified(set->cases[i])); });
  add(instance, "answer_and_text", set, [set](std::size_t i) { benchmark::DoNotOptimize(proof(set->cases[i])); });
  add(instance, "check", set, [set](std::size_t i) { benchmark::DoNotOptimize(fathom_check::verify(set->texts[i])); });
  add(instance, "all", set, [set](std::size_t i) { benchmark::DoNotOptimize(fathom_check::verify(proof(set->cases[i]))); });
  if (with_pipeline)
    add(instance, "pipeline", set,
        [set](std::size_t i) { benchmark::DoNotOptimize(testing::exact_depth(set->cases[i].a.points, set->cases[i].b.points)); });
#ifdef FATHOM_BULLET
  if (size > 20) return;
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
    std::printf("\nanswer with certificate (and its check): processor time as a multiple of\n");
    for (const auto& [instance, times] : this->times()) {
      const auto written = times.find("answer_and_text"), all = times.find("all");
      if (written == times.end() || all == times.end()) continue;
      std::printf("%-28s", instance.c_str());
      for (const auto& [contender, time] : times) {
        if (contender == "pipeline" || contender == "bullet_epa")
          std::printf("  %s %.2f (%.2f)", contender.c_str(), written->second / time, all->second / time);
      }
      std::printf("\n");
    }
  }
};

void add_all() {
  for (const families::Family& family : families::families()) {
    for (const unsigned size : {20U, 200U}) add_instance(family, size, 8, true);
  }
  for (const char* name : {"random_sphere", "random_ball", "needles", "plates", "prisms_posed", "crossed_fans"})
    add_instance(*families::find_family(name), 1000, 2, true);
  for (const char* name : {"random_sphere", "random_ball"}) add_instance(*families::find_family(name), 100000, 1, false);
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
