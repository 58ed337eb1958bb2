// SPDX-License-Identifier: Apache-2.0
// How a project that computes penetration depths tests itself with fathom::judge. Its
// CMakeLists.txt says:
//   find_package(fathom REQUIRED)
//   find_package(GTest REQUIRED)
//   add_executable(judge_in_googletest judge_in_googletest.cpp)
//   target_link_libraries(judge_in_googletest PRIVATE fathom::judge GTest::gtest_main)
#include <gtest/gtest.h>

#include <fathom/judge.hpp>
#include <vector>

namespace {

using Points = std::vector<fathom::Triple>;

Points unit_cube(double x) {
  Points corners;
  for (unsigned i = 0; i < 8; ++i) corners.push_back({x + (i & 1 ? 1 : 0), i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  return corners;
}

/// What stands for the project's own function: it finds the right direction, and a depth that is
/// too large.
fathom::Reply wrong_penetration(const Points&, const Points&) {
  fathom::Reply reply;
  reply.overlap = true;
  reply.depth = 1.0392;
  reply.direction = {-1, 0, 0};
  return reply;
}

fathom::Reply right_penetration(const Points& a, const Points& b) {
  fathom::Reply reply = wrong_penetration(a, b);
  reply.depth = 0.6;
  return reply;
}

TEST(Penetration, OfTwoCubesIsRight) {
  const Points a = unit_cube(0), b = unit_cube(0.4);
  const fathom::Judgement judgement = fathom::judge(a, b, right_penetration(a, b));
  EXPECT_TRUE(fathom::passes(judgement.verdict)) << judgement.sentence;  // a failing test shows by how much, and why
}

TEST(Penetration, AWrongAnswerIsToldByHowMuch) {
  const Points a = unit_cube(0), b = unit_cube(0.4);
  const fathom::Judgement judgement = fathom::judge(a, b, wrong_penetration(a, b));
  EXPECT_EQ(judgement.verdict, fathom::Verdict::too_deep);
  EXPECT_NEAR(judgement.error.value(), 0.4392, 1e-12);
  EXPECT_EQ(judgement.sentence,
            "too deep by 0.4392: 1.0392 is claimed, the depth is 0.6; inconsistent: the plane across its direction is "
            "at 0.6, not at 1.0392");
}

// Conventions and tolerances are the project's own: here a depth below 0, bodies that touch count
// as apart, and one ulp.
TEST(Penetration, InOtherConventions) {
  fathom::Conventions ours;
  ours.depth = fathom::Conventions::Sign::negative;
  ours.touching = fathom::Conventions::Touching::separate;
  fathom::Reply reply;
  reply.overlap = true;
  reply.depth = -0.6;
  const fathom::Tolerance one_ulp{0, 0, 1};
  EXPECT_EQ(fathom::judge(unit_cube(0), unit_cube(0.4), reply, ours, fathom::Precision::binary64, one_ulp).verdict,
            fathom::Verdict::pass);
  EXPECT_EQ(fathom::judge(unit_cube(0), unit_cube(1), {}, ours).verdict, fathom::Verdict::touching_by_convention);
}

}  // namespace
