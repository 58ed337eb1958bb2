// SPDX-License-Identifier: GPL-3.0-or-later
// Answers about unions: rounded ones pass, and what is found is found by a twin that looks at every
// plane of every pair of boxes. Each verdict on bodies whose answers one can see is a row of
// tests/data/judged.jsonl.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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
