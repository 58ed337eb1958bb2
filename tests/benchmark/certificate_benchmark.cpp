// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates: the time to find the depth with its proof, to write it and to check it, per family
// and size, beside the exact method and, on hulls of at most 64 vertices, Bullet's EPA, all in one
// run. Then: processor time as a multiple of the others', and of contact patches and a derivative
// beside the answer. Points go in as doubles where doubles
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
#include "fathom/patch.hpp"
#include "fathom/prepared.hpp"
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

/// The pairs of a set with their answers, patches found.
struct Touching {
  std::vector<Body> a, b;
  std::vector<Answer> answers;
  std::vector<ContactGeometry> geometries;
};

void add_patches(const std::string& instance, const std::shared_ptr<const Set>& set) {
  const auto all = std::make_shared<Touching>();
  for (const Pair& pair : set->pairs) {
    all->a.push_back(pair.a.empty() ? pair.input.a : Body{GivenPoints(pair.a)});
    all->b.push_back(pair.b.empty() ? pair.input.b : Body{GivenPoints(pair.b)});
    all->answers.push_back({certified(pair)});
    all->geometries.push_back(contact_geometry(all->a.back(), all->b.back(), all->answers.back()));
  }
  add(instance, "patches", set,
      [all](std::size_t i) { benchmark::DoNotOptimize(contact_geometry(all->a[i], all->b[i], all->answers[i])); });
  add(instance, "derivative", set, [all](std::size_t i) {
    static const Twist motion{{1, 2, 3}, {mpq_class(1, 2), 0, 1}};
    benchmark::DoNotOptimize(directional_derivative(all->geometries[i], motion));
  });
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
  if (size == 20) add_patches(instance, set);
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

/// One body of a pair moves; in each of its poses the pair penetrates.
struct Moving {
  PlacedBody still;
  std::vector<PlacedBody> moving;
  std::deque<Case> cases;
  WarmStart start;
};

/// A turn by about 1/64 and a shift by less than 1/64 for each pose, in numbers of binary32 as
/// engines have them.
std::vector<PoseBinary64> walk(std::size_t count) {
  std::vector<PoseBinary64> poses;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.4 + static_cast<double>(i) / 64, c = std::cos(t), s = std::sin(t), u = std::cos(2 * t),
                 v = std::sin(2 * t);
    const auto float_of = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    PoseBinary64 pose{{{c, -s * u, s * v, 0.25 * s}, {s, c * u, -c * v, 0.125 * c}, {0, v, u, 0.0625}}};
    for (auto& row : pose)
      for (double& x : row) x = float_of(x);
    poses.push_back(pose);
  }
  return poses;
}

void add_moving(const std::string& instance, const Body& a, const Body& b) {
  const auto all = std::make_shared<Moving>(Moving{{Prepared(b)}, {}, {}, {}});
  const Prepared prepared(a);
  const auto set = std::make_shared<Set>();
  for (const PoseBinary64& pose : walk(32)) {
    all->moving.push_back({prepared, pose});
    set->cases.push_back({instance, moved(all->moving.back()), b});
  }
  add(instance, "answer", set, [set](std::size_t i) {
    benchmark::DoNotOptimize(penetration_depth(set->cases[i].a, set->cases[i].b, options_with_workspace()));
  });
  add(instance, "prepared", set, [all](std::size_t i) {
    benchmark::DoNotOptimize(penetration_depth(all->moving[i], all->still, &all->start, options_with_workspace()));
  });
  add(instance, "overlap", set, [all](std::size_t i) {
    benchmark::DoNotOptimize(overlap(all->moving[i], all->still, {.workspace = options_with_workspace().workspace}));
  });
#ifdef FATHOM_BULLET
  const auto pairs = std::make_shared<std::vector<benchmarks::BulletPair>>();
  for (const Case& input : set->cases) pairs->emplace_back(input);
  add(instance, "bullet_epa", set, [pairs](std::size_t i) { benchmark::DoNotOptimize((*pairs)[i].depth()); });
#endif
}

Body box(double x, double y, double z) {
  Doubles points;
  for (int k = 0; k < 8; ++k) points.push_back({(k & 1) != 0 ? x : -x, (k & 2) != 0 ? y : -y, (k & 4) != 0 ? z : -z});
  return {GivenPoints(points)};
}

/// Points of a sphere around O, in binary32.
Body ball(std::size_t count, double radius) {
  Doubles points;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count), r = std::sqrt(1 - z * z),
                 t = 2.4 * static_cast<double>(i);
    const auto float_of = [&](double x) { return static_cast<double>(static_cast<float>(radius * x)); };
    points.push_back({float_of(r * std::cos(t)), float_of(r * std::sin(t)), float_of(z)});
  }
  return {GivenPoints(points)};
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
    for (const auto& [instance, times] : this->times()) {
      if (!times.contains("prepared") || !times.contains("bullet_epa")) continue;
      const double unit = times.at("bullet_epa");
      std::printf("%-28s  bullet_epa: answer %.2f, prepared %.2f, overlap %.2f\n", instance.c_str(),
                  times.at("answer") / unit, times.at("prepared") / unit, times.at("overlap") / unit);
    }
    for (const auto& [instance, times] : this->times()) {
      if (!times.contains("patches")) continue;
      std::printf("%-28s  answer: patches %.2f, derivative %.2f\n", instance.c_str(),
                  times.at("patches") / times.at("answer"), times.at("derivative") / times.at("answer"));
    }
    if (families == 0) return;
    std::printf("geometric mean of %zu families, 20 points  bullet_epa", families);
    for (const double sum : logarithms) std::printf(" %.2f", std::exp(sum / static_cast<double>(families)));
    std::printf("\n");
  }
};

void add_all() {
  add_moving("moving_boxes/8", box(0.5, 0.375, 0.25), box(1, 0.75, 0.5));
  for (const unsigned size : {20U, 40U, 200U})
    add_moving("moving_spheres/" + std::to_string(size), ball(size, 1), ball(size, 0.875));
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
