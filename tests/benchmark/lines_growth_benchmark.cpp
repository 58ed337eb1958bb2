// SPDX-License-Identifier: GPL-3.0-or-later
// How the stages of the pipeline, and the three engines of its closest-lines stage, grow with the
// input.
//   lines_growth_benchmark [--naive-up-to CROSSINGS] [--sampled-up-to N] [--turned 1] [--repeat N]
//   FAMILY SIZE [SIZE...] ... With --turned 1 both bodies are rotated, exactly, so that their
//   chains lie along no axis. Engines run N times; the least time counts. One process per case, so
//   that the peak memory is its own. Work is cells + block tests + pairs evaluated. The last lines
//   of each family are exponents between its smallest and its largest size.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "reference/gaussian/gaussian_diagram.hpp"
#include "reference/lines/closest_lines.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/vertex_facet/vertex_facet.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

namespace fathom {
namespace {

struct EngineRow {
  double seconds = -1;
  std::uint64_t cells = 0, tests = 0, pairs = 0, exact = 0;
  [[nodiscard]] double work() const { return static_cast<double>(cells + tests + pairs); }
};

struct Row {
  unsigned size = 0;
  std::uint64_t edges_a = 0, edges_b = 0, crossings = 0, sum = 0, canonical_pairs = 0;
  double aghrs =
      0;  // sum (|A_i||B_i|)^(3/4) + |A_i| + |B_i|: what AGHRS bound by O(K^(1/2+eps) (mn)^(1/4) + ...), section 2.3
  double hulls = 0, charts = 0, vertex_facets = 0, canonical = 0;
  EngineRow engines[3];
  long peak_megabytes = 0;
};

class Clock {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

struct Limits {
  double naive_crossings = 2e9;
  unsigned sampled_size = 300000;
  bool turned = false;
  int repeat = 1;
};

families::Bodies bodies(const families::Family& family, unsigned size, bool turned) {
  const Case input = family.make(1, size);
  const families::Bodies made{input.a, input.b};
  return turned ? families::rotated(made, families::rotation(7, 2, -3, 4)) : made;
}

Row measure(const families::Family& family, unsigned size, const Limits& limits) {
  Row row;
  row.size = size;
  const families::Bodies input = bodies(family, size, limits.turned);
  const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
  Clock clock;
  const polytope::Polytope a = polytope::convex_hull(placed.a.points()), b = polytope::convex_hull(placed.b.points());
  row.hulls = clock.lap();
  const gaussian::GaussianDiagram of_a = gaussian::gaussian_diagram_of_reflection(a),
                                  of_b = gaussian::gaussian_diagram(b);
  kernels::Context context;
  std::vector<chart::Charts> charts;
  for (const chart::Hemisphere h : chart::both_hemispheres)
    charts.push_back(chart::make_charts(context, of_a, of_b, chart::chart_frame(h)));
  row.charts = clock.lap();
  kernels::NearestPlanes start;
  for (const chart::Charts& c : charts) vertex_facet::offer(vertex_facet::vertex_facet_pairs(c), c, a, b, start);
  row.vertex_facets = clock.lap();
  std::vector<canonical::CanonicalSubsets> subsets;
  for (const chart::Charts& c : charts) subsets.push_back(canonical::canonical_subsets(context, c));
  row.canonical = clock.lap();
  for (const canonical::CanonicalSubsets& s : subsets) {
    const canonical::CanonicalSubsets::Sums sums = s.sums();
    row.crossings += sums.product;
    row.sum += sums.a + sums.b;
    row.canonical_pairs += s.size();
    for (std::size_t i = 0; i < s.size(); ++i) row.aghrs += std::pow(static_cast<double>(s[i].crossings()), 0.75);
    row.aghrs += static_cast<double>(sums.a + sums.b);
  }
  row.edges_a = a.edges.size();
  row.edges_b = b.edges.size();
  const lines::EdgeLinesOfA lines_a(a, placed.exponent());
  const lines::EdgeLinesOfB lines_b(b, placed.exponent());
  std::vector<lines::LineScene> scenes;
  for (const chart::Charts& c : charts) scenes.emplace_back(c, lines_a, lines_b);
  for (const ClosestLines engine : {ClosestLines::cutting, ClosestLines::sampled, ClosestLines::naive}) {
    if (engine == ClosestLines::naive && static_cast<double>(row.crossings) > limits.naive_crossings) continue;
    if (engine == ClosestLines::sampled && size > limits.sampled_size) continue;
    EngineRow& result = row.engines[static_cast<std::size_t>(engine)];
    for (int n = 0; n < limits.repeat; ++n) {
      kernels::NearestPlanes nearest = start;
      kernels::Context context;
      clock.lap();
      for (std::size_t i = 0; i < 2; ++i)
        lines::closest_lines(context, subsets[i], scenes[i], nearest, {.engine = engine});
      const double seconds = clock.lap(), least = n == 0 ? seconds : std::min(seconds, result.seconds);
      const Counters& counters = context.counters;
      result = {least, counters.cells, counters.block_tests, counters.pairs_evaluated, counters.pairs_exact};
    }
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  row.peak_megabytes = usage.ru_maxrss / 1024;
  return row;
}

// Measures in a child process.
bool measure_apart(const families::Family& family, unsigned size, const Limits& limits, Row& row) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  const pid_t child = fork();
  if (child == 0) {
    const Row result = measure(family, size, limits);
    _exit(write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
  }
  close(ends[1]);
  const bool read_all = read(ends[0], &row, sizeof row) == sizeof row;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return read_all;
}

void print(const Row& r) {
  std::printf("%8u %8llu %8llu %10.3g %9.3g %8llu %9.2e | %8.1f %8.1f %8.1f %8.1f |", r.size,
              static_cast<unsigned long long>(r.edges_a), static_cast<unsigned long long>(r.edges_b),
              static_cast<double>(r.crossings), static_cast<double>(r.sum),
              static_cast<unsigned long long>(r.canonical_pairs), r.aghrs, 1e3 * r.hulls, 1e3 * r.charts,
              1e3 * r.vertex_facets, 1e3 * r.canonical);
  for (const EngineRow& e : r.engines) {
    if (e.seconds < 0) {
      std::printf(" %9s %8s %8s %8s |", "-", "-", "-", "-");
    } else {
      std::printf(" %9.2f %8.2e %8.2e %8.2e |", 1e3 * e.seconds, e.work(), static_cast<double>(e.pairs),
                  static_cast<double>(e.exact));
    }
  }
  std::printf(" %6ld\n", r.peak_megabytes);
  std::fflush(stdout);
}

void print_exponents(const std::vector<Row>& rows) {
  const Row &first = rows.front(), &last = rows.back();
  if (rows.size() < 2) return;
  const double span = std::log(static_cast<double>(last.edges_a) / static_cast<double>(first.edges_a));
  const auto exponent = [&](double x, double y) { return std::log(y / x) / span; };
  std::printf("exponents: crossings %.2f, sum %.2f, AGHRS %.2f, canonical ms %.2f",
              exponent(first.crossings, last.crossings), exponent(first.sum, last.sum),
              exponent(first.aghrs, last.aghrs), exponent(first.canonical, last.canonical));
  for (std::size_t e = 0; e < 3; ++e) {
    const EngineRow &x = first.engines[e], &y = last.engines[e];
    if (x.seconds > 0 && y.seconds > 0) {
      constexpr const char* names[] = {"cutting", "sampled", "naive"};
      std::printf("; %s work %.2f, ms %.2f", names[e], exponent(x.work(), y.work()), exponent(x.seconds, y.seconds));
    }
  }
  std::printf("\n\n");
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  using namespace fathom;
  Limits limits;
  int i = 1;
  for (; i + 1 < argc && std::strncmp(argv[i], "--", 2) == 0; i += 2) {
    if (std::strcmp(argv[i], "--naive-up-to") == 0) limits.naive_crossings = std::atof(argv[i + 1]);
    if (std::strcmp(argv[i], "--sampled-up-to") == 0)
      limits.sampled_size = static_cast<unsigned>(std::atoi(argv[i + 1]));
    if (std::strcmp(argv[i], "--repeat") == 0) limits.repeat = std::max(1, std::atoi(argv[i + 1]));
    if (std::strcmp(argv[i], "--turned") == 0) limits.turned = std::atoi(argv[i + 1]) != 0;
  }
  while (i < argc) {
    const families::Family* family = families::find_family(argv[i]);
    if (family == nullptr) {
      std::fprintf(stderr, "unknown family '%s'\n", argv[i]);
      return 2;
    }
    std::printf("%s\n%8s %8s %8s %10s %9s %8s %9s | %8s %8s %8s %8s | %36s | %36s | %36s | %6s\n", argv[i], "size",
                "edges_a", "edges_b", "crossings", "sum", "pairs", "AGHRS", "hulls ms", "charts", "v-facet", "canon",
                "cutting: ms work pairs exact", "sampled: ms work pairs exact", "naive: ms work pairs exact", "MB");
    std::vector<Row> rows;
    for (++i; i < argc && std::atoi(argv[i]) > 0; ++i) {
      Row row;
      if (!measure_apart(*family, static_cast<unsigned>(std::atoi(argv[i])), limits, row)) {
        std::printf("%8s failed\n", argv[i]);
        continue;
      }
      print(row);
      rows.push_back(row);
    }
    if (!rows.empty()) print_exponents(rows);
  }
}
