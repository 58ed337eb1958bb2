// SPDX-License-Identifier: GPL-3.0-or-later
// Answers about unions: each verdict on bodies of boxes whose answers one can see, and the findings
// once more by a twin that looks at every plane of every pair of boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "tests/unions/naive_union.hpp"
#include "tests/unions/pieces.hpp"

namespace fathom::judging {
namespace {

using testing::apart;
using testing::Findings;
using testing::findings;
using testing::left;
using testing::overlap;
using testing::right;
using unions::box;
using unions::moved;

constexpr Triple along_y{0, 1, 0}, against_y{0, -1, 0}, along_z{0, 0, 1};

/// A plate between two blocks, 1/2 deep in the one on its right; the slot is as wide as it, and it
/// comes to lie there exactly.
const UnionTruth& slot() {
  static const UnionTruth truth = truth_about({box({mpq_class(1, 2), -1, -1}, {mpq_class(3, 2), 1, 1})},
                                              {box({-9, -9, -9}, {0, 9, 9}), box({1, -9, -9}, {9, 9, 9})});
  return truth;
}

/// A bar under one block and over the next: out of either it is 1/2 in y, out of both 2 in x and
/// 1/2 in y.
const UnionTruth& bar() {
  static const UnionTruth truth = truth_about({box({0, 0, 0}, {6, 1, 2})}, {box({-4, mpq_class(1, 2), -9}, {2, 9, 9}),
                                                                            box({4, -9, -9}, {9, mpq_class(1, 2), 9})});
  return truth;
}

const UnionTruth& far_away() {
  static const UnionTruth truth = truth_about({box({0, 0, 0}, {1, 1, 1}), box({0, 0, 5}, {1, 1, 6})},
                                              {box({3, 0, 0}, {4, 1, 1}), box({2, 0, 5}, {4, 1, 6})});
  return truth;
}

TEST(JudgeUnions, ARightAnswerPassesThoughNoTranslationBesideItDoes) {
  const Judgement result = judge(slot(), overlap(0.5, left));
  EXPECT_EQ(result.verdict, Verdict::pass);
  EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded);
  EXPECT_EQ(result.depth_squared, mpq_class(1, 4));
  EXPECT_EQ(result.bounds->deepest_pair, mpq_class(1, 4));
  EXPECT_EQ(result.deeper_squared, 1);
  EXPECT_EQ(result.inconsistency, 0);
  EXPECT_FALSE(result.overlap_left || result.separating_distance_squared || result.exit_distance_squared ||
               result.relative_excess);
  EXPECT_EQ(findings(slot(), overlap(0.5)), Findings{});
  const Tolerance none{0, 0, 0};
  EXPECT_EQ(findings(slot(), overlap(0.5, left), {}, none), Findings{}) << "by a tolerance of 0 too";
}

TEST(JudgeUnions, TheDeepestPairHasItsCost) {
  const Judgement result = judge(bar(), overlap(0.5, against_y));
  EXPECT_EQ(result.findings, (Findings{Verdict::too_shallow, Verdict::not_separating}));
  EXPECT_EQ(result.bounds->deepest_pair, mpq_class(1, 4));
  EXPECT_EQ(result.depth_squared, mpq_class(17, 4));
  EXPECT_EQ(result.deeper_squared, 17);
  EXPECT_EQ(result.error, -1.5615528128088303);
  EXPECT_EQ(result.overlap_left, 2.0) << "out of the other block";
  EXPECT_EQ(result.sentence,
            "too shallow by 1.562: 0.5 is claimed, the depth is 2.0615528128088303, 4.123 times as much; not "
            "separating: 2 of overlap is left "
            "after its translation");
}

TEST(JudgeUnions, Classification) {
  Reply separate;
  EXPECT_EQ(findings(bar(), separate), Findings{Verdict::false_separation});
  EXPECT_EQ(findings(far_away(), separate), Findings{});
  EXPECT_EQ(findings(far_away(), overlap({})), Findings{Verdict::false_overlap});
  const UnionTruth touching =
      truth_about({box({0, 0, 0}, {1, 1, 1})}, {box({1, 0, 0}, {2, 1, 1}), box({5, 5, 5}, {6, 6, 6})});
  EXPECT_EQ(judge(touching, separate).verdict, Verdict::touching_by_convention);
  Conventions conventions;
  conventions.touching = Conventions::Touching::overlap;
  EXPECT_EQ(findings(touching, separate, conventions), Findings{Verdict::false_separation});
  EXPECT_EQ(findings(bar(), overlap(std::numeric_limits<double>::quiet_NaN(), against_y)).front(), Verdict::nan);
}

TEST(JudgeUnions, TooDeepAndTheWayThatIsLeft) {
  EXPECT_EQ(findings(bar(), overlap(2.5, right)), (Findings{Verdict::too_deep, Verdict::not_separating}));
  const Judgement far = judge(slot(), overlap(20, along_y));
  EXPECT_EQ(far.findings, (Findings{Verdict::too_deep, Verdict::inconsistent}));
  EXPECT_EQ(far.inconsistency, 10.0);
  EXPECT_NE(far.sentence.find("inconsistent: its translation leaves a gap of 10"), std::string::npos) << far.sentence;
}

TEST(JudgeUnions, ATranslationBehindTheFirstGapIsOverlapAgain) {
  // Out of the first block after 1, into the second after 2, out of that after 3.
  const UnionTruth truth =
      truth_about({box({0, 0, 0}, {1, 1, 1})}, {box({0, -9, -9}, {1, 9, 9}), box({3, -9, -9}, {4, 9, 9})});
  EXPECT_EQ(findings(truth, overlap(1, right)), Findings{});
  EXPECT_EQ(findings(truth, overlap(1, left)), Findings{});
  const Judgement behind = judge(truth, overlap(3, right));
  EXPECT_EQ(behind.findings, (Findings{Verdict::too_deep, Verdict::not_separating}));
  EXPECT_NE(behind.sentence.find("not separating: 1 of overlap is left after its translation"), std::string::npos)
      << behind.sentence;
  EXPECT_EQ(findings(truth, overlap(2, right)), Findings{Verdict::too_deep});
}

TEST(JudgeUnions, TheSentenceIsOnTheClaimedDirectionAndNotOnItsOpposite) {
  const Pieces a{box({mpq_class(1, 4), 0, 0}, {mpq_class(5, 4), 1, 1})}, b{box({0, -9, -9}, {1, 9, 9})};
  const UnionTruth truth = truth_about(a, b);
  const Judgement wrong = judge(truth, overlap(0.5, left));
  EXPECT_EQ(wrong.findings, (Findings{Verdict::too_shallow, Verdict::not_separating}));
  EXPECT_NE(wrong.sentence.find("0.75 of overlap is left"), std::string::npos) << wrong.sentence;
}

TEST(JudgeUnions, Signs) {
  EXPECT_EQ(findings(slot(), overlap(0.5, right)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(slot(), overlap(-0.5, left)), Findings{Verdict::wrong_sign});
  Conventions conventions;
  conventions.depth = Conventions::Sign::negative;
  conventions.moves = Conventions::Body::b;
  EXPECT_EQ(findings(slot(), overlap(-0.5, right), conventions), Findings{});
  EXPECT_EQ(findings(slot(), overlap(-0.25, right), conventions),
            (Findings{Verdict::too_shallow, Verdict::not_separating}));
}

TEST(JudgeUnions, Policies) {
  Tolerance tolerance;
  tolerance.policy.kind = Policy::Kind::separating;
  const Judgement longer = judge(slot(), overlap(10, along_y), {}, Precision::binary64, tolerance);
  EXPECT_EQ(longer.findings, Findings{}) << longer.sentence;
  EXPECT_TRUE(longer.excess_allowed);
  EXPECT_EQ(findings(slot(), overlap(9, along_y), {}, tolerance),
            (Findings{Verdict::too_deep, Verdict::not_separating}));
  tolerance.policy = {Policy::Kind::within, 19};
  EXPECT_EQ(findings(slot(), overlap(10, along_y), {}, tolerance), Findings{});
  tolerance.policy.most = mpq_class(189, 10);
  EXPECT_EQ(findings(slot(), overlap(10, along_y), {}, tolerance), Findings{Verdict::too_deep});
}

TEST(JudgeUnions, Distances) {
  EXPECT_EQ(findings(far_away(), apart(1)), Findings{});
  EXPECT_EQ(findings(far_away(), apart(1, left)), Findings{}) << "A moved the other way touches";
  EXPECT_EQ(findings(far_away(), apart(1, right)), Findings{Verdict::wrong_sign});
  EXPECT_EQ(findings(far_away(), apart(2, left)), (Findings{Verdict::too_far, Verdict::inconsistent}));
  EXPECT_EQ(findings(far_away(), apart(0.5, left)), (Findings{Verdict::too_near, Verdict::inconsistent}));
  EXPECT_EQ(findings(far_away(), apart(1, along_y)), Findings{Verdict::inconsistent});
}

TEST(JudgeUnions, WitnessPointsAreOnOneOfThePieces) {
  Reply reply = apart(1, left);
  reply.witness_a = Triple{1, 0.5, 5.5};
  reply.witness_b = Triple{2, 0.5, 5.5};
  EXPECT_EQ(findings(far_away(), reply), Findings{});
  reply.witness_a = Triple{1, 0.5, 3};
  reply.witness_b = Triple{2, 0.5, 3};
  const Judgement off = judge(far_away(), reply);
  EXPECT_EQ(off.findings, Findings{Verdict::witness_off}) << "in the hull of A, and in no piece";
  EXPECT_EQ(off.witness_a_squared, 4);
  Reply contacts = overlap(0.5, left);
  contacts.contacts = {{Triple{1.25, 0, 0}, 0.5}};
  EXPECT_EQ(findings(slot(), contacts), Findings{});
  contacts.contacts = {{Triple{0.75, 0, 0}, 0.5}};
  EXPECT_EQ(judge(slot(), contacts).contact_b_squared, mpq_class(1, 16));
}

TEST(JudgeUnions, RoundedOptimaPassWithoutATolerance) {
  const Tolerance none{0, 0, 0};
  std::mt19937_64 random(20);
  int overlapping = 0, slanted = 0;
  for (int i = 0; i < 40; ++i) {
    const UnionTruth truth =
        truth_about(unions::random_pieces(random, 3, 6, 9, 3), unions::random_pieces(random, 2, 6, 9, 4));
    if (truth.depth.status != Status::penetrating) continue;
    ++overlapping;
    for (const UnionOptimum& optimum : truth.depth.optima) {
      const double depth = root_binary64(truth.depth.squared(), Rounding::rn);
      const Point& t = optimum.translation;
      const auto part = [&](const mpq_class& x) {
        const double size = root_binary64(x * x / truth.depth.squared(), Rounding::rn);
        return x < 0 ? -size : size;
      };
      const Triple direction{part(t.x), part(t.y), part(t.z)};
      slanted += std::ranges::count(direction, 0.0) < 2 ? 1 : 0;
      const Judgement result = judge(truth, overlap(depth, direction), {}, Precision::binary64, none);
      EXPECT_EQ(result.verdict, Verdict::pass) << result.sentence;
      EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded);
      const double less = std::nextafter(std::nextafter(depth, 0), 0),
                   more = std::nextafter(std::nextafter(depth, 99), 99);
      EXPECT_EQ(judge(truth, overlap(less), {}, Precision::binary64, none).verdict, Verdict::too_shallow);
      EXPECT_EQ(judge(truth, overlap(more), {}, Precision::binary64, none).verdict, Verdict::too_deep);
    }
  }
  EXPECT_GE(overlapping, 20);
  EXPECT_GE(slanted, 10);
}

// ---- the twin ----

/// Of boxes, for integers in an answer and a tolerance that is a multiple of the extent.
class NaiveJudge {
 public:
  NaiveJudge(const Pieces& a, const Pieces& b, const mpq_class& absolute) : a_(a), b_(b) {
    for (const Pieces* body : {&a_, &b_})
      for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
        const std::vector<Point> all = unions::joined(*body);
        const auto [low, high] = std::ranges::minmax_element(
            all, [](const mpq_class& x, const mpq_class& y) { return x < y; }, axis);
        tol_ = std::max(tol_, mpq_class(absolute * ((*high).*axis - (*low).*axis)));
      }
  }

  [[nodiscard]] Findings findings(bool overlap, long length, const Triple& direction) const {
    Findings found;
    const mpq_class depth = unions::naive_union(a_, b_).squared, distance = squared_distance(a_);
    if (depth > 0 && !overlap && depth > tol_ * tol_) found.push_back(Verdict::false_separation);
    if (distance > 0 && overlap && (distance > tol_ * tol_ || length > tol_)) found.push_back(Verdict::false_overlap);
    const mpq_class& truth = overlap ? depth : distance;
    if (above(length, truth)) found.push_back(overlap ? Verdict::too_deep : Verdict::too_far);
    if (below(length, truth)) found.push_back(overlap ? Verdict::too_shallow : Verdict::too_near);
    const long way = overlap ? length : -length;
    const Lies after = lies(direction, way), behind = lies(direction, -way);
    if (after != Lies::touching) {
      if (behind == Lies::touching) found.push_back(Verdict::wrong_sign);
      else if (after == Lies::overlapping && depth > 0 && overlap) found.push_back(Verdict::not_separating);
      else found.push_back(Verdict::inconsistent);
    }
    std::ranges::sort(found);
    return found;
  }

 private:
  enum class Lies { overlapping, touching, apart };

  [[nodiscard]] Lies lies(const Triple& direction, long way) const {
    const mpq_class by(way);
    const Pieces a =
        moved(a_, {by * mpq_class(direction[0]), by * mpq_class(direction[1]), by * mpq_class(direction[2])});
    if (unions::naive_union(a, b_).squared > tol_ * tol_) return Lies::overlapping;
    return squared_distance(a) > tol_ * tol_ ? Lies::apart : Lies::touching;
  }

  [[nodiscard]] mpq_class squared_distance(const Pieces& a) const {
    std::optional<mpq_class> least;
    for (const std::vector<Point>& p : a) {
      for (const std::vector<Point>& q : b_) {
        mpq_class squared = 0;
        for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
          const mpq_class gap = std::max(
              {mpq_class(0), mpq_class(q.front().*axis - p.back().*axis), mpq_class(p.front().*axis - q.back().*axis)});
          squared += gap * gap;
        }
        if (!least || squared < *least) least = squared;
      }
    }
    return *least;
  }

  /// d - sqrt(squared) > tol, and the other way round.
  [[nodiscard]] bool above(long d, const mpq_class& squared) const {
    return d - tol_ > 0 && (d - tol_) * (d - tol_) > squared;
  }
  [[nodiscard]] bool below(long d, const mpq_class& squared) const { return (d + tol_) * (d + tol_) < squared; }

  Pieces a_, b_;
  mpq_class tol_ = 0;
};

TEST(JudgeUnions, TheTwinFindsTheSame) {
  Tolerance tolerance;
  tolerance.relative = 0;
  tolerance.absolute = mpq_class(1, 64);
  std::mt19937_64 random(7);
  std::map<Verdict, int> met;
  for (int i = 0; i < 60; ++i) {
    const mpq_class shift(static_cast<long>(random() % 9) - 2);
    const Pieces a = unions::random_boxes(random, 2, 6), b = moved(unions::random_boxes(random, 2, 6), {shift, 0, 1});
    const UnionTruth truth = truth_about(a, b);
    const NaiveJudge naive(a, b, tolerance.absolute);
    for (const long length : {1, 2, 3, 4}) {
      const std::array directions{left, right, along_y, against_y, along_z};
      const Triple direction = directions[random() % directions.size()];
      const bool says =
          random() % 4 != 0 ? truth.depth.status == Status::penetrating : truth.depth.status != Status::penetrating;
      const auto d = static_cast<double>(length);
      const Reply reply = says ? overlap(d, direction) : apart(d, direction);
      const Judgement judged = judge(truth, reply, {}, Precision::binary64, tolerance);
      const Findings expected = naive.findings(says, length, direction);
      EXPECT_EQ(judged.findings, expected) << i << ": " << judged.sentence;
      for (const Verdict verdict : expected) ++met[verdict];
      if (expected.empty()) ++met[Verdict::pass];
    }
  }
  for (const Verdict verdict :
       {Verdict::pass, Verdict::false_separation, Verdict::false_overlap, Verdict::wrong_sign, Verdict::too_deep,
        Verdict::too_shallow, Verdict::too_far, Verdict::too_near, Verdict::not_separating, Verdict::inconsistent})
    EXPECT_GE(met[verdict], 3) << name(verdict);
}

}  // namespace
}  // namespace fathom::judging
