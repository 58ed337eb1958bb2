// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of convex pieces, by family and number of pieces: the processor time of the answer, of
// answer and certificate, and of the check; the bytes of certificates; the pairs of pieces that the
// search looked at closely, and the cells that it split. Of pairs that penetrate, the median, what
// nine of ten are below, and the most. `memory`: the most that the process has used so far.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fathom/certificate.hpp"
#include "fathom/union.hpp"
#include "verify/check/check.hpp"
#include "verify/families/families.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom {
namespace {

/// In seconds.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Costs {
  double answer = 0, proof = 0, check = 0;  // in seconds
  double bytes = 0, pairs = 0, cells = 0;
  bool refused = false;
};

double quantile(std::vector<Costs>& all, double Costs::*member, double share) {
  std::sort(all.begin(), all.end(), [member](const Costs& x, const Costs& y) { return x.*member < y.*member; });
  return all[std::min(all.size() - 1, static_cast<std::size_t>(share * static_cast<double>(all.size())))].*member;
}

/// Returns nullopt unless they penetrate.
std::optional<Costs> costs_of(const Pieces& a, const Pieces& b) {
  const double start = processor_time();
  const UnionDepth depth = union_depth(a, b, {nullptr, false});
  const double answered = processor_time();
  if (depth.status != Status::penetrating) return std::nullopt;
  const std::string text = certificate_text(a, b, depth);
  const double proved = processor_time();
  const bool accepted = fathom_check::verify(text).accepted();
  Costs costs;
  costs.check = processor_time() - proved;
  costs.answer = answered - start;
  costs.proof = proved - start;
  costs.bytes = static_cast<double>(text.size());
  costs.pairs = static_cast<double>(depth.counters.pairs_touched);
  costs.cells = static_cast<double>(depth.counters.nodes);
  costs.refused = !accepted;
  return costs;
}

void report(std::vector<Costs>& all, benchmark::State& state) {
  const auto figures = [&](const std::string& name, double Costs::*member, double unit) {
    for (const auto& [share, suffix] : {std::pair{0.5, "_median"}, std::pair{0.9, "_p90"}, std::pair{1.0, "_max"}})
      state.counters[name + suffix] = unit * quantile(all, member, share);
  };
  figures("answer_ms", &Costs::answer, 1e3);
  figures("proof_ms", &Costs::proof, 1e3);
  figures("check_ms", &Costs::check, 1e3);
  figures("kB", &Costs::bytes, 1e-3);
  figures("pairs", &Costs::pairs, 1);
  figures("cells", &Costs::cells, 1);
  state.counters["of"] = static_cast<double>(all.size());
  state.counters["refused"] =
      static_cast<double>(std::count_if(all.begin(), all.end(), [](const Costs& c) { return c.refused; }));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["memory_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

/// A row: so many cases, each made from its seed.
template <class Make>
void add_row(const std::string& name, std::uint64_t cases, Make make) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [cases, make](benchmark::State& state) {
                                 for ([[maybe_unused]] auto _ : state) {
                                   std::vector<Costs> all;
                                   for (std::uint64_t seed = 1; seed <= cases; ++seed) {
                                     const families::UnionPair pair = make(seed);
                                     if (const auto costs = costs_of(pair.a, pair.b)) all.push_back(*costs);
                                   }
                                   state.SetIterationTime(quantile(all, &Costs::answer, 0.5));
                                   report(all, state);
                                 }
                               })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

void add_family(const char* family, unsigned pieces, std::uint64_t cases) {
  const families::Family& maker = *families::find_family(family);
  add_row(std::string(family) + "/" + std::to_string(pieces), cases, [&maker, pieces](std::uint64_t seed) {
    const Case pair = maker.make(seed, pieces);
    return families::UnionPair{*pair.a.pieces, *pair.b.pieces};
  });
}

/// A cube cut into so many along each axis, on the same: every seam is on a seam.
void add_cubes(unsigned cells) {
  add_row("cubes/" + std::to_string(cells * cells * cells), 1, [cells](std::uint64_t) {
    const Pieces cubes = families::cut_into_grid({0, 0, 0}, {cells, cells, cells}, cells);
    return families::UnionPair{cubes, cubes};
  });
}

void add_all() {
  for (const unsigned pieces : {2U, 5U, 10U}) add_family("clusters", pieces, 200);
  add_family("clusters", 20, 1000);
  add_family("clusters", 40, 100);
  for (const unsigned pieces : {6U, 12U, 24U, 48U}) add_family("rings_linked", pieces, 50);
  for (const unsigned cells : {2U, 3U, 4U}) add_cubes(cells);
  for (const unsigned pieces : {5U, 10U, 20U}) add_family("cut_planes", pieces, 20);
  for (const unsigned pieces : {5U, 20U, 80U}) add_family("slots_narrow", pieces, 20);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  fathom::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
