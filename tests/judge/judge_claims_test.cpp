// SPDX-License-Identifier: GPL-3.0-or-later
// Distances, claim classes, policies and contacts, on pairs whose answers one can see.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fathom/judge.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "verify/judge/words.hpp"

namespace fathom::judging {
namespace {

using testing::apart;
using testing::cubes;
using testing::disjoint_cubes;
using testing::Findings;
using testing::findings;
using testing::left;
using testing::overlap;
using testing::right;
using testing::touching_cubes;
using testing::with_witness;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Triple up{0, 0, 1};

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
  EXPECT_EQ(result.price_squared, mpq_class(-1, 4));
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
  EXPECT_FALSE(result.price_squared || result.witness_a_squared || result.witness_gap || result.error ||
               result.accuracy);
}

Tolerance by(const char* policy) {
  Tolerance tolerance;
  tolerance.policy = *policy_of(policy);
  return tolerance;
}

// The depth is 0.6; along z it costs 1, which is 2/3 more.
TEST(Judge, ASeparatingClaimIsHeldToItsOwnPrice) {
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
  EXPECT_TRUE(result.longer);
  EXPECT_FALSE(result.accuracy);
  EXPECT_EQ(result.dearer, kernels::nearest_binary64({-1, mpq_class(25, 9)}));
  EXPECT_EQ(result.sentence,
            "separating: 1 is claimed, the price of its direction; the depth is 0.6, the price is 66.67 % more");
  const Judgement shortest = judge(cubes(), overlap(0.6, left), separating);
  EXPECT_FALSE(shortest.longer);
  EXPECT_EQ(shortest.dearer, 0);
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
  EXPECT_EQ(verdict(overlap(0.7, left), "within=67%"), Verdict::too_deep) << "its direction has another price";
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
  Reply alone = at(9);
  alone.depth.reset();
  EXPECT_EQ(findings(cubes(), alone), Findings{}) << "without a depth they are not read";
  Reply separate = at(9);
  separate.overlap = false;
  separate.distance = 0;
  EXPECT_EQ(findings(touching_cubes(), separate), Findings{}) << "nor beside a distance";
}

// Of several contacts the deepest one has the depth of the whole.
TEST(Judge, ContactsAreAsDeepAsTheAnswer) {
  const auto with = [](double depth, std::vector<std::optional<double>> depths) {
    Reply reply = overlap(depth, left);
    for (const std::optional<double>& each : depths) reply.contacts.push_back({{0.5, 0.5, 0.5}, each});
    return reply;
  };
  EXPECT_EQ(findings(cubes(), with(0.6, {0.6, 0.1, {}})), Findings{});
  EXPECT_EQ(findings(cubes(), with(0.6, {{}, 0.6005})), Findings{}) << "within the tolerance";
  EXPECT_EQ(findings(cubes(), with(0.6, {0.1, 0.607})), Findings{Verdict::inconsistent});
  EXPECT_EQ(findings(cubes(), with(0.6, {0.5, -1})), Findings{Verdict::inconsistent});
  EXPECT_EQ(findings(cubes(), with(0.6, {{}, {}})), Findings{}) << "where none has a depth";
  EXPECT_EQ(findings(cubes(), with(0.6, {0.6, nan})), Findings{Verdict::nan});
  const Judgement result = judge(cubes(), with(0.75, {0.5, 0.25}));
  EXPECT_EQ(result.sentence,
            "too deep by 0.15: 0.75 is claimed, the depth is 0.6; inconsistent: the plane across its direction is at "
            "0.6, not at 0.75, the "
            "depth of the deepest contact differs by 0.25");
  EXPECT_EQ(result.deepest, -0.25);
  Conventions negative;
  negative.depth = Conventions::Sign::negative;
  EXPECT_EQ(findings(cubes(), with(-0.6, {-0.1, -0.6}), negative), Findings{});
  EXPECT_EQ(findings(cubes(), with(-0.6, {-0.1, 0.6}), negative), Findings{Verdict::inconsistent});
  EXPECT_EQ(findings(cubes(), with(-0.6, {-0.6})), Findings{Verdict::wrong_sign}) << "one slip, not two";
}

}  // namespace
}  // namespace fathom::judging
