// SPDX-License-Identifier: GPL-3.0-or-later
// The slowest small inputs that are known: what goes past the filters, or makes numbers long. Each
// by the commands that it is slow for.
#include <benchmark/benchmark.h>

#include <string>

#include "fathom/approximate.hpp"
#include "fathom/depth.hpp"
#include "fathom/study.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"

namespace fathom {
namespace {

enum Command { by_default = 1, exactly = 2, approximately = 4, studied = 8 };

Case of_family(const char* name, unsigned size) { return families::find_family(name)->make(1, size); }

template <class F>
Case with_each_point(Case input, F change) {
  for (Body* body : {&input.a, &input.b})
    for (Point& p : body->points.edit()) change(p);
  return input;
}

mpz_class power_of_two(unsigned long exponent) { return mpz_class(1) << exponent; }

/// Every coordinate moved a little, to one over a random denominator of so many bits.
Case over_unlike_denominators(Case input, unsigned bits) {
  gmp_randclass random(gmp_randinit_default);
  const auto near = [&](mpq_class& q) {
    const mpz_class denominator = power_of_two(bits - 1) + random.get_z_bits(bits - 1);
    q = families::ratio(mpz_class(q * denominator), denominator);
  };
  return with_each_point(std::move(input), [&](Point& p) { near(p.x), near(p.y), near(p.z); });
}

Case stretched(Case input, unsigned long exponent) {
  return with_each_point(std::move(input),
                         [&](Point& p) { p.x /= power_of_two(exponent), p.z *= power_of_two(exponent); });
}

/// Each rotation makes the coordinates some 62 bits longer.
Case turned(Case input, int times) {
  families::Bodies bodies{input.a, input.b};
  for (long k = 1; k <= times; ++k)
    bodies = families::rotated(
        bodies, families::rotation((1L << 30) + k, (1L << 29) - k, (1L << 30) - 7 * k, (1L << 28) + 3 * k));
  return {input.id, bodies.a, bodies.b};
}

template <class Work>
void add_work(const std::string& name, const Case& input, Work work) {
  benchmark::RegisterBenchmark(name.c_str(), [input, work](benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) work(input.a.points, input.b.points);
  })->Unit(benchmark::kMillisecond);
}

using Points = std::vector<Point>;

void add(const std::string& name, const Case& input, unsigned commands) {
  const auto depth = [](Method method) {
    return [method](const Points& a, const Points& b) {
      benchmark::DoNotOptimize(penetration_depth(a, b, {.method = method}));
    };
  };
  if (commands & by_default) add_work(name + "/automatic", input, depth(Method::automatic));
  if (commands & exactly) add_work(name + "/exact", input, depth(Method::exact));
  if (commands & approximately)
    add_work(name + "/approx", input,
             [](const Points& a, const Points& b) { benchmark::DoNotOptimize(approx_depth(a, b, mpq_class(1, 100))); });
  if (commands & studied)
    add_work(name + "/study", input, [](const Points& a, const Points& b) { benchmark::DoNotOptimize(study(a, b)); });
}

void add_all() {
  const Case spheres = of_family("random_sphere", 1000);
  for (const unsigned bits : {32U, 64U, 128U})
    add("denominators of " + std::to_string(bits) + " bits", over_unlike_denominators(spheres, bits),
        by_default | exactly);
  add("denominators of 10000 bits", over_unlike_denominators(of_family("random_sphere", 4), 10000),
      by_default | exactly);
  add("stretched by 1e300", stretched(spheres, 1000), by_default | exactly | approximately | studied);
  const Case ties = of_family("crossed_vanishing_ties", 1000);
  add("vanishing ties", ties, by_default | exactly);
  for (const int times : {10, 50})
    add("vanishing ties turned " + std::to_string(times) + " times", turned(ties, times), exactly);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
