// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of fixed size: ours, over GMP's mpn functions, beside Boost's cpp_int and mpz_class, on
// what an expanding polytope computes with them: a plane through three points, the side of a
// fourth, and a comparison of two distances. At the end, times as multiples of ours.
#include <benchmark/benchmark.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "kernels/number/fixed_integer.hpp"
#include "kernels/vector.hpp"
#include "tests/benchmark/times_reporter.hpp"

namespace fathom {
namespace {

namespace mp = boost::multiprecision;
using Boost = mp::number<mp::cpp_int_backend<3072, 3072, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;
using Fixed = kernels::FixedInteger<3072>;

int order(const Boost& x, const Boost& y) { return x.compare(y); }
int order(const Fixed& x, const Fixed& y) { return cmp(x, y); }
int order(const mpz_class& x, const mpz_class& y) { return cmp(x, y); }

void set(Boost& x, const mpz_class& n) { x.assign(n.get_str()); }
void set(Fixed& x, const mpz_class& n) { x = Fixed(n); }
void set(mpz_class& x, const mpz_class& n) { x = n; }

/// Differences of points on a lattice of this many bits.
template <class Integer>
std::vector<Vec3<Integer>> differences(unsigned long bits) {
  gmp_randclass random(gmp_randinit_default);
  const mpz_class half = mpz_class(1) << bits;
  std::vector<Vec3<Integer>> result(64);
  for (Vec3<Integer>& v : result)
    for (Integer* const c : {&v.x, &v.y, &v.z}) set(*c, mpz_class(random.get_z_bits(bits + 1)) - half);
  return result;
}

template <class Integer>
int plane_side_and_distance(const std::vector<Vec3<Integer>>& v, std::size_t i) {
  const auto at = [&](std::size_t k) -> const Vec3<Integer>& { return v[(i + k) % v.size()]; };
  const auto plane = [&](std::size_t k, Vec3<Integer>& normal, Integer& height) {
    normal = cross(at(k + 1) - at(k), at(k + 2) - at(k));
    height = dot(normal, at(k));
  };
  Vec3<Integer> n, m;
  Integer c, d;
  plane(0, n, c);
  plane(3, m, d);
  const int side = order(dot(n, at(6)), c);
  return side + order(Integer(c * c * dot(m, m)), Integer(d * d * dot(n, n)));
}

template <class Integer>
void add(const std::string& contender) {
  for (const unsigned long bits : {22UL, 60UL, 150UL, 300UL}) {
    benchmark::RegisterBenchmark(("lattice of " + std::to_string(bits) + " bits/" + contender).c_str(),
                                 [bits](benchmark::State& state) {
                                   const std::vector<Vec3<Integer>> v = differences<Integer>(bits);
                                   std::size_t i = 0;
                                   for ([[maybe_unused]] auto _ : state)
                                     benchmark::DoNotOptimize(plane_side_and_distance(v, i++));
                                 });
  }
}

class RatioReporter : public benchmarks::TimesReporter {
 public:
  RatioReporter() : TimesReporter(Time::processor) {}

  void Finalize() override {
    for (const auto& [instance, times] : this->times()) {
      if (times.size() == 3)
        std::printf("%-24s boost %.2f, mpz_class %.2f times FixedInteger\n", instance.c_str(),
                    times.at("boost") / times.at("fixed"), times.at("mpz_class") / times.at("fixed"));
    }
  }
};

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::add<fathom::Fixed>("fixed");
  fathom::add<fathom::Boost>("boost");
  fathom::add<mpz_class>("mpz_class");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  fathom::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
}
