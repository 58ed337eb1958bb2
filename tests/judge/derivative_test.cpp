// SPDX-License-Identifier: GPL-3.0-or-later
// Claimed derivatives: on the border and a number to either side, what wrong ones are instead, and
// the nearest number to the exact rate of every family, which passes with no tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fathom/patch.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "tests/judge/pairs.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"
#include "verify/judge/manifold.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::judging {
namespace {

using testing::cube;
using testing::overlap;

constexpr double beyond = std::numeric_limits<double>::infinity();

struct Question {
  Body a, b;
  Motion motion;
  Tolerance tolerance = {};
  NumberFormat format = {};

  [[nodiscard]] DerivativeJudgement judged(double claimed, const Reply& reply = overlap(1)) const {
    Reply with = reply;
    with.derivative = claimed;
    return judging::judged(truth_of(a, b), with, {}, format, tolerance, motion).derivative.value();
  }
  [[nodiscard]] bool passes(double claimed) const { return judged(claimed).sentence.empty(); }
};

Twist going(const Point& v) { return {v, {}}; }
Twist turning(const Point& w) { return {{}, w}; }

TEST(Derivative, PassesOnTheBorderAndFailsBeyond) {
  Question cubes{{cube(0)}, {cube(mpq_class(2, 5))}, {going({2, 0, 0}), {}}};  // two fast, and A enters B
  cubes.tolerance.relative = mpq_class(1, 1024);
  const double border = 1.0 / 512;
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(cubes.passes(2 + sign * border));
    EXPECT_FALSE(cubes.passes(std::nextafter(2 + sign * border, sign * beyond)));
  }
  cubes.tolerance = {0, mpq_class(1, 1024)};
  EXPECT_TRUE(cubes.passes(2 + border)) << "the larger one of both tolerances";
  cubes.tolerance = {0, 0, 3};
  EXPECT_TRUE(cubes.passes(2 + 3 * 0x1p-51));
  EXPECT_FALSE(cubes.passes(2 + 4 * 0x1p-51));
  EXPECT_EQ(cubes.judged(2).squared, 4);
  EXPECT_EQ(*cubes.judged(1.5).error, -0.5);
}

TEST(Derivative, IsReadInTheUnitOfTheSubject) {
  Question cubes{{cube(0)}, {cube(mpq_class(2, 5))}, {going({2, 0, 0}), {}}, {}, {{}, {}, -1}};
  EXPECT_TRUE(cubes.passes(1));
  EXPECT_EQ(cubes.judged(1.5).sentence, "the derivative is wrong by 1: 3 is claimed, 2 is right");
  EXPECT_EQ(cubes.judged(1.5).claimed, 3);
}

TEST(Derivative, SaysWhatAWrongClaimIsInstead) {
  const auto instead = [](const Question& question, double claimed, const Reply& reply = overlap(1)) {
    const std::string sentence = question.judged(claimed, reply).sentence, before = " is right; it is ";
    const std::size_t at = sentence.find(before);
    return at == sentence.npos ? sentence : sentence.substr(at + before.size());
  };
  // Two shortest ways out, -x and -y, of which a push along x lengthens one.
  const Question tie{{cube(0)}, {cube(mpq_class(1, 2), mpq_class(1, 2))}, {going({1, 0, 0}), {}}};
  EXPECT_TRUE(tie.passes(0));
  EXPECT_EQ(tie.judged(0).kinks, (std::vector<std::string>{"ties", "extended"}));
  EXPECT_EQ(instead(tie, 0.5), "the mean of the rates from now on, 0, and until now, 1: that of a central difference");
  EXPECT_EQ(instead(tie, 1), "the rate until now: that of a difference backwards");
  EXPECT_EQ(instead(tie, 0.25), "the derivative is wrong by 0.25: 0.25 is claimed, 0 is right");
  const Question longer{tie.a, tie.b, {going({1, 2, 0}), {}}};
  EXPECT_EQ(instead(longer, -1), "the right rate with the other sign");
  EXPECT_EQ(instead({tie.a, tie.b, {{{1, 2, -3}, {0, 0, 1}}, {}}}, 3),
            "the rate along (0, -1, 0) alone, where each shortest way out counts as well, and (-1, 0, 0) decides");
  // One cube lies on another and tilts: the corner that goes in decides.
  const Question tilt{{cube(0)}, {cube(0, 0, mpq_class(-3, 4))}, {turning({0, 1, 0}), {}}};
  EXPECT_TRUE(tilt.passes(1));
  EXPECT_EQ(tilt.judged(1).kinks, std::vector<std::string>{"extended"});
  EXPECT_EQ(instead(tilt, 0), "the rate until now: that of a difference backwards");
  const Question far{tilt.a, tilt.b, {{{0, 0, 3}, {0, 1, 0}}, {}}};
  EXPECT_EQ(instead(far, -2.5),
            "the mean of the rates from now on, -2, and until now, -3: that of a central difference");
  Reply reply = overlap(0.25, Triple{0, 0, 1});
  reply.witness_a = Triple{0.25, 0.5, 0};
  reply.witness_b = Triple{0.25, 0.5, 0.25};
  EXPECT_EQ(instead(far, -2.75, reply), "the rate at its own witness points, along its own direction");
  const Question slanted{tilt.a, tilt.b, {turning({0.5, 1, 0}), turning({-1, 0, 0})}};
  EXPECT_TRUE(slanted.passes(1));
  EXPECT_EQ(instead(slanted, -0.5),
            "the rate at the contact point (1, 1, 0) alone, where each counts, and (1, 0, 0) decides");
}

TEST(Derivative, SaysWhereTheBodiesAreAndNotTheirCores) {
  Question rounded{{}, {}, {{{}, {mpq_class(1, 4), 1, 0}}, {}}};
  rounded.a.shape =
      moved(with_margin(box({1, 1, 1}), mpq_class(1, 2)), rigid_pose({1, 0, 0, 0}, {0, 0, mpq_class(9, 4)}));
  rounded.b.shape = box({3, 3, 1});
  // Of the core's corners (x, y, 5/4), each less 1/2 along z, the rate is x - y/4.
  EXPECT_TRUE(rounded.passes(1.25));
  const std::string sentence = rounded.judged(0.75).sentence, says = "the rate at the contact point (";
  EXPECT_NE(sentence.find(says + "1, 1, 0.75) alone, where each counts, and (1, -1, 0.75) decides"), sentence.npos)
      << sentence;
}

// A tetrahedron's tip on a cube's corner, pushed into it: of the directions that separate them none
// is named as the one that decides.
TEST(Derivative, NamesNoneThatDecidesOfCoresThatTouch) {
  const std::vector<Point> corner{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const Question tips{{corner}, {cube(0)}, {going({3, 2, 1}), {}}};
  bool told = false;
  for (double claimed = -4; claimed < 5; claimed += 0.125) {
    const std::string sentence = tips.judged(claimed).sentence;
    EXPECT_EQ(sentence.find("decides"), sentence.npos) << sentence;
    told = told || sentence.ends_with(" alone, where each direction that separates the cores counts");
  }
  EXPECT_TRUE(told);
}

TEST(Derivative, OfNoNumberAndOfWhatIsLeftOut) {
  const Question cubes{{cube(0)}, {cube(mpq_class(2, 5))}, {going({1, 0, 0}), {}}};
  EXPECT_EQ(cubes.judged(beyond).sentence, "the derivative is inf");
  Question curved{{}, {cube(0)}, {going({1, 0, 0}), {}}};
  curved.a.shape = fathom::cylinder(1, 1);
  EXPECT_EQ(curved.judged(7).left_out, "curved");
  EXPECT_TRUE(curved.passes(7));
  EXPECT_FALSE(curved.judged(7).squared);
}

TEST(Derivative, LargestSpeed) {
  const Motion motion{{{3, 0, 0}, {0, 0, 1}}, going({0, 4, 0})};
  const auto speed = [&](const Body& a, const Body& b) { return largest_speed(a, b, motion); };
  EXPECT_EQ(speed({{{0, 0, 0}}}, {{{9, 9, 9}}}), 4);
  EXPECT_EQ(speed({{{4, 0, 0}, {0, 0, 0}}}, {{{9, 9, 9}}}), 5) << "(3, 4, 0)";
  Body ball, floor;
  ball.shape = fathom::sphere(2);
  EXPECT_EQ(speed(ball, {{{9, 9, 9}}}), 5) << "3, and 2 around its axis";
  floor.shape = fathom::halfspace({0, 0, 1}, 0);
  EXPECT_EQ(speed(floor, {{{4, 0, 0}}}), 5) << "as if it had the point of the other";
  const mpq_class root = speed({{{1, 0, 0}}}, {{{0, 0, 0}}}), square = speed({{{0, 1, 0}}}, {{{0, 0, 0}}});
  EXPECT_EQ(square, 4) << "of (2, 0, 0) and (0, 4, 0)";
  EXPECT_EQ(root, 4);
  const mpq_class irrational = largest_speed({{{0, 0, 0}}}, {{{0, 0, 0}}}, {going({1, 1, 0}), {}});
  EXPECT_GE(irrational * irrational, 2);
  EXPECT_LE(irrational, mpq_class(14142135623730951, 10000000000000000) * (1 + mpq_class(1, 1UL << 39)));
}

// A rate is judged where both are told, the rate and the motion; and is one finding among others.
TEST(Derivative, IsJudgedByTheJudgeOfAnswers) {
  const std::vector<Triple> a{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, b{{0.25, 0.25, 0}, {2, 0, 0}, {0, 2, 0}};
  Reply reply = overlap(9);
  const Motion still, moving{going({1, 0, 0}), {}};
  const auto findings = [&](const std::optional<Motion>& motion) {
    return judge(a, b, reply, {}, {}, {}, motion).findings;
  };
  const auto has = [](const std::vector<Verdict>& all, Verdict one) {
    return std::ranges::find(all, one) != all.end();
  };
  EXPECT_FALSE(judge(a, b, reply, {}, {}, {}, moving).derivative) << "the reply tells none";
  reply.derivative = 7;
  EXPECT_FALSE(has(findings({}), Verdict::wrong_derivative)) << "it is not told how they move";
  EXPECT_TRUE(has(findings(moving), Verdict::wrong_derivative));
  EXPECT_TRUE(has(findings(moving), findings({})[0])) << "and the rest is judged as ever";
  reply.derivative = 0;
  EXPECT_FALSE(has(findings(still), Verdict::wrong_derivative));
  reply.derivative = std::nan("");
  EXPECT_TRUE(has(findings(moving), Verdict::nan));
}

std::vector<families::Family> every_family() {
  std::vector<families::Family> all;
  for (const auto kind : {families::Kind::polytopes, families::Kind::shapes, families::Kind::unions})
    for (const families::Family& family : families::families(kind)) all.push_back(family);
  return all;
}

class EveryFamilyDerivative : public ::testing::TestWithParam<families::Family> {};

TEST_P(EveryFamilyDerivative, TheNearestNumberPassesAndTheNextButOneFails) {
  families::Random random(GetParam().usual_size);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Case pair = GetParam().make(seed, std::min(GetParam().usual_size, 12U));
    const auto number = [&] { return mpq_class(random.between(-8, 8)); };
    const auto twist = [&] { return Twist{{number(), number(), number()}, {number(), number(), number()}}; };
    const Question question{pair.a, pair.b, {twist(), twist()}, {0, 0, 0}};
    const DerivativeJudgement judged = question.judged(0);
    if (!judged.squared) continue;
    const double right = kernels::nearest_binary64({0, *judged.squared});
    EXPECT_TRUE(question.passes(right)) << pair.id;
    for (const double end : {beyond, -beyond})
      EXPECT_FALSE(question.passes(std::nextafter(std::nextafter(right, end), end))) << pair.id;
    if (right != 0) EXPECT_NE(question.judged(-right).sentence, "") << pair.id;
  }
}
INSTANTIATE_TEST_SUITE_P(Families, EveryFamilyDerivative, ::testing::ValuesIn(every_family()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace fathom::judging
