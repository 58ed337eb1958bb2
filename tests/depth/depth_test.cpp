// SPDX-License-Identifier: GPL-3.0-or-later
// The exact method against its twins and against the independent oracles, by exact equality, over
// all families.

#include "fathom/depth.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "reference/canonical/canonical_subsets.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "tests/oracles/brute_oracle.hpp"
#include "tests/oracles/cdd_oracle.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/families.hpp"
#include "verify/families/solids.hpp"

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

// In binary64 by integers, else in rationals.
TEST(Depth, TheWitnessOfCrossingEdgesDoesNotDependOnTheirForm) {
  std::mt19937_64 random(3);
  const auto number = [&random] {
    const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random()) >> 11);
    return random() % 8 == 0 ? 0.0 : std::ldexp(mantissa, -static_cast<int>(random() % 90));
  };
  for (int run = 0; run < 500; ++run) {
    Penetration given, exact;
    CrossingEdges edges, exact_edges;
    const auto end = [&](GivenPoint& one, GivenPoint& other) {
      one = {std::array{number(), number(), number()}};
      other = {one.exact()};
    };
    for (std::size_t i = 0; i < 2; ++i) end(edges.a[i], exact_edges.a[i]), end(edges.b[i], exact_edges.b[i]);
    const Vector n =
        primitive_along(cross(edges.a[1].exact() - edges.a[0].exact(), edges.b[1].exact() - edges.b[0].exact()));
    if (is_zero(n)) continue;
    const Optimum optimum{n, dot(n, edges.b[0].exact() - edges.a[0].exact()), {}};
    given.optima = exact.optima = {optimum};
    given.meeting = edges, exact.meeting = exact_edges;
    const Witness witness = given.witness();
    EXPECT_EQ(witness, exact.witness());
    EXPECT_EQ(witness.b - witness.a, optimum.translation());
    const auto on_line = [](const Point& p, const std::array<GivenPoint, 2>& edge) {
      const Point start = edge[0].exact();
      return cross(p - start, edge[1].exact() - start) == Point{};
    };
    EXPECT_TRUE(on_line(witness.a, edges.a) && on_line(witness.b, edges.b));
  }
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

// The stages that are kept belong to the answer, and they are there for bodies that do not
// penetrate too.

namespace fathom::depth {
namespace {

TEST(ExactStages, AreThoseOfTheAnswer) {
  std::vector<Case> cases = testing::cases_of_all_families(1, 16);
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t apart = 0;
  for (const Case& input : cases) {
    const polytope::PlacedPair pair = polytope::place(input.a.points, input.b.points);
    kernels::Context of_answer, of_stages;
    const Depth answer = penetration_depth(of_answer, pair);
    const std::unique_ptr<ExactStages> stages = exact_stages(of_stages, pair);
    EXPECT_EQ(stages->depth.status(), answer.status()) << input.id;
    EXPECT_EQ(stages->depth.optima(), answer.optima()) << input.id;
    EXPECT_EQ(stages->depth.counters.crossings, answer.counters.crossings) << input.id;
    EXPECT_EQ(stages->depth.counters.pairs_evaluated, answer.counters.pairs_evaluated) << input.id;
    EXPECT_EQ(stages->depth.counters.vertices_a, answer.counters.vertices_a) << input.id;
    EXPECT_EQ(stages->charts[0].of.a.diagram, &stages->diagrams.a) << input.id;
    std::uint64_t crossings = 0;
    for (std::size_t h = 0; h < 2; ++h) {
      EXPECT_EQ(testing::text(chart::validate(stages->charts[h])), "") << input.id;
      EXPECT_EQ(testing::text(canonical::validate(stages->subsets[h], stages->charts[h])), "") << input.id;
      EXPECT_EQ(stages->traces[h].pairs.size(), answer.penetration() ? stages->subsets[h].size() : 0) << input.id;
      crossings += stages->subsets[h].sums().product;
    }
    if (answer.penetration()) {
      EXPECT_EQ(crossings, answer.counters.crossings) << input.id;
      EXPECT_FALSE(stages->of_facets.directions().empty() &&
                   stages->hulls.a.facets.size() + stages->hulls.b.facets.size() > 0)
          << input.id;
    } else {
      EXPECT_EQ(answer.counters.crossings, 0U) << input.id;
      ++apart;
    }
  }
  EXPECT_GT(apart, 20U);
}

TEST(Stages, GoOnOnlyWhileLawsHoldIfThatIsAskedFor) {
  struct Count {
    int made = 0;
  };
  const auto make = [](kernels::Context&, Count& count) { ++count.made; };
  const auto insist = [](const Count& count) {
    if (count.made == 2) throw std::logic_error("broken law");
  };
  const Stage<Count> stages[] = {{make, nullptr}, {make, insist}, {make, insist}};
  kernels::Context context;
  Count looked_at, trusted;
  EXPECT_THROW(run_stages<Count>(context, looked_at, stages, true), std::logic_error);
  EXPECT_EQ(looked_at.made, 2);
  run_stages<Count>(context, trusted, stages, false);
  EXPECT_EQ(trusted.made, 3);
}

// The next nearest facet plane against the hull of all differences.

Depth solved(const Body& a, const Body& b) { return fathom::penetration_depth(a.points, b.points); }

/// Whether the bodies penetrate; then both ways must agree.
bool agrees(const Body& a, const Body& b) {
  const Depth depth = solved(a, b);
  if (depth.status() != Status::penetrating) {
    EXPECT_THROW((void)second_nearest_squared_naive(a.points, b.points), std::invalid_argument);
    return false;
  }
  const std::optional<mpq_class> second = second_nearest_squared(a.points, b.points, *depth.penetration());
  EXPECT_EQ(second, second_nearest_squared_naive(a.points, b.points));
  EXPECT_TRUE(!second || *second > depth.squared());
  return true;
}

TEST(Gap, IsThatOfTheHullOfDifferencesOnSmallLattices) {
  std::mt19937_64 random(5);
  const auto body = [&random](long reach) {
    Body result;
    for (std::size_t n = 1 + random() % 9; n > 0; --n) {
      const auto coordinate = [&] {
        return mpq_class(static_cast<long>(random() % static_cast<unsigned long>(2 * reach + 1)) - reach, 2);
      };
      Point p{coordinate(), coordinate(), coordinate()};
      for (mpq_class* x : {&p.x, &p.y, &p.z}) x->canonicalize();
      result.points.push_back(p);
    }
    return result;
  };
  std::size_t penetrating = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Body a = body(1 + i % 5), b = i % 4 == 0 ? a : body(2 + i % 7);
    penetrating += agrees(a, b) ? 1U : 0U;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(penetrating, 500U);
}

TEST(Gap, IsThatOfTheHullOfDifferencesOnFamilies) {
  std::vector<Case> cases = testing::cases_of_all_families(3, 8);
  for (const families::Family& family : families::families()) cases.push_back(family.make(5, 22));
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  std::size_t penetrating = 0;
  for (const Case& input : cases) {
    SCOPED_TRACE(input.id);
    penetrating += agrees(input.a, input.b) ? 1U : 0U;
  }
  EXPECT_GT(penetrating, 200U);
}

TEST(Gap, IsNothingWhereAllFacetsTie) {
  for (const Body& body : {families::cube(), families::tetrahedron(), families::box(1, 1, 1)}) {
    const Depth depth = solved(body, Body{{{0, 0, 0}}});
    EXPECT_GE(depth.optima().size(), 4U);
    EXPECT_FALSE(second_nearest_squared(body.points, std::vector<Point>{{0, 0, 0}}, *depth.penetration()));
  }
}

// P is a box: every facet holds the foot point of O.
TEST(Gap, IsFoundOnTheOtherSide) {
  const Body a = families::box(1, 2, 3), b = families::translated(a, {0, 0, families::ratio(9, 2)});
  const Depth depth = solved(a, b);
  EXPECT_EQ(depth.squared(), families::ratio(9, 4));
  EXPECT_EQ(second_nearest_squared(a.points, b.points, *depth.penetration()), mpq_class(4));
}

// Two facets tie, and the next one leans against the second of them; around the first all are far.
TEST(Gap, IsSoughtAroundEveryOptimum) {
  const Body b{{{-1, -3, 1}, {-1, 3, -2}, {1, -1, 3}, {-1, -1, -2}, {1, 2, -3}}}, origin{{{0, 0, 0}}};
  const Depth depth = solved(origin, b);
  EXPECT_EQ(depth.optima().size(), 2U);
  EXPECT_EQ(second_nearest_squared(origin.points, b.points, *depth.penetration()), families::ratio(49, 101));
  EXPECT_TRUE(agrees(origin, b));
}

// The next facet leans against the nearest one so closely that its foot point lies far outside it,
// and other facets are far away.
TEST(Gap, IsFoundBehindAnEdge) {
  Body roof = families::box(9, 9, 9);
  roof.points.push_back({0, 0, families::ratio(901, 100)});
  const Body a{{{0, 0, -families::ratio(89, 10)}}};  // O near the floor of P: the four sides of the roof are far
  EXPECT_TRUE(agrees(a, roof));
  const Body wedge{{{-9, -9, 1},
                    {-9, 9, 1},
                    {9, -9, 1},
                    {9, 9, 1},
                    {-9, -99, 0},
                    {-9, 99, 0},
                    {9, -99, 0},
                    {9, 99, 0},
                    {0, 0, -99}}};
  EXPECT_TRUE(agrees(Body{{{0, 0, 0}}}, families::translated(wedge, {0, 0, families::ratio(-1, 2)})));
}

}  // namespace
}  // namespace fathom::depth
