// SPDX-License-Identifier: GPL-3.0-or-later
// Answers whose every number is the correct rounding of an exact optimum's pass with no tolerance
// at all, near O and far away, at the ends of the exponents' range and in both precisions; answers
// a few ulps from them fail.                                                      [proofs/judge.md]
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/judge/pairs.hpp"
#include "tests/support/prepared.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {
namespace {

using testing::box;
using testing::cube;

const Tolerance strictest{0, 0, 0};

/// Numbers of a precision, rounded in one direction.
struct Rounded {
  Precision precision;
  Rounding mode = Rounding::rn;

  [[nodiscard]] double root(const mpq_class& squared) const {
    return precision == Precision::binary64 ? root_binary64(squared, mode) : root_binary32(squared, mode);
  }
  [[nodiscard]] double value(const mpq_class& x) const {
    return precision == Precision::binary64 ? round_binary64(x, mode) : round_binary32(x, mode);
  }
  [[nodiscard]] Triple point(const Point& p) const { return {value(p.x), value(p.y), value(p.z)}; }
  [[nodiscard]] Triple unit(const Vector& n) const {
    const mpz_class square = dot(n, n);
    const auto component = [&](const mpz_class& x) {
      mpq_class part(x * x, square);
      part.canonicalize();
      return x < 0 ? -root(part) : root(part);
    };
    return {component(n.x), component(n.y), component(n.z)};
  }
  /// The k-th optimum of bodies that overlap; of bodies that touch, a direction that separates
  /// them.
  [[nodiscard]] Reply answer(const Depth& depth, std::size_t k) const {
    const bool touching = depth.status() == Status::touching;
    Reply reply =
        testing::overlap(root(depth.squared()), unit(touching ? depth.direction() : depth.optima()[k].direction));
    if (k > 0 || !depth.witness()) return reply;
    reply.witness_a = point(depth.witness()->a);
    reply.witness_b = point(depth.witness()->b);
    return reply;
  }
  /// `steps` numbers away from zero.
  [[nodiscard]] double stepped(double x, int steps) const {
    for (; steps > 0; --steps) {
      const double up = std::copysign(INFINITY, x);
      x = precision == Precision::binary64 ? std::nextafter(x, up)
                                           : std::nextafter(static_cast<float>(x), static_cast<float>(up));
    }
    return x;
  }
};

struct Placed {
  std::string text;
  Precision precision;
  Truth truth;
};

/// The case scaled, after it was moved along x, y and z, as the precision sees it. Returns nullopt
/// if that overflows.
std::optional<Placed> placed(const Case& input, Precision precision, long offset, const char* scale) {
  const mpq_class factor = *parse_number(scale, Decimals::exact).value;
  const auto moved = [&](std::vector<Point> points) {
    for (Point& p : points) p = {(p.x + offset) * factor, (p.y + offset) * factor, (p.z + offset) * factor};
    return seen(points, precision);
  };
  auto a = moved(input.a.points), b = moved(input.b.points);
  if (!a || !b) return std::nullopt;
  const std::string text =
      input.id + ", " + std::string(name(precision)) + ", moved by " + std::to_string(offset) + ", times " + scale;
  return Placed{text, precision, truth_about(std::move(*a), std::move(*b))};
}

constexpr const char* scales_of_binary64[] = {"1e-322", "1e-310", "1e-300", "1", "1e300"};
constexpr const char* scales_of_binary32[] = {"1e-44", "1e-40", "1e-36", "1", "1e30"};

/// Every family's bodies that overlap or touch, everywhere.
const std::vector<Placed>& pairs_everywhere() {
  static const std::vector<Placed> result = [] {
    std::vector<Placed> pairs;
    for (const Case& input : testing::cases_of_all_families(1, 6)) {
      for (const Precision precision : {Precision::binary64, Precision::binary32}) {
        for (const char* scale : precision == Precision::binary64 ? scales_of_binary64 : scales_of_binary32) {
          for (const long offset : {0L, 1000L, 1'000'000L}) {
            auto pair = placed(input, precision, offset, scale);
            if (pair && pair->truth.depth.status() != Status::disjoint) pairs.push_back(std::move(*pair));
          }
        }
      }
    }
    return pairs;
  }();
  return result;
}

void expect_passes(const Placed& pair, const Reply& reply, const Tolerance& tolerance) {
  const Judgement result = judge(pair.truth, reply, {}, pair.precision, tolerance);
  EXPECT_TRUE(passes(result.verdict)) << pair.text << ": " << result.sentence;
}

TEST(RoundedAnswers, PassWithNoToleranceAtAll) {
  std::map<std::string, std::size_t> seen;
  for (const Placed& pair : pairs_everywhere()) {
    const Depth& depth = pair.truth.depth;
    const Rounded nearest{pair.precision};
    for (std::size_t k = 0; k == 0 || k < std::min<std::size_t>(depth.optima().size(), 4); ++k) {
      Reply reply = nearest.answer(depth, k);
      ASSERT_TRUE(std::isfinite(*reply.depth));
      for (const Tolerance& tolerance : {strictest, Tolerance{0, 0, 1}, Tolerance{}})
        expect_passes(pair, reply, tolerance);
      reply.direction.reset();
      expect_passes(pair, reply, strictest);
      ++seen[depth.status() == Status::touching ? "touching" : "penetrating"];
      const double least = pair.precision == Precision::binary64 ? 0x1p-1022 : 0x1p-126;
      seen["subnormal"] += *reply.depth > 0 && *reply.depth < least;
      seen["vanishing"] += depth.squared() > 0 && *reply.depth == 0;
    }
  }
  EXPECT_GT(seen["penetrating"], 1000U);
  EXPECT_GT(seen["touching"], 100U);
  EXPECT_GT(seen["subnormal"], 100U);
}

TEST(RoundedAnswers, RoundedUpOrDownPassWithOneUlp) {
  for (const Placed& pair : pairs_everywhere()) {
    for (const Rounding mode : {Rounding::rd, Rounding::ru}) {
      expect_passes(pair, Rounded{pair.precision, mode}.answer(pair.truth.depth, 0), {0, 0, 1});
    }
  }
}

TEST(RoundedAnswers, ADepthTwoNumbersAwayFails) {
  for (const Placed& pair : pairs_everywhere()) {
    if (pair.truth.depth.status() != Status::penetrating) continue;
    const Rounded nearest{pair.precision};
    Reply reply = testing::overlap(nearest.stepped(nearest.root(pair.truth.depth.squared()), 2));
    EXPECT_EQ(judge(pair.truth, reply, {}, pair.precision, strictest).findings, std::vector<Verdict>{Verdict::too_deep})
        << pair.text;
    EXPECT_TRUE(passes(judge(pair.truth, reply, {}, pair.precision, {0, 0, 5}).verdict)) << pair.text;
  }
}

/// An ulp at the largest coordinate, by asking for it.
double ulp_of_points(const Placed& pair) {
  const double farthest = sizes_of(pair.truth.a, pair.truth.b).farthest.get_d();
  return Rounded{pair.precision}.stepped(farthest, 1) - farthest;
}

/// p, moved along the axis of the largest component of n, by so much.
Triple moved_along(Triple p, const Triple& n, double by) {
  std::size_t i = 0;
  for (std::size_t k = 1; k < 3; ++k) i = std::abs(n[k]) > std::abs(n[i]) ? k : i;
  p[i] += std::copysign(by, n[i] * by);
  return p;
}

TEST(RoundedAnswers, WitnessPointsSixteenUlpsAwayFail) {
  std::size_t compared = 0;
  for (const Placed& pair : pairs_everywhere()) {
    const Reply right = Rounded{pair.precision}.answer(pair.truth.depth, 0);
    const double by = 16 * ulp_of_points(pair);
    if (pair.truth.depth.status() != Status::penetrating || !right.witness_a || !std::isfinite(by)) continue;
    Reply out = right, apart = right;  // out of A against the way that it moves; A's point along it
    out.witness_b.reset();
    out.witness_a = moved_along(*right.witness_a, *right.direction, -by);
    apart.witness_a = moved_along(*right.witness_a, *right.direction, by);
    for (const Reply& reply : {out, apart}) {
      EXPECT_EQ(judge(pair.truth, reply, {}, pair.precision, strictest).findings,
                std::vector<Verdict>{Verdict::witness_off})
          << pair.text;
    }
    ++compared;
  }
  EXPECT_GT(compared, 1000U);
}

// P is 1.4 long along -x and 1 along y; 2 u M = 2.8 u, and the plane across (-1, t) is at 0.6 + t.
TEST(RoundedAnswers, ADirectionFourRoundoffsAwayFails) {
  const Truth& cubes = testing::cubes();
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    const double u = unit_roundoff(precision).get_d(), depth = Rounded{precision}.root(cubes.depth.squared());
    const auto findings = [&](double t) {
      return judge(cubes, testing::overlap(depth, Triple{-1, t, 0}), {}, precision, strictest).findings;
    };
    EXPECT_EQ(findings(2.5 * u), std::vector<Verdict>{});
    EXPECT_EQ(findings(4 * u), std::vector<Verdict>{Verdict::inconsistent});
  }
}

// The bounds are not loose: half of each of them, and a quarter of the direction's, would be too
// little for some rounded answer.
TEST(RoundedAnswers, ReachAGoodPartOfTheSlack) {
  std::map<std::string, std::size_t> beyond;
  for (const Placed& pair : pairs_everywhere()) {
    const Depth& depth = pair.truth.depth;
    if (depth.status() != Status::penetrating) continue;
    const Reply reply = Rounded{pair.precision}.answer(depth, 0);
    const Judgement result = judge(pair.truth, reply, {}, pair.precision, strictest);
    const Slack slack = rounding_slack(sizes_of(pair.truth.a, pair.truth.b), depth.squared(), pair.precision, 0);
    const auto is_more = [](const mpq_class& squared, const mpq_class& length) { return squared > length * length; };
    beyond["depth"] += std::abs(*result.error) > mpq_class(slack.depth * mpq_class(9, 10));
    beyond["direction"] += std::abs(*result.inconsistency) > mpq_class(slack.direction / 4);
    beyond["witness"] += result.witness_a_squared && is_more(*result.witness_a_squared, slack.witness / 2);
    beyond["gap"] += result.witness_gap && *result.witness_gap > mpq_class(slack.gap / 2);
  }
  for (const char* residual : {"depth", "direction", "witness", "gap"}) EXPECT_GT(beyond[residual], 0U) << residual;
}

}  // namespace
}  // namespace fathom::judging
