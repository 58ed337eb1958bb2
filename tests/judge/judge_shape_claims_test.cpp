// SPDX-License-Identifier: GPL-3.0-or-later
// Distances, claim classes and contacts of shapes, on pairs whose answers have a closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "tests/judge/shape_pairs.hpp"
#include "verify/judge/words.hpp"

namespace fathom::judging {
namespace {

using testing::at;
using testing::balls;
using testing::cylinders;
using testing::diagonal;
using testing::down;
using testing::Findings;
using testing::findings;
using testing::left;
using testing::overlap;
using testing::right;
using testing::up;
using testing::with_witness;

const Tolerance none{0, 0, 0};  // half an ulp of each number

// The depth of two unit balls, centres 3/2 apart, is 1/2; along y the plane is at 2.
TEST(JudgeShapes, ASeparatingClaimIsHeldToItsOwnPrice) {
  Conventions separating;
  separating.claims = Conventions::Claims::separating;
  const ShapeTruth truth = balls();
  EXPECT_EQ(findings(truth, overlap(2, up)), Findings{Verdict::too_deep});
  EXPECT_EQ(findings(truth, overlap(2, up), separating), Findings{});
  EXPECT_EQ(findings(truth, overlap(1, up), separating),
            (Findings{Verdict::too_deep, Verdict::not_separating, Verdict::inconsistent}));
  EXPECT_EQ(judge(truth, overlap(2, up), separating).dearer, 3);
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

}  // namespace
}  // namespace fathom::judging
