// SPDX-License-Identifier: GPL-3.0-or-later
// The judge over all families: against its naive twin with claims on and beside every border, and
// the laws that every judgement obeys.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/judge/naive_judge.hpp"
#include "tests/judge/pairs.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/random.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {
namespace {

using families::Random;
using testing::opposite;
using testing::right_answer;
using testing::unit;
using Findings = std::vector<Verdict>;

std::vector<Truth> truths(unsigned seeds, unsigned size, Precision precision = Precision::binary64) {
  std::vector<Truth> result;
  for (const Case& input : testing::cases_of_all_families(seeds, size)) {
    auto a = seen(input.a.points, precision), b = seen(input.b.points, precision);
    if (a && b) result.push_back(truth_about(std::move(*a), std::move(*b)));
  }
  return result;
}

/// A number near x: itself rounded, a few steps from it, or not so near.
double near(const mpf_class& x, Random& random) {
  double d = x.get_d();
  const std::int64_t steps = random.between(-3, 3);
  for (std::int64_t i = 0; i < std::abs(steps); ++i) d = std::nextafter(d, steps > 0 ? INFINITY : -INFINITY);
  return random.between(0, 3) == 0 ? d * (1 + 1e-3 * static_cast<double>(random.between(-3, 3))) : d;
}

Tolerance some_tolerance(Random& random) {
  const mpq_class relatives[] = {0, mpq_class(1, 1000), mpq_class(1, 8), 2},
                  absolutes[] = {0, mpq_class(1, 1000000), mpq_class(1, 16)};
  const auto relative = random.between(0, 3), absolute = random.between(0, 2);
  return {relatives[relative], absolutes[absolute],
          static_cast<unsigned long>(random.between(0, 1) * random.between(0, 40))};
}

Triple some_direction(const Depth& depth, Random& random) {
  const auto k = random.between(0, 5);
  if (k == 0) return {0, 0, 0};
  if (k <= 2) {
    const double x = static_cast<double>(random.between(-2, 2)), y = static_cast<double>(random.between(-2, 2));
    return {x, y, static_cast<double>(random.between(-1, 1))};
  }
  const Triple u = unit(depth.direction());
  return k == 3 ? opposite(u) : u;
}

/// Points where the optimum has them, rounded; some moved from their body, or from each other, by
/// what is just allowed, or not quite.
void add_witness(Reply& reply, const Truth& truth, const testing::NaiveJudge& naive, Precision precision,
                 Random& random) {
  if (truth.a.size() > 8 || truth.b.size() > 8) return;
  const Witness points = truth.depth.contact_points();
  const Vector& n = truth.depth.direction();
  const mpf_class length = sqrt(mpf_class(dot(n, n), 600));
  const auto moved = [&](const Point& p, const mpf_class& way) {
    const auto number = [&](const mpq_class& x, const mpz_class& component) {
      const double there = mpf_class(x + way * component / length).get_d();
      return precision == Precision::binary64 ? there : static_cast<float>(there);
    };
    return Triple{number(p.x, n.x), number(p.y, n.y), number(p.z, n.z)};
  };
  const auto some_way = [&] {
    return mpf_class((random.coin() ? naive.witness_tol() : naive.gap_tol()) * static_cast<int>(random.between(-1, 1)));
  };
  if (random.between(0, 3) != 0) reply.witness_a = moved(points.a, some_way());
  if (random.between(0, 3) != 0) reply.witness_b = moved(points.b, some_way());
}

/// Where the bodies meet at the translation, or less than it inside, moved by about the tolerance;
/// depths about that of the reply.
void add_contacts(Reply& reply, const Truth& truth, const testing::NaiveJudge& naive, Precision precision,
                  Random& random) {
  Reply witnesses;
  for (auto i = random.between(0, 2); i >= 0; --i) {
    add_witness(witnesses, truth, naive, precision, random);
    const std::optional<Triple>& position = random.coin() ? witnesses.witness_a : witnesses.witness_b;
    if (!position) continue;
    std::optional<double> depth;
    if (reply.depth && random.coin())
      depth = near(mpf_class(exact_value(*reply.depth)) + naive.depth_tol() * static_cast<int>(random.between(-1, 1)),
                   random);
    if (depth && precision == Precision::binary32) depth = static_cast<float>(*depth);
    reply.contacts.push_back({*position, depth});
  }
}

// Claims are chosen on the borders: at the depth, the separating distance and the exit distance,
// each plus and minus the tolerance.
TEST(JudgeFamilies, AgreesWithItsNaiveTwinOnTheBorders) {
  Random random(11);
  std::size_t compared = 0, failing = 0, off = 0, of_contacts = 0;
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    for (const Truth& truth : truths(1, 6, precision)) {
      for (int i = 0; i < 12; ++i) {
        const Tolerance tolerance = some_tolerance(random);
        Conventions conventions;
        conventions.touching = static_cast<Conventions::Touching>(random.between(0, 2));
        conventions.depth = static_cast<Conventions::Sign>(random.between(0, 1));
        conventions.moves = static_cast<Conventions::Body>(random.between(0, 1));
        conventions.unit = random.coin();
        if (random.coin()) conventions.manifold = ContactLimits();
        const testing::NaiveJudge naive(truth, conventions, precision, tolerance);
        Reply reply;
        reply.overlap = random.between(0, 9) != 0;
        const Triple u = some_direction(truth.depth, random);
        mpf_class target = naive.depth(), tol = naive.depth_tol();
        if (random.coin() && u != Triple{0, 0, 0}) {
          reply.direction = u;
          const double sign = conventions.moves == Conventions::Body::b ? -1 : 1;
          const Point v{exact_value(sign * u[0]), exact_value(sign * u[1]), exact_value(sign * u[2])};
          const auto k = random.between(0, 2);
          if (k == 1) target = naive.separating_distance(v);
          if (k == 2) target = naive.exit_distance(v);
          if (k != 0) tol = naive.direction_tol();
        } else if (random.coin()) {
          reply.direction = u;
        }
        target += tol * static_cast<int>(random.between(-1, 1));
        if (random.between(0, 9) != 0) reply.depth = near(target, random) * (random.between(0, 3) == 0 ? -1 : 1);
        if (random.coin()) add_witness(reply, truth, naive, precision, random);
        if (random.coin()) add_contacts(reply, truth, naive, precision, random);
        const Judgement result = judge(truth, reply, conventions, precision, tolerance);
        EXPECT_EQ(result.findings, naive.findings(reply)) << result.sentence;
        ++compared;
        off += result.contact_a_squared && std::ranges::count(result.findings, Verdict::witness_off) > 0;
        of_contacts += std::ranges::any_of(result.findings, judging::is_of_contacts);
        failing += fails(result.verdict);
      }
    }
  }
  EXPECT_GT(compared, 1000U);
  EXPECT_GT(of_contacts, 50U);
  EXPECT_GT(off, 20U);
  EXPECT_GT(failing, compared / 5);
  EXPECT_LT(failing, compared * 19 / 20);
}

// Bodies that are apart and all others, said to be apart by their distance or by a gap, plus and
// minus the tolerance.
TEST(JudgeFamilies, AgreesWithItsNaiveTwinAboutDistances) {
  Random random(12);
  std::size_t compared = 0, failing = 0, apart = 0;
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    for (const Truth& truth : truths(1, 6, precision)) {
      const bool disjoint = truth.depth.status() == Status::disjoint;
      for (int i = 0; i < (disjoint ? 16 : 1); ++i) {
        const Tolerance tolerance = some_tolerance(random);
        Conventions conventions;
        conventions.depth = static_cast<Conventions::Sign>(random.between(0, 1));
        conventions.moves = static_cast<Conventions::Body>(random.between(0, 1));
        conventions.unit = random.coin();
        const testing::NaiveJudge of_depths(truth, conventions, precision, tolerance),
            naive = of_depths.about_distance();
        Reply reply;
        mpf_class target = naive.distance(), tol = naive.depth_tol();
        const Triple u = some_direction(truth.depth, random);
        if (random.coin()) reply.direction = u;
        if (random.coin() && u != Triple{0, 0, 0}) {
          const double sign = conventions.moves == Conventions::Body::b ? -1 : 1;
          target = -naive.separating_distance(
              {exact_value(sign * u[0]), exact_value(sign * u[1]), exact_value(sign * u[2])});
          tol = naive.direction_tol();
        }
        target += tol * static_cast<int>(random.between(-1, 1));
        reply.distance = near(target, random) * (random.between(0, 5) == 0 ? -1 : 1);
        if (random.coin()) add_witness(reply, truth, naive, precision, random);
        const Judgement result = judge(truth, reply, conventions, precision, tolerance);
        EXPECT_EQ(result.findings, of_depths.findings(reply)) << result.sentence;
        ++compared;
        apart += disjoint;
        failing += fails(result.verdict);
      }
    }
  }
  EXPECT_GT(apart, 150U);
  EXPECT_GT(failing, compared / 5);
  EXPECT_LT(failing, compared * 19 / 20);
}

TEST(JudgeFamilies, RightAnswersPassWithEveryOptimum) {
  std::size_t penetrating = 0;
  for (const Truth& truth : truths(2, 8)) {
    const std::size_t ties = std::max<std::size_t>(truth.depth.optima().size(), 1);
    for (std::size_t k = 0; k < std::min<std::size_t>(ties, 8); ++k) {
      const Judgement result = judge(truth, right_answer(truth.depth, k), {}, Precision::binary64,
                                     {mpq_class(1, 100'000'000), mpq_class(1, 1'000'000'000), 8});
      EXPECT_TRUE(passes(result.verdict)) << result.sentence;
      if (truth.depth.status() != Status::penetrating) continue;
      ++penetrating;
      EXPECT_EQ(result.accuracy, Accuracy::correctly_rounded) << result.sentence;
      EXPECT_LE(*result.exit_distance_squared, *result.separating_distance_squared);
      EXPECT_GE(*result.exit_distance_squared, truth.depth.squared());
    }
  }
  EXPECT_GT(penetrating, 100U);
}

TEST(JudgeFamilies, ScaledAndReversedAnswersFailByName) {
  const Tolerance tolerance{mpq_class(1, 1000), 0, 0};
  std::size_t penetrating = 0, reversible = 0;
  for (const Truth& truth : truths(1, 9)) {
    if (truth.depth.status() != Status::penetrating) continue;
    Reply reply = right_answer(truth.depth);
    reply.witness_a = reply.witness_b = {};
    const auto verdict = [&](const Reply& r) { return judge(truth, r, {}, Precision::binary64, tolerance).verdict; };
    EXPECT_TRUE(passes(verdict(reply)));
    Reply deep = reply, shallow = reply, reversed = reply, negative = reply;
    *deep.depth *= 1.002;
    *shallow.depth *= 0.998;
    *reversed.direction = opposite(*reply.direction);
    *negative.depth *= -1;
    EXPECT_EQ(verdict(deep), Verdict::too_deep);
    EXPECT_EQ(verdict(shallow), Verdict::too_shallow);
    EXPECT_EQ(verdict(negative), Verdict::wrong_sign);
    EXPECT_EQ(verdict(Reply{}), Verdict::false_separation);
    ++penetrating;
    // Where the way back is about as short, the reversed direction is right too.
    const mpq_class back = *judge(truth, reversed).separating_distance_squared;
    const mpq_class slack =
        32 * rounding_slack(sizes_of(truth.a, truth.b), truth.depth.squared(), Precision::binary64, 0).direction;
    if (back < truth.depth.squared() * mpq_class(11, 10) || back < slack * slack) continue;
    EXPECT_EQ(verdict(reversed), Verdict::wrong_sign);
    ++reversible;
  }
  EXPECT_GT(penetrating, 30U);
  EXPECT_GT(reversible, penetrating / 2);
}

TEST(JudgeFamilies, ResidualsAreThoseOfTheClaim) {
  Random random(3);
  for (const Truth& truth : truths(1, 7)) {
    Reply reply = right_answer(truth.depth);
    if (!reply.depth) continue;
    *reply.depth *= 1 + 1e-2 * static_cast<double>(random.between(-50, 50));
    const Judgement result = judge(truth, reply);
    const double depth = root_binary64(truth.depth.squared(), Rounding::rn);
    EXPECT_NEAR(*result.error / depth, *reply.depth / depth - 1, 1e-15);
    EXPECT_NEAR(*result.error_relative, *reply.depth / depth - 1, 1e-15);
    EXPECT_EQ(result.status, truth.depth.status());
    EXPECT_EQ(result.depth_squared, truth.depth.squared());
  }
}

}  // namespace
}  // namespace fathom::judging
