// SPDX-License-Identifier: GPL-3.0-or-later
// Distances, claim classes, policies and contacts, on pairs whose answers one can see.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fathom/approximate.hpp"
#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "tests/judge/shape_pairs.hpp"
#include "tests/support/prepared.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/scene.hpp"
#include "verify/judge/words.hpp"

namespace fathom::judging {
namespace {

using testing::apart;
using testing::at;
using testing::balls;
using testing::box;
using testing::cube;
using testing::cubes;
using testing::cylinders;
using testing::diagonal;
using testing::disjoint_cubes;
using testing::down;
using testing::Findings;
using testing::findings;
using testing::left;
using testing::nan;
using testing::none;
using testing::overlap;
using testing::right;
using testing::touching_cubes;
using testing::up;
using testing::with_witness;

// 1/2 apart along x.
TEST(Judge, Distances) {
  const Truth& cubes = disjoint_cubes();
  EXPECT_EQ(findings(cubes, apart(0.5)), Findings{});
  EXPECT_EQ(findings(cubes, apart(0.5004)), Findings{});
  EXPECT_EQ(findings(cubes, apart(0.5006)), Findings{Verdict::too_far});
  EXPECT_EQ(findings(cubes, apart(0.4996)), Findings{});
  EXPECT_EQ(findings(cubes, apart(0.4994)), Findings{Verdict::too_near});
  EXPECT_EQ(findings(cubes, apart(0)), Findings{Verdict::too_near});
  EXPECT_EQ(findings(cubes, apart(-0.5)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(cubes, apart(-0.25)), Findings{Verdict::too_near});
  EXPECT_EQ(findings(cubes, apart(nan)), Findings{Verdict::nan});
  EXPECT_EQ(findings(testing::cubes(), apart(0.5)), (Findings{Verdict::false_separation, Verdict::too_far}));
  EXPECT_EQ(findings(touching_cubes(), apart(0)), Findings{});
  EXPECT_EQ(findings(touching_cubes(), apart(0.1)), Findings{Verdict::too_far});
  const Judgement result = judge(cubes, apart(0.75, left));
  EXPECT_EQ(result.sentence,
            "too far by 0.25: 0.75 is claimed, the distance is 0.5; inconsistent: the gap across its direction is 0.5, "
            "not 0.75");
  EXPECT_EQ(result.error, 0.25);
  EXPECT_EQ(result.error_relative, 0.5);
  EXPECT_EQ(result.distance_squared, mpq_class(1, 4));
  EXPECT_EQ(result.separating_distance_squared, mpq_class(-1, 4));
  EXPECT_EQ(result.inconsistency, -0.25);
  EXPECT_FALSE(result.overlap_left);
  EXPECT_EQ(judge(cubes, apart(0.5)).accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(judge(cubes, apart(std::nextafter(0.5, 1))).accuracy, Accuracy::ulps_4);
  Conventions negative;
  negative.depth = Conventions::Sign::negative;
  EXPECT_EQ(findings(cubes, apart(0.5, left), negative), Findings{}) << "a distance has no sign to declare";
}

// The direction leads the body that moves farther away; what leads nearer, or aside, has another
// gap.
TEST(Judge, DirectionsBesideADistance) {
  const Truth& cubes = disjoint_cubes();
  Conventions b;
  b.moves = Conventions::Body::b;
  EXPECT_EQ(findings(cubes, apart(0.5, left)), Findings{});
  EXPECT_EQ(findings(cubes, apart(0.5, right)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(cubes, apart(0.5, right), b), Findings{});
  EXPECT_EQ(findings(cubes, apart(0.5, up)), Findings{Verdict::inconsistent});
  EXPECT_EQ(judge(cubes, apart(0.5, up)).sentence, "inconsistent: no plane across its direction separates the bodies");
  EXPECT_EQ(findings(cubes, apart(0.5, Triple{0, 0, 0})), Findings{Verdict::not_a_direction});
  EXPECT_EQ(findings(cubes, apart(0.5, Triple{nan, 0, 0})), Findings{Verdict::nan});
}

TEST(Judge, WitnessPointsBesideADistanceAreNearestPoints) {
  const Truth& cubes = disjoint_cubes();
  const Triple a{1, 0.5, 0.5}, b{1.5, 0.5, 0.5}, aside{1.5, 1, 0.5}, beyond{1.25, 0.5, 0.5};
  EXPECT_EQ(findings(cubes, with_witness(apart(0.5), a, b)), Findings{});
  EXPECT_EQ(findings(cubes, with_witness(apart(0.5, left), a, b)), Findings{});
  EXPECT_EQ(findings(cubes, with_witness(apart(0.5), a, aside)), Findings{Verdict::witness_off});
  EXPECT_EQ(findings(cubes, with_witness(apart(0.5), beyond, b)), Findings{Verdict::witness_off});
  EXPECT_EQ(judge(cubes, with_witness(apart(0.5, left), b, a)).sentence,
            "the witness point of A is 0.5 away from it; the witness point of B is 0.5 away from it; the witness "
            "points miss the distance by 1");
  EXPECT_EQ(judge(cubes, with_witness(apart(0.5), a, b)).witness_gap, 0);
}

TEST(Judge, WithoutADistanceAnAnswerApartIsItsClassificationAlone) {
  Reply reply = with_witness({}, Triple{9, 9, 9}, Triple{nan, 0, 0});
  reply.direction = Triple{0, 0, 0};
  reply.depth = 17;
  const Judgement result = judge(disjoint_cubes(), reply);
  EXPECT_EQ(result.verdict, Verdict::pass);
  EXPECT_EQ(result.sentence, "right: the bodies are apart by 0.5");
  EXPECT_FALSE(result.separating_distance_squared || result.witness_a_squared || result.witness_gap || result.error ||
               result.accuracy);
}

Tolerance by(const char* policy) {
  Tolerance tolerance;
  tolerance.policy = *policy_of(policy);
  return tolerance;
}

// The depth is 0.6; along z it costs 1, which is 2/3 more.
TEST(Judge, ASeparatingClaimIsHeldToItsOwnSeparatingDistance) {
  Conventions separating;
  separating.claims = Conventions::Claims::separating;
  const auto found = [&](const Reply& reply) { return findings(cubes(), reply, separating); };
  EXPECT_EQ(found(overlap(1, up)), Findings{});
  EXPECT_EQ(found(overlap(0.6, left)), Findings{});
  EXPECT_EQ(found(overlap(1.2, up)), (Findings{Verdict::too_deep, Verdict::inconsistent}));
  EXPECT_EQ(found(overlap(0.8, up)), (Findings{Verdict::too_deep, Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_EQ(found(overlap(0.5, left)),
            (Findings{Verdict::too_shallow, Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_EQ(found(overlap(1)), Findings{Verdict::too_deep}) << "without a direction there is nothing to separate along";
  const Judgement result = judge(cubes(), overlap(1, up), separating);
  EXPECT_TRUE(result.excess_allowed);
  EXPECT_FALSE(result.accuracy);
  EXPECT_EQ(result.relative_excess, kernels::nearest_binary64({-1, mpq_class(25, 9)}));
  EXPECT_EQ(result.sentence,
            "separating: 1 is claimed, the separating distance of its direction; the depth is 0.6, that distance is "
            "66.67 % more");
  const Judgement shortest = judge(cubes(), overlap(0.6, left), separating);
  EXPECT_FALSE(shortest.excess_allowed);
  EXPECT_EQ(shortest.relative_excess, 0);
  EXPECT_EQ(shortest.accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(findings(touching_cubes(), overlap(1, up), separating), Findings{});
  EXPECT_EQ(findings(disjoint_cubes(), overlap(1, up), separating), Findings{Verdict::false_overlap});
}

TEST(Judge, APolicyOverrulesWhatIsDeclared) {
  Conventions separating;
  separating.claims = Conventions::Claims::separating;
  const auto verdict = [&](const Reply& reply, const char* policy, const Conventions& conventions = {}) {
    return judge(cubes(), reply, conventions, Precision::binary64, by(policy)).verdict;
  };
  const Reply reply = overlap(1, up);
  EXPECT_EQ(verdict(reply, "declared"), Verdict::too_deep);
  EXPECT_EQ(verdict(reply, "minimum", separating), Verdict::too_deep);
  EXPECT_EQ(verdict(reply, "declared", separating), Verdict::pass);
  EXPECT_EQ(verdict(reply, "separating"), Verdict::pass);
  EXPECT_EQ(verdict(reply, "within=66%"), Verdict::too_deep);
  EXPECT_EQ(verdict(reply, "within=66%", separating), Verdict::too_deep);
  EXPECT_EQ(verdict(reply, "within=67%"), Verdict::pass);
  EXPECT_EQ(verdict(reply, "within=200/3%"), Verdict::pass) << "on the border";
  EXPECT_EQ(verdict(reply, "within=66.6666666666666666666666666666%"), Verdict::too_deep);
  EXPECT_EQ(verdict(overlap(0.7, left), "within=67%"), Verdict::too_deep)
      << "its direction has another separating distance";
  EXPECT_EQ(verdict(overlap(0.6, up), "within=67%"), Verdict::not_separating);
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

// Both bodies meet in x from 0.4 to 1.
TEST(Judge, ContactsLieInBothBodies) {
  const auto at = [](double x) {
    Reply reply = overlap(0.6, left);
    reply.contacts = {{{0.5, 0.5, 0.5}, {}}, {{x, 0.5, 0.5}, {}}};
    return reply;
  };
  EXPECT_EQ(findings(cubes(), at(0.7)), Findings{});
  EXPECT_EQ(findings(cubes(), at(0.4)), Findings{});
  EXPECT_EQ(findings(cubes(), at(1.0006)), Findings{}) << "within the tolerance";
  EXPECT_EQ(findings(cubes(), at(1.0007)), Findings{Verdict::witness_off});
  EXPECT_EQ(findings(cubes(), at(nan)), Findings{Verdict::nan});
  EXPECT_EQ(judge(cubes(), at(nan)).sentence, "a contact is not finite");
  const Judgement result = judge(cubes(), at(0.25));
  EXPECT_EQ(result.sentence, "a contact is 0.15 away from B");
  EXPECT_EQ(result.contact_a_squared, 0);
  EXPECT_EQ(result.contact_b_squared, mpq_class(9, 400));
  Reply both = at(1.25);
  both.contacts.front().position[0] = 0.25;
  EXPECT_EQ(judge(cubes(), both).sentence, "a contact is 0.25 away from A; a contact is 0.15 away from B")
      << "each the farthest";
  Reply to_come = at(1.25);
  to_come.contacts[0].depth = 0.6;
  to_come.contacts[1].depth = -0.24;
  EXPECT_EQ(findings(cubes(), to_come), (Findings{Verdict::witness_off, Verdict::contact_too_shallow}));
  Reply others = to_come;
  others.contacts[1].depth = -0.25;
  others.contacts.push_back({{1.125, 0.5, 0.5}, {}});
  EXPECT_EQ(judge(cubes(), others).sentence.substr(0, 30), "a contact is 0.125 away from A") << "the one that is off";
  to_come.contacts[1].depth = -0.2495;
  EXPECT_EQ(findings(cubes(), to_come), Findings{Verdict::contact_too_shallow})
      << "where a gap is claimed it may lie in that; but there is none";
  Reply alone = at(9);
  alone.depth.reset();
  EXPECT_EQ(findings(cubes(), alone), Findings{}) << "without a depth they are not read";
  Reply separate = at(9);
  separate.overlap = false;
  separate.distance = 0;
  EXPECT_EQ(findings(touching_cubes(), separate), Findings{}) << "nor beside a distance";
}

// Of several contacts the deepest one has the depth of the whole. These all lie on one line, along
// which the cubes overlap by 0.6.
TEST(Judge, ContactsAreAsDeepAsTheAnswer) {
  const auto with = [](double depth, std::vector<std::optional<double>> depths) {
    Reply reply = overlap(depth, left);
    for (const std::optional<double>& each : depths) reply.contacts.push_back({{0.5, 0.5, 0.5}, each});
    return reply;
  };
  const Findings shallow{Verdict::contact_too_shallow}, differs{Verdict::inconsistent, Verdict::contact_too_shallow};
  EXPECT_EQ(findings(cubes(), with(0.6, {0.6, 0.1, {}})), shallow);
  EXPECT_EQ(findings(cubes(), with(0.6, {{}, 0.6005})), Findings{}) << "within the tolerance";
  EXPECT_EQ(findings(cubes(), with(0.6, {0.1, 0.607})),
            (Findings{Verdict::inconsistent, Verdict::contact_too_deep, Verdict::contact_too_shallow}));
  EXPECT_EQ(findings(cubes(), with(0.6, {0.5, -1})), differs);
  EXPECT_EQ(findings(cubes(), with(0.6, {{}, {}})), Findings{}) << "where none has a depth";
  EXPECT_EQ(findings(cubes(), with(0.6, {0.6, nan})), Findings{Verdict::nan});
  const Judgement result = judge(cubes(), with(0.75, {0.5, 0.25}));
  EXPECT_EQ(result.sentence,
            "too deep by 0.15: 0.75 is claimed, the depth is 0.6; inconsistent: the plane across its direction is at "
            "0.6, not at 0.75, the "
            "depth of the deepest contact differs by 0.25; contact 0 is too shallow: 0.5 is claimed, along the lines "
            "near it the bodies overlap by 0.6 at least, and 1 more is so");
  EXPECT_EQ(result.deepest, -0.25);
  Conventions negative;
  negative.depth = Conventions::Sign::negative;
  EXPECT_EQ(findings(cubes(), with(-0.6, {-0.1, -0.6}), negative), shallow);
  EXPECT_EQ(findings(cubes(), with(-0.6, {-0.1, 0.6}), negative), differs);
  EXPECT_EQ(findings(cubes(), with(-0.6, {-0.6})), Findings{Verdict::wrong_sign}) << "one slip, not two";
}

// Distances, claim classes and contacts of shapes, on pairs whose answers have a closed form.

// The depth of two unit balls, centres 3/2 apart, is 1/2; along y the plane is at 2.
TEST(JudgeShapes, ASeparatingClaimIsHeldToItsOwnSeparatingDistance) {
  Conventions separating;
  separating.claims = Conventions::Claims::separating;
  const ShapeTruth truth = balls();
  EXPECT_EQ(findings(truth, overlap(2, up)), Findings{Verdict::too_deep});
  EXPECT_EQ(findings(truth, overlap(2, up), separating), Findings{});
  EXPECT_EQ(findings(truth, overlap(1, up), separating),
            (Findings{Verdict::too_deep, Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_EQ(judge(truth, overlap(2, up), separating).relative_excess, 3);
  Tolerance within;
  within.policy = *policy_of("within=300%");
  EXPECT_EQ(findings(truth, overlap(2, up), {}, within), Findings{});
  within.policy = *policy_of("within=299.99%");
  EXPECT_EQ(findings(truth, overlap(2, up), {}, within), Findings{Verdict::too_deep});
  // Of bodies that are known by bounds alone: 2 along the axis, 2 - 5/4 sqrt(2) at least, which is
  // 2 / 0.2322 - 1 = 761.2 % more.
  within.policy = *policy_of("within=762%");
  EXPECT_EQ(findings(cylinders(), overlap(2, up), {}, within), Findings{});
  within.policy = *policy_of("within=761%");
  EXPECT_EQ(findings(cylinders(), overlap(2, up), {}, within), Findings{Verdict::too_deep});
}

TEST(JudgeShapes, ContactsLieInBothBodies) {
  Reply reply = overlap(0.5, left);
  reply.contacts = {{{0.75, 0, 0}, 0.5}};
  EXPECT_EQ(findings(balls(), reply), Findings{});
  reply.contacts.push_back({{0.75, 0.75, 0}, 0.25});  // sqrt(9/8) - 1 out of both
  EXPECT_EQ(findings(balls(), reply), Findings{Verdict::witness_off});
  EXPECT_EQ(judge(balls(), reply).sentence, "a contact is 0.06066 away from A; a contact is 0.06066 away from B");
  reply.contacts = {{{0.75, 0, 0}, 0.375}};
  EXPECT_EQ(findings(balls(), reply), Findings{Verdict::inconsistent});
  EXPECT_EQ(judge(balls(), reply).sentence, "inconsistent: the depth of the deepest contact differs by 0.125");
}

// Unit balls with centres 5/2 apart, and cylinders with axes 5/2 sqrt(2) apart.
TEST(JudgeShapes, Distances) {
  const ShapeTruth balls = truth_about(sphere(1), at(sphere(1), mpq_class(5, 2)));
  const auto far = [](double e, std::optional<Triple> u = {}) { return testing::apart(e, u); };
  EXPECT_EQ(findings(balls, far(0.5)), Findings{});
  EXPECT_EQ(findings(balls, far(0.5, left), {}, none), Findings{});
  EXPECT_EQ(findings(balls, far(0.5, right)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(balls, far(0.501)), Findings{Verdict::too_far});
  EXPECT_EQ(findings(balls, far(0.499)), Findings{Verdict::too_near});
  EXPECT_EQ(findings(balls, with_witness(far(0.5, left), Triple{1, 0, 0}, Triple{1.5, 0, 0}), {}, none), Findings{});
  EXPECT_EQ(findings(balls, with_witness(far(0.5, left), Triple{1, 0, 0}, Triple{1.75, 0, 0})),
            Findings{Verdict::witness_off});
  EXPECT_EQ(judge(balls, far(0.75, left)).sentence,
            "too far by 0.25: 0.75 is claimed, the distance is 0.5; inconsistent: the gap across its direction is 0.5, "
            "not 0.75");
  const Shape one = cylinder(1, 1);
  const ShapeTruth cylinders = truth_about(one, at(one, mpq_class(5, 2), mpq_class(5, 2)));
  const double distance = kernels::nearest_binary64({-2, mpq_class(25, 2)});
  EXPECT_EQ(findings(cylinders, far(distance, diagonal), {}, none), Findings{});
  EXPECT_EQ(judge(cylinders, far(distance)).accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(findings(cylinders, far(distance * (1 + 1e-12)), {}, none), Findings{Verdict::too_far});
  EXPECT_EQ(findings(cylinders, far(distance * (1 - 1e-12)), {}, none), Findings{Verdict::too_near});
  const ShapeTruth plane = truth_about(sphere(1), halfspace({0, 0, 1}, -3));  // 2 below the ball
  EXPECT_EQ(findings(plane, far(2, up), {}, none), Findings{});
  EXPECT_EQ(findings(plane, with_witness(far(2, up), Triple{0, 0, -1}, Triple{0, 0, -3}), {}, none), Findings{});
  EXPECT_EQ(findings(plane, far(2, down)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(plane, far(1)), Findings{Verdict::too_near});
}

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
