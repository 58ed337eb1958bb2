// SPDX-License-Identifier: GPL-3.0-or-later
// Policies, units, precisions, and the way out along a ray. What is found about distances, claim
// classes and contacts is in rows of tests/data/judged.jsonl.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fathom/approximate.hpp"
#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "tests/support/prepared.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/scene.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::judging {
namespace {

using testing::box;
using testing::cube;
using testing::cubes;
using testing::Findings;
using testing::findings;
using testing::overlap;
using testing::up;

Tolerance by(const char* policy) {
  Tolerance tolerance;
  tolerance.policy = *policy_of(policy);
  return tolerance;
}

// The depth is 0.6; along z it costs 1, which is 2/3 more.
TEST(Judge, OnTheBorderOfAPolicyAnAnswerPasses) {
  EXPECT_EQ(findings(cubes(), overlap(1, up), {}, by("within=200/3%")), Findings{});
  EXPECT_EQ(findings(cubes(), overlap(1, up), {}, by("within=66.6666666666666666666666666666%")),
            Findings{Verdict::too_deep});
}

TEST(Policies, AndTheirWords) {
  for (const char* text : {"declared", "minimum", "separating", "within=5%", "within=0%", "within=5/2%"}) {
    ASSERT_TRUE(policy_of(text)) << text;
    EXPECT_EQ(policy_text(*policy_of(text)), text);
  }
  EXPECT_EQ(policy_of("within=2.5%"), (Policy{Policy::Kind::within, mpq_class(1, 40)}));
  for (const char* text : {"", "within", "within=5", "within=-1%", "within=%", "within=nan%", "manifold", "Minimum"})
    EXPECT_FALSE(policy_of(text)) << text;
}

// Distances, claim classes and contacts of shapes, on pairs whose answers have a closed form.

// Judged in the unit of the bodies, an answer of another unit is what it is there; and the
// precision of points is not that of answers.

const std::vector<Point> a = cube(0), b = box({mpq_class(1, 3), mpq_class(-1, 7), 0}, {2, 1, mpq_class(9, 7)});

/// Right and wrong ones about the bodies times 2^exponent, rounded to the precision.
std::vector<Reply> replies(long exponent, Precision precision) {
  std::vector<Reply> result;
  for (const double factor : {1.0, 1 + 0x1p-52, 1 + 0x1p-23, 1.0001, 1.5, 0.5, -1.0}) {
    const mpq_class depth = scaled(mpq_class(2, 3), exponent) * exact_value(factor);
    Reply reply = testing::overlap(precision == Precision::binary32 ? round_binary32(depth) : round_binary64(depth),
                                   Triple{-1, 0, 0});
    reply.witness_a = {round_binary64(scaled(1, exponent)), 0, 0};
    reply.witness_b = {round_binary64(scaled(mpq_class(1, 3), exponent)), 0, 0};
    result.push_back(reply);
  }
  return result;
}

TEST(NumberFormat, AnotherUnitChangesNoVerdict) {
  for (const Precision precision : {Precision::binary32, Precision::binary64})
    for (const long exponent : {-140L, -130L, -7L, 6L, 100L}) {
      const Truth here = truth_about(a, b);
      const Truth there = truth_about(scaled(GivenPoints(a), exponent), scaled(GivenPoints(b), exponent));
      for (const Tolerance& tolerance : {Tolerance{}, Tolerance{0, 0, 0}, Tolerance{0, 0, 2}})
        for (const Reply& reply : replies(exponent, precision)) {
          const Judgement found = judge(here, reply, {}, {precision, precision, exponent}, tolerance);
          const Judgement expected = judge(there, reply, {}, precision, tolerance);
          EXPECT_EQ(found.findings, expected.findings) << found.sentence << " / " << expected.sentence;
          EXPECT_EQ(found.accuracy, expected.accuracy) << exponent;
          EXPECT_EQ(found.error_ulps, expected.error_ulps);
          EXPECT_EQ(found.error_u_r, expected.error_u_r);
          EXPECT_EQ(*found.witness_a_squared, scaled(*expected.witness_a_squared, -2 * exponent));
          EXPECT_EQ(*found.separating_distance_squared, scaled(*expected.separating_distance_squared, -2 * exponent));
          EXPECT_EQ(found.depth_squared, mpq_class(4, 9));
        }
    }
}

TEST(NumberFormat, ShapesAreJudgedSoToo) {
  const auto ball = [](long exponent) { return sphere(scaled(mpq_class(1, 3), exponent)); };
  for (const long exponent : {-140L, 9L}) {
    const ShapeTruth here = truth_about(hull(a), ball(0)),
                     there = truth_about(hull(scaled(GivenPoints(a), exponent).exact()), ball(exponent));
    for (const Tolerance& tolerance : {Tolerance{}, Tolerance{0, 0, 0}})
      for (Reply reply : replies(exponent, Precision::binary32)) {
        *reply.depth /= 2;  // of 1/3
        const Judgement found = judge(here, reply, {}, {Precision::binary32, Precision::binary32, exponent}, tolerance);
        const Judgement expected = judge(there, reply, {}, Precision::binary32, tolerance);
        EXPECT_EQ(found.findings, expected.findings) << found.sentence << " / " << expected.sentence;
        EXPECT_EQ(found.accuracy, expected.accuracy);
        EXPECT_EQ(found.error_ulps, expected.error_ulps);
      }
  }
}

TEST(NumberFormat, PointsAreRoundedInTheirUnit) {
  const GivenPoints tenth{{mpq_class(1, 10), 0, 0}};
  EXPECT_EQ(seen(tenth, Precision::binary32)->front().x, exact_value(0.1F));
  EXPECT_EQ(seen(tenth, {Precision::binary32, Precision::binary64, 40})->front().x, exact_value(0.1F))
      << "no digit is lost or won";
  const GivenPoints least{{scaled(mpq_class(3, 7), -1200), 0, 0}};
  EXPECT_EQ(seen(least, Precision::binary64)->front().x, 0);
  EXPECT_EQ(seen(least, {Precision::binary32, Precision::binary32, 1200})->front().x,
            scaled(exact_value(3.0F / 7), -1200));
  EXPECT_FALSE(seen(least, {Precision::binary32, Precision::binary32, 1500})) << "it overflows there";
}

TEST(NumberFormat, UlpsAreThoseOfAnswers) {
  const NumberFormat format{Precision::binary32, Precision::binary64};
  EXPECT_EQ(ulp_at_root(1, format), scaled(1, -52));
  EXPECT_EQ(ulp_at_root(1, {Precision::binary64, Precision::binary32}), scaled(1, -23));
  EXPECT_EQ(ulp_at_root(0, {Precision::binary64, Precision::binary32, 10}), scaled(1, -159));
  Reply reply = testing::overlap(0.75, Triple{-1, 0, 0});
  const Judgement judgement = judge(truth_about(cube(0), box({mpq_class(1, 2), 0, 0}, {2, 1, 1})), reply, {}, format);
  EXPECT_EQ(judgement.error_ulps, 0x1p51) << "ulps of binary64 at 1/2";
  EXPECT_EQ(judgement.error_u_r, 0x1p21) << "u of binary32, R = 2";
}

// The ray that starts from a certificate, against the ray through hulls and hierarchies.

TEST(WayOut, EqualsTheDirectionalDepthOnEveryFamily) {
  std::size_t rays = 0, given_up = 0;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    const Depth depth = penetration_depth(a, b, {.method = Method::certificate});
    if (!depth.penetration()) continue;
    const InnerPolytope& inner = depth.penetration()->inner.value();
    const polytope::PlacedPair placed = polytope::place(a, b);
    std::vector<Vector> directions{{1, 0, 0}, {0, -1, 0}, {1, 1, 1}, {3, -2, 1}, {1, 0, 1000000}};
    for (const Optimum& optimum : depth.optima()) directions.push_back(optimum.direction);
    for (const auto& [i, j] : inner.vertices) directions.push_back(placed.b[j] - placed.a[i]);
    if (directions.size() > 12) directions.resize(12);
    for (const Vector& u : directions) {
      ++rays;
      const DirectionalDepth expected = directional_depth(a, b, {u.x, u.y, u.z});
      const std::optional<mpq_class> found = way_out(placed, inner, u);
      if (found) EXPECT_EQ(*found / placed.denominator, expected.factor()) << input.id;
      else ++given_up;
    }
  }
  EXPECT_GT(rays, 300U);
  EXPECT_EQ(given_up, 0U);
}

TEST(WayOut, MayRunOutOfPatience) {
  const Case input = families::find_family("random_sphere")->make(1, 30);
  const Depth depth = penetration_depth(input.a.points, input.b.points, {.method = Method::certificate});
  const InnerPolytope& inner = depth.penetration()->inner.value();
  EXPECT_FALSE(way_out(polytope::place(input.a.points, input.b.points), inner, {1, 2, 3}, 0));
}

}  // namespace
}  // namespace fathom::judging
