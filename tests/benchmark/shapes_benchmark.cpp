// SPDX-License-Identifier: GPL-3.0-or-later
// Curved shapes in random poses: the time to find bounds of their signed depth to 2^-40 of the
// extent and to write their certificate, of the median pair; the calls of the support and the bytes
// of certificates that it takes; and those of pairs with a continuum of optima. Rounded shapes: the
// time to find their signed depth, as a multiple of the time that their cores alone take, in turns.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/number/rational.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/shapes/core.hpp"
#include "tests/support/random_shapes.hpp"

namespace fathom {
namespace {

using testing::ShapeMaker;
using Pairs = std::vector<std::pair<Shape, Shape>>;

constexpr std::size_t pairs_of_a_row = 100;

/// In seconds.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Costs>
double quantile(std::vector<Costs>& all, double Costs::*member, double share) {
  std::sort(all.begin(), all.end(), [member](const Costs& x, const Costs& y) { return x.*member < y.*member; });
  return all[std::min(all.size() - 1, static_cast<std::size_t>(share * static_cast<double>(all.size())))].*member;
}

/// A row: its counters follow from the costs of each pair.
template <class CostsOf, class Report>
void add_row(const std::string& name, Pairs pairs, CostsOf costs_of, Report report) {
  const auto shared = std::make_shared<const Pairs>(std::move(pairs));
  benchmark::RegisterBenchmark(name.c_str(),
                               [shared, costs_of, report](benchmark::State& state) {
                                 for ([[maybe_unused]] auto _ : state) {
                                   std::vector<decltype(costs_of(shared->front()))> all;
                                   for (const auto& pair : *shared) all.push_back(costs_of(pair));
                                   state.SetIterationTime(quantile(all, &decltype(all)::value_type::seconds, 0.5));
                                   report(all, state.counters);
                                 }
                               })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

// ---- curved shapes ----

struct CurvedCosts {
  double seconds, calls, bytes;
};

CurvedCosts curved_costs(const std::pair<Shape, Shape>& pair) {
  const auto& [a, b] = pair;
  const double start = processor_time();
  const std::string text = certificate_text(a, b, signed_depth(a, b));
  const double end = processor_time();
  kernels::Context context;
  return {end - start, static_cast<double>(curved::signed_bounds(context, a, b).support_calls),
          static_cast<double>(text.size())};
}

void add_curved(const std::string& name, Pairs pairs) {
  add_row(name, std::move(pairs), curved_costs, [](std::vector<CurvedCosts>& all, benchmark::UserCounters& counters) {
    counters["ms_p90"] = 1e3 * quantile(all, &CurvedCosts::seconds, 0.9);
    for (const auto& [share, suffix] : {std::pair{0.5, "_median"}, std::pair{0.9, "_p90"}, std::pair{1.0, "_max"}}) {
      counters[std::string("calls") + suffix] = quantile(all, &CurvedCosts::calls, share);
      counters[std::string("bytes") + suffix] = quantile(all, &CurvedCosts::bytes, share);
    }
  });
}

// Quaternions and all lengths are doubles, or of a few digits. Centers are at most `reach` apart
// along each axis.
void add_random_curved(const char* kind_a, const char* kind_b, unsigned bits, std::int64_t reach) {
  ShapeMaker make{families::Random(7), bits};
  Pairs pairs;
  while (pairs.size() < pairs_of_a_row) {
    Shape a = make.posed(make.shape(kind_a), 0);
    pairs.emplace_back(std::move(a), make.posed(make.shape(kind_b), reach));
  }
  add_curved(std::string(kind_a) + "-" + kind_b + (bits > 30 ? ", doubles, " : ", few digits, ") +
                 (reach == 1 ? "deep" : "mostly apart"),
             std::move(pairs));
}

void add_all_curved() {
  for (const auto& [a, b] : {std::pair{"cylinder", "cylinder"}, std::pair{"cone", "box"}, std::pair{"cylinder", "box"},
                             std::pair{"ellipsoid", "cylinder"}, std::pair{"ellipsoid", "ellipsoid"}}) {
    add_random_curved(a, b, 50, 1);
    add_random_curved(a, b, 50, 5);
    add_random_curved(a, b, 4, 1);
  }
  const auto at = [](const Shape& shape, const mpq_class& x) {
    return moved(shape, rigid_pose({1, 0, 0, 0}, {x, 0, 0}));
  };
  const Shape bar = cylinder(1, 4), ball = ellipsoid({1, 1, mpq_class(1000001, 1000000)});
  add_curved("coaxial cylinders", {{bar, bar}});
  add_curved("parallel cylinders, 1/1000 off", {{bar, at(bar, mpq_class(1, 1000))}});
  add_curved("parallel cylinders, 1/10 off", {{bar, at(bar, mpq_class(1, 10))}});
  add_curved("nearly balls, 1 off", {{ball, at(ball, 1)}});
  add_curved("nearly balls, 1/10 off", {{ball, at(ball, mpq_class(1, 10))}});
  add_curved("nearly balls, concentric", {{ball, ball}});
}

// ---- rounded shapes ----

struct RoundedCosts {
  double seconds, cores, ratio;
};

/// A core in the form in which penetration_depth takes it fastest.
Body core_of(const Shape& shape) {
  std::vector<Point> points = *shapes::polytope_points(shape, most_expanded_points);
  std::vector<std::array<double, 3>> doubles;
  for (const Point& p : points) {
    const auto x = kernels::in_binary64(p.x), y = kernels::in_binary64(p.y), z = kernels::in_binary64(p.z);
    if (!x || !y || !z) return {GivenPoints(std::move(points))};
    doubles.push_back({*x, *y, *z});
  }
  return {GivenPoints(std::move(doubles))};
}

RoundedCosts rounded_costs(const std::pair<Shape, Shape>& pair) {
  constexpr int rounds = 7, calls = 5;
  const auto& [a, b] = pair;
  const Body core_a = core_of(a), core_b = core_of(b);
  static Workspace workspace;
  SignedDepthOptions options;
  options.cores.workspace = &workspace;
  const auto time_of = [](auto work) {
    const double start = processor_time();
    for (int i = 0; i < calls; ++i) benchmark::DoNotOptimize(work());
    return (processor_time() - start) / calls;
  };
  double cores = std::numeric_limits<double>::infinity(), rounded = cores;
  for (int i = 0; i < rounds; ++i) {
    cores = std::min(cores, time_of([&] { return penetration_depth(core_a, core_b, options.cores); }));
    rounded = std::min(rounded, time_of([&] { return signed_depth(pair.first, pair.second, options); }));
  }
  return {rounded, cores, rounded / cores};
}

void add_rounded(const std::string& name, Pairs pairs) {
  add_row("rounded/" + name, std::move(pairs), rounded_costs,
          [](std::vector<RoundedCosts>& all, benchmark::UserCounters& counters) {
            counters["cores_us"] = 1e6 * quantile(all, &RoundedCosts::cores, 0.5);
            counters["ratio_median"] = quantile(all, &RoundedCosts::ratio, 0.5);
            counters["ratio_p90"] = quantile(all, &RoundedCosts::ratio, 0.9);
          });
}

/// How the numbers of a pair are written, and where B stands: what costs depend on.
enum class Numbers { doubles, posed, short_rationals };
enum class Meeting { deep, apart, touching };

struct RoundedMaker {
  ShapeMaker make;
  Numbers numbers;

  /// In the cube from -1 to 1.
  Point point() {
    Point p = make.point(1);
    if (numbers != Numbers::short_rationals) return p;
    for (mpq_class* const c : {&p.x, &p.y, &p.z})
      *c = families::ratio(make.random.between(-100, 100), make.random.between(100, 110));
    return p;
  }
  /// A hull of `n` points.
  Shape points(std::size_t n) {
    std::vector<Point> vertices(n);
    for (Point& p : vertices) p = point();
    return hull(vertices);
  }
  Shape any_box() {
    const Point p = point();
    return box({1 + p.x / 2, 1 + p.y / 2, 1 + p.z / 2});
  }
  Shape posed(const Shape& shape) { return numbers == Numbers::posed ? make.posed(shape, 0) : shape; }

  std::pair<Shape, Shape> pair(const Shape& a, const Shape& b, Meeting meeting) {
    const Shape first = posed(a), second = posed(b);
    const auto at = [&](const Point& t) {
      return std::pair(with_margin(first, mpq_class(1, 8)),
                       with_margin(moved(second, rigid_pose({1, 0, 0, 0}, t)), mpq_class(1, 4)));
    };
    if (meeting == Meeting::deep) return at({mpq_class(1, 4), 0, 0});
    if (meeting == Meeting::apart) return at({5, 1, mpq_class(1, 2)});
    // Moved back by the shortest way out, or in.
    const Depth depth = penetration_depth(core_of(first), core_of(second));
    const Point t = depth.contact_translation();
    return at({-t.x, -t.y, -t.z});
  }
};

Shape segment(const Point& p) { return hull(std::array{Point{-p.x, -p.y, -p.z}, p}); }

void add_rounded_rows(const std::string& name, Numbers numbers, Meeting meeting) {
  const auto add = [&](const std::string& kind, auto shape_a, auto shape_b) {
    RoundedMaker make{{families::Random(11), 30}, numbers};
    Pairs pairs;
    while (pairs.size() < pairs_of_a_row) {
      const Shape a = shape_a(make);
      pairs.push_back(make.pair(a, shape_b(make), meeting));
    }
    add_rounded(kind + ", " + name, std::move(pairs));
  };
  const auto box_of = [](RoundedMaker& make) { return make.any_box(); };
  const auto hull_of = [](std::size_t n) { return [n](RoundedMaker& make) { return make.points(n); }; };
  const auto segment_of = [](RoundedMaker& make) { return segment(make.point()); };
  const auto point_of = [](RoundedMaker& make) { return make.points(1); };
  add("hulls of 20", hull_of(20), hull_of(20));
  add("boxes", box_of, box_of);
  add("capsule and box", segment_of, box_of);
  if (meeting == Meeting::deep) return;  // their cores have no volume together
  add("capsules", segment_of, segment_of);
  add("spheres", point_of, point_of);
}

void add_all_rounded() {
  for (const auto& [meeting, where] :
       {std::pair{Meeting::deep, "deep"}, std::pair{Meeting::apart, "apart"}, std::pair{Meeting::touching, "touching"}})
    for (const auto& [numbers, written] : {std::pair{Numbers::doubles, "doubles"}, std::pair{Numbers::posed, "posed"},
                                           std::pair{Numbers::short_rationals, "short rationals"}})
      add_rounded_rows(std::string(written) + ", " + where, numbers, meeting);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::add_all_curved();
  fathom::add_all_rounded();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
