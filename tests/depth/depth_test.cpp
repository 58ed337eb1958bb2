// SPDX-License-Identifier: GPL-3.0-or-later
// The exact method against its twins and against the independent oracles, by exact equality, over
// all families.
#include "fathom/depth.hpp"

#include <gtest/gtest.h>

#include "reference/canonical/canonical_subsets.hpp"
#include "reference/depth/naive.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "tests/oracles/brute_oracle.hpp"
#include "tests/oracles/cdd_oracle.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::depth {
namespace {

using oracles::answer_of;
using oracles::OracleAnswer;
using testing::check;
using testing::text;

Depth solve(const Case& input, const Options& options = {}) {
  return testing::exact_depth(input.a.points, input.b.points, options);
}

class EveryFamily : public ::testing::TestWithParam<families::Family> {};

TEST_P(EveryFamily, EqualsTheHullOfAllDifferencesAndObeysTheDefinitions) {
  for (const unsigned size : {1U, 5U, 11U}) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const Case input = GetParam().make(seed, size);
      const Depth depth = solve(input, {.validate = true});
      const Depth twin = fathom::penetration_depth(input.a.points, input.b.points, {.method = Method::naive});
      EXPECT_EQ(answer_of(depth), answer_of(twin)) << input.id;
      EXPECT_EQ(depth.optima(), twin.optima()) << input.id;
      const kernels::Report report = check(depth, input.a.points, input.b.points);
      EXPECT_TRUE(report.ok()) << input.id << "\n" << text(report);
    }
  }
}

// Topology is perturbed, values never are: the answer does not depend on how coincidences are
// resolved.
TEST_P(EveryFamily, DoesNotDependOnThePerturbation) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Case input = GetParam().make(seed, 9);
    const Depth depth = solve(input);
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    for (const kernels::Perturbation& perturbation : testing::perturbations()) {
      kernels::Context context;
      const Depth other = penetration_depth(context, placed, {.validate = true, .perturbation = perturbation});
      EXPECT_EQ(answer_of(other), answer_of(depth)) << input.id;
      EXPECT_EQ(other.optima(), depth.optima()) << input.id;
      EXPECT_EQ(other.witness(), depth.witness()) << input.id;
    }
  }
}

TEST_P(EveryFamily, EqualsTheQuadraticTwins) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const Case input = GetParam().make(seed, 14);
    const Depth depth = solve(input);
    if (depth.status() != Status::penetrating) continue;
    const auto p = testing::prepare(input);
    const kernels::NearestPlanes naive = nearest_facets_naive(p->a, p->b),
                                 scan = nearest_facets_scan(p->a, p->b, p->exponent);
    const std::vector<Vector> directions = answer_of(depth).directions;
    EXPECT_EQ(std::vector<Vector>(naive.directions().begin(), naive.directions().end()), directions) << input.id;
    EXPECT_EQ(std::vector<Vector>(scan.directions().begin(), scan.directions().end()), directions) << input.id;
  }
}

TEST_P(EveryFamily, EqualsTheIndependentOracles) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Case input = GetParam().make(seed, 6);
    if (input.a.points.size() > 12 || input.b.points.size() > 12) continue;
    const OracleAnswer mine = answer_of(solve(input));
    EXPECT_EQ(mine, oracles::cdd_oracle(input.a.points, input.b.points)) << input.id;
    if (input.a.points.size() * input.b.points.size() <= 80) {
      EXPECT_EQ(mine, oracles::brute_oracle(input.a.points, input.b.points)) << input.id;
    }
  }
}

std::vector<families::Family> all_families() { return {families::families().begin(), families::families().end()}; }

INSTANTIATE_TEST_SUITE_P(Depth, EveryFamily, ::testing::ValuesIn(all_families()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Depth, EmptyBodiesAreRefused) {
  const std::vector<Point> none, one{{0, 0, 0}};
  EXPECT_THROW(fathom::penetration_depth(none, one), std::invalid_argument);
  EXPECT_THROW(fathom::penetration_depth(one, none), std::invalid_argument);
}

TEST(Depth, UnitCubesAThirdDeep) {
  std::vector<Point> a, b;
  for (int i = 0; i < 8; ++i) {
    a.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
    b.push_back({(i & 1) + mpq_class(2, 3), i >> 1 & 1, i >> 2 & 1});
  }
  const Depth depth = testing::exact_depth(a, b);
  EXPECT_EQ(depth.status(), Status::penetrating);
  EXPECT_EQ(depth.squared(), mpq_class(1, 9));
  ASSERT_EQ(depth.optima().size(), 1U);
  EXPECT_EQ(depth.optima()[0].direction, (Vector{-1, 0, 0})) << "A has to move away from B";
  EXPECT_EQ(depth.optima()[0].translation(), (Point{mpq_class(-1, 3), 0, 0}));
  EXPECT_EQ(depth.optima()[0].contact, (Contact{ContactKind::facet_facet, {1, 3, 5, 7}, {0, 2, 4, 6}}));
}

TEST(Depth, AMonitorHearsOfProgressAndCanStopTheRun) {
  const Case input = families::find_family("random_sphere")->make(1, 60);
  testing::Recorder all;
  solve(input, {.monitor = &all});
  EXPECT_GE(all.stages.size(), 6U);
  for (const double share : all.shares) EXPECT_TRUE(share >= 0 && share <= 1) << share;
  for (std::size_t stop = 1; stop <= all.stages.size(); ++stop) {
    testing::Recorder some(stop);
    EXPECT_THROW(solve(input, {.monitor = &some}), Interrupted);
    EXPECT_EQ(some.stages.size(), stop);
  }
}

TEST(Depth, CountersAreThoseOfTheRun) {
  const Case input = families::find_family("random_sphere")->make(3, 30);
  const Depth first = solve(input), second = solve(input);
  EXPECT_EQ(first.counters.crossings, second.counters.crossings);
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    EXPECT_EQ(first.counters.predicates[i].calls, second.counters.predicates[i].calls) << predicate_names[i];
  }
  const auto p = testing::prepare(input);
  EXPECT_EQ(first.counters.edges_a, p->a.edges.size());
  EXPECT_EQ(first.counters.facets_b, p->b.facets.size());
  EXPECT_EQ(first.counters.vertex_facet_pairs, p->a.facets.size() + p->b.facets.size());
}

// Large enough for two threads: the same counts as one room after the other in one thread, and an
// interruption ends both.
TEST(Depth, TwoThreadsChangeNothing) {
  const Case input = families::find_family("random_sphere")->make(3, 1100);
  const Depth depth = solve(input);
  const auto p = testing::prepare(input);
  std::uint64_t crossings = 0;
  for (const chart::Charts& charts : p->charts)
    crossings += canonical::canonical_subsets(p->context, charts).sums().product;
  const PredicateCounts& alone = p->context.counters.predicates;
  EXPECT_EQ(depth.counters.crossings, crossings);
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    EXPECT_EQ(depth.counters.predicates[i].calls, alone[i].calls) << predicate_names[i];
    EXPECT_EQ(depth.counters.predicates[i].exact, alone[i].exact) << predicate_names[i];
    EXPECT_EQ(depth.counters.predicates[i].zero, alone[i].zero) << predicate_names[i];
    EXPECT_EQ(depth.counters.predicates[i].decided, alone[i].decided) << predicate_names[i];
  }
  // While both threads work there may be nothing to report, but whether to go on is asked.
  struct StopAfter final : Monitor {
    explicit StopAfter(int left) : left(left) {}
    void report(std::string_view stage, double) override { subsets = subsets || stage == "canonical subsets"; }
    bool stopped() override { return subsets && left-- <= 0; }
    int left;
    bool subsets = false;
  };
  for (const int left : {0, 3}) {
    StopAfter stop(left);
    EXPECT_THROW(solve(input, {.monitor = &stop}), Interrupted) << left;
    EXPECT_TRUE(stop.subsets);
  }
}

}  // namespace

}  // namespace fathom::depth

namespace fathom {
namespace families {
// For test names and failure messages.
void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }
}  // namespace families

}  // namespace fathom
