// SPDX-License-Identifier: GPL-3.0-or-later
// The expanding polytope against the hull of all differences.
#include "reference/expanding/expanding_polytope.hpp"

#include <gtest/gtest.h>

#include "kernels/number/rational.hpp"
#include "reference/depth/naive.hpp"
#include "tests/expanding/small_bodies.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::expanding {
namespace {

std::vector<Vector> directions(const kernels::NearestPlanes& nearest) {
  return {nearest.directions().begin(), nearest.directions().end()};
}

TEST(ExpandingPolytope, FindsTheNearestFacetsOfTheHullOfDifferences) {
  kernels::Context context;
  Random random(1);
  std::size_t penetrating = 0, ties = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::vector<Vector> a = small_body(random, 1 + i % 4), b = i % 3 == 0 ? a : small_body(random, 2 + i % 5);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    const Expansion expansion = nearest_by_expansion(context, clouds.a, clouds.b);
    ASSERT_EQ(expansion.end, naive.status == Status::penetrating ? ExpansionEnd::proved : ExpansionEnd::not_inside)
        << i;
    if (naive.status != Status::penetrating) continue;
    ++penetrating;
    ties += naive.directions.size() > 1 ? 1U : 0U;
    EXPECT_EQ(directions(expansion.nearest), naive.directions) << i;
    EXPECT_EQ(kernels::ratio(expansion.nearest.numerator(), expansion.nearest.denominator()), naive.squared) << i;
    expect_hull(expansion.inner, clouds.a, clouds.b);
  }
  EXPECT_GT(penetrating, 300U);
  EXPECT_GT(ties, 100U);
}

TEST(ExpandingPolytope, GrowsOnFamiliesToAHullThatHoldsTheBall) {
  kernels::Context context;
  for (const Case& input : testing::cases_of_all_families(2, 24)) {
    const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
    const Expansion expansion = nearest_by_expansion(context, clouds.a, clouds.b);
    if (expansion.end != ExpansionEnd::proved) continue;
    SCOPED_TRACE(input.id);
    expect_hull(expansion.inner, clouds.a, clouds.b);
    const kernels::Report report = validate(expansion, clouds.a, clouds.b);
    EXPECT_TRUE(report.ok()) << testing::text(report);
  }
}

TEST(ExpandingPolytope, ValidateSeesEachKindOfFault) {
  kernels::Context context;
  const Case input = families::find_family("crossed_fans")->make(1, 12);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  const Expansion right = nearest_by_expansion(context, clouds.a, clouds.b);
  ASSERT_TRUE(validate(right, clouds.a, clouds.b).ok());
  using Change = void (*)(Expansion&);
  const Change changes[] = {
      [](Expansion& e) { e.end = ExpansionEnd::spent; },
      [](Expansion& e) { e.nearest = {}; },
      [](Expansion& e) {
        e.nearest.offer({1, 2, 3}, 1);
      },
      [](Expansion& e) {
        const mpz_class numerator = e.nearest.numerator();
        e.nearest = {};
        e.nearest.offer({1, 0, 0}, numerator);
      },
      [](Expansion& e) { e.inner.facets.pop_back(); },
      [](Expansion& e) { e.inner.facets.push_back(e.inner.facets.front()); },
      [](Expansion& e) { std::reverse(e.inner.facets.front().begin(), e.inner.facets.front().end()); },
      [](Expansion& e) { e.inner.facets.front().pop_back(); },
      [](Expansion& e) { e.inner.facets.front().front() = 1000; },
      [](Expansion& e) { e.inner.vertices.front().second = 1000; },
      [](Expansion& e) { std::swap(e.inner.vertices[0], e.inner.vertices[1]); },
      [](Expansion& e) {
        e.inner.vertices.push_back({0, 0});
      },
  };
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    Expansion wrong = right;
    changes[i](wrong);
    EXPECT_FALSE(validate(wrong, clouds.a, clouds.b).ok()) << "change " << i;
  }
}

TEST(ExpandingPolytope, GivesUpAtItsBudgetAndAsksAtEachStepWhetherToGoOn) {
  const Case input = families::find_family("crossed_patch")->make(1, 20);
  const polytope::PlacedPair clouds = polytope::place(input.a.points, input.b.points);
  struct Steps final : Monitor {
    void report(std::string_view, double) override {}
    bool stopped() override { return ++asked > most; }
    std::size_t asked = 0, most = unlimited;
  } steps;
  kernels::Context context(&steps);
  const Expansion whole = nearest_by_expansion(context, clouds.a, clouds.b);
  ASSERT_EQ(whole.end, ExpansionEnd::proved);
  EXPECT_GE(steps.asked, whole.points);
  EXPECT_GT(whole.points, 50U);
  EXPECT_EQ(nearest_by_expansion(context, clouds.a, clouds.b, whole.points - 1).end, ExpansionEnd::spent);
  EXPECT_EQ(nearest_by_expansion(context, clouds.a, clouds.b, whole.points).end, ExpansionEnd::proved);
  steps = {};
  steps.most = whole.points / 2;
  EXPECT_THROW(nearest_by_expansion(context, clouds.a, clouds.b), Interrupted);
  EXPECT_EQ(steps.asked, steps.most + 1);
}

TEST(ExpandingPolytope, ABallIsHeldExactlyIfItFits) {
  kernels::Context context;
  Random random(3);
  for (int i = 0; i < 400; ++i) {
    const std::vector<Vector> a = small_body(random, 3), b = small_body(random, 4);
    const polytope::PlacedPair clouds = polytope::place_integers(a, b);
    const depth::NaiveDepth naive = depth::naive_depth(a, b);
    if (naive.status != Status::penetrating) continue;
    const mpq_class little(1, 1000), q = naive.squared;
    for (const mpq_class& low : {mpq_class(0), mpq_class(q / 2), q, mpq_class(q * (1 + little))}) {
      for (const mpq_class& high : {mpq_class(q * (1 - little)), q, mpq_class(q * 3)}) {
        const BallExpansion ball = expand_to_ball(context, clouds.a, clouds.b, low, high);
        ASSERT_EQ(ball.end, ExpansionEnd::proved);
        EXPECT_EQ(ball.low_holds, low <= q);
        EXPECT_EQ(ball.high_holds, high >= q);
        if (ball.low_holds) expect_hull(ball.inner, clouds.a, clouds.b);
      }
    }
    const Vector& n = naive.directions.front();
    EXPECT_EQ(expand_to_ball(context, clouds.a, clouds.b, 0, q, n).direction, n) << "the hint is used";
    EXPECT_EQ(expand_to_ball(context, clouds.a, clouds.b, 0, q, Vector{0, 0, 0}).high_holds, true)
        << "a useless hint does no harm";
  }
}

TEST(ExpandingPolytope, RefusesCloudsThatDoNotBelongTogether) {
  kernels::Context context;
  const kernels::PointCloud none, one({{1, 2, 3}}), fine({{1, 2, 3}}, 10);
  EXPECT_THROW(nearest_by_expansion(context, none, one), std::invalid_argument);
  EXPECT_THROW(nearest_by_expansion(context, one, fine), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::expanding
