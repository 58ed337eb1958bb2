// SPDX-License-Identifier: GPL-3.0-or-later
// The filter of the line scans against exact rationals: whatever it leaves out is strictly farther than the bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/filters/line_filter.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

/// Bounds at which a filter would err: the squared distances themselves and their neighbours, and the ends of the range.
std::vector<double> bounds(const Scene& scene, std::size_t one) {
  std::vector<double> result{0, least_normal, 1e-300, 1e-200, 1e-20, 1, std::numeric_limits<double>::max(), infinite};
  for (const Line& m : scene.lines) {
    const Squared s = squared_distance(scene.lines[one], m);
    if (s.denominator == 0) continue;
    const double tie = image_bound(s.numerator, s.denominator, scene.exponent);
    result.insert(result.end(), {tie, std::nextafter(tie, 0), tie * (1 - 0x1p-49), tie * (1 + 0x1p-40), tie * (1 - 0x1p-30), tie / 2});
  }
  return result;
}

TEST(NotFarther, LeavesOutOnlyWhatIsStrictlyFarther) {
  Random random(1);
  std::vector<std::uint32_t> unsure;
  for (int repeat = 0; repeat < 40; ++repeat) {
    for (const Scene& scene : adversarial_scenes(random, 7)) {
      const RoundingMode mode(rounding_modes[std::max(0, repeat - 36)]);
      const LineImages all = images(scene);
      for (std::uint32_t one = 0; one < 3; ++one) {
        for (const double bound : bounds(scene, one)) {
          not_farther(all, one, all, bound, unsure);
          for (const std::uint32_t j : left_out(all.size(), unsure)) {
            ASSERT_TRUE(strictly_farther(scene.lines[one], scene.lines[j], bound, scene.exponent)) << bound << ' ' << scene.exponent;
          }
        }
      }
    }
  }
}

// Two lines with one squared distance D, and D as the bound: the tie must come back, whatever the images make of it.
TEST(NotFarther, ReturnsExactTies) {
  Random random(2);
  std::vector<std::uint32_t> unsure;
  for (int repeat = 0; repeat < 400; ++repeat) {
    const auto digits = static_cast<unsigned long>(below(random, 200) + 40);
    const Scene pair = repeat % 2 ? nearly_meeting_lines(random, digits, 2) : random_lines(random, digits, 2);
    const Line &l = pair.lines[0], &m = pair.lines[1];
    const Squared s = squared_distance(l, m);
    if (s.denominator == 0) continue;
    // The mirror image, and the same lines from other points of theirs.
    const mpz_class along = random_integer(random, 10);
    const std::vector<Line> same{
        m, {m.point, -m.direction}, {m.point + m.direction, m.direction}, {m.point - along * m.direction, m.direction}};
    std::vector<Line> lines{l};
    lines.insert(lines.end(), same.begin(), same.end());
    const Scene ties = scene(lines, 1);
    const LineImages all = images(ties);
    not_farther(all, 0, all, image_bound(s.numerator, s.denominator, ties.exponent), unsure);
    ASSERT_EQ(unsure, all_indices(5));
  }
}

// Where large products cancel the images' errors add up to several units, while the distance is next to nothing.
TEST(NotFarther, ReturnsTiesThatCancellationHides) {
  Random random(13);
  std::vector<std::uint32_t> unsure;
  for (int repeat = 0; repeat < 40000; ++repeat) {
    const Scene pair = nearly_diagonal_lines(random, 57, 2);
    const Squared s = squared_distance(pair.lines[0], pair.lines[1]);
    const LineImages all = images(pair);
    not_farther(all, 0, all, image_bound(s.numerator, s.denominator, pair.exponent), unsure);
    ASSERT_EQ(unsure, all_indices(2));
  }
}

TEST(NotFarther, ReturnsEverythingAtInfinity) {
  Random random(3);
  std::vector<std::uint32_t> unsure;
  for (const Scene& scene : adversarial_scenes(random, 6)) {
    const LineImages all = images(scene);
    not_farther(all, 0, all, infinite, unsure);
    EXPECT_EQ(unsure.size(), all.size());
  }
}

TEST(NotFarther, ReturnsParallelLines) {
  Random random(4);
  std::vector<std::uint32_t> unsure;
  for (int repeat = 0; repeat < 200; ++repeat) {
    const Vector d = random_direction(random, 70);
    std::vector<Line> lines{{random_vector(random, 60), d}};
    for (int i = 0; i < 4; ++i) lines.push_back({random_vector(random, 60), (random_integer(random, 40) * mpz_class(2) + 1) * d});
    const LineImages all = images(scene(std::move(lines)));
    for (const double bound : {0.0, least_normal, 1e-30, 1.0}) {
      not_farther(all, 0, all, bound, unsure);
      EXPECT_EQ(unsure.size(), all.size());
    }
  }
}

// One line alone, and any number beside others: lanes, tails and blocks all compute the same.
TEST(NotFarther, DoesNotDependOnTheNeighbours) {
  Random random(5);
  std::vector<std::uint32_t> unsure, alone;
  for (const int n : {0, 1, 2, 3, 31, 63, 64, 65, 66, 127, 128, 129, 200}) {
    const LineImages one = images(random_lines(random, 60, 1)), many = images(random_lines(random, 60, n));
    LineImages single(60);
    for (const double bound : {1e-4, 1e-2, 1.0}) {
      not_farther(one, 0, many, bound, unsure);
      std::vector<std::uint32_t> expected;
      for (std::uint32_t j = 0; j < many.size(); ++j) {
        single.gather(many, std::span(&j, 1));
        not_farther(one, 0, single, bound, alone);
        if (!alone.empty()) expected.push_back(j);
      }
      EXPECT_EQ(unsure, expected) << n;
    }
  }
}

// Lines in random position with the least of all their distances as bound: almost nothing else comes back.
TEST(NotFarther, LeavesOutNearlyEverything) {
  Random random(6);
  const Scene of_a = random_lines(random, 60, 300), of_b = random_lines(random, 60, 300);
  const LineImages a = images(of_a), b = images(of_b);
  ASSERT_EQ(a.exponent(), b.exponent());
  double least = infinite;
  for (const Line& l : of_a.lines) {
    for (const Line& m : of_b.lines) {
      const Squared s = squared_distance(l, m);
      least = std::min(least, image_bound(s.numerator, s.denominator, a.exponent()));
    }
  }
  std::size_t back = 0;
  std::vector<std::uint32_t> unsure;
  for (std::size_t i = 0; i < a.size(); ++i) {
    not_farther(a, i, b, least, unsure);
    for (std::uint32_t j = 0; j < b.size(); ++j) EXPECT_NE(surely_farther(a, i, b, j, least), std::ranges::binary_search(unsure, j));
    back += unsure.size();
  }
  EXPECT_GE(back, 1U);
  EXPECT_LE(back, 2U);
}

// Well away from parallel and from meeting, the filter tells distances apart that differ by a part in 10^12.
TEST(NotFarther, IsSharp) {
  Random random(7);
  std::vector<std::uint32_t> unsure;
  int tried = 0;
  while (tried < 1000) {
    const Scene pair = random_lines(random, 60, 2);
    const Squared s = squared_distance(pair.lines[0], pair.lines[1]);
    const LineImages all = images(pair);
    const double dx = all.dy[0] * all.dz[1] - all.dz[0] * all.dy[1], dy = all.dz[0] * all.dx[1] - all.dx[0] * all.dz[1];
    const double dz = all.dx[0] * all.dy[1] - all.dy[0] * all.dx[1];
    const double tie = image_bound(s.numerator, s.denominator, pair.exponent), squared_length = dx * dx + dy * dy + dz * dz;
    if (squared_length < 0.25 || tie * squared_length < 0.01) continue;
    ++tried;
    not_farther(all, 0, all, tie * (1 - 1e-12), unsure);
    EXPECT_EQ(unsure, std::vector<std::uint32_t>{0});
  }
}

TEST(LineImages, AreWithinTheStatedError) {
  Random random(8);
  const mpq_class error(0x1p-53);
  for (const int mode : rounding_modes) {
    for (const Scene& scene : adversarial_scenes(random, 10)) {
      const RoundingMode rounding(mode);
      const LineImages all = images(scene);
      ASSERT_EQ(all.size(), scene.lines.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        const auto expect_near = [&](double image, const mpz_class& c, long exponent) {
          mpq_class value(c);
          value >>= static_cast<mp_bitcnt_t>(exponent);
          ASSERT_LE(abs(mpq_class(mpq_class(image) - value)), error);
          ASSERT_LE(std::abs(image), 1);
        };
        const Vector &p = scene.lines[i].point, &d = scene.lines[i].direction;
        expect_near(all.px[i], p.x, scene.exponent);
        expect_near(all.py[i], p.y, scene.exponent);
        expect_near(all.pz[i], p.z, scene.exponent);
        expect_near(all.dx[i], d.x, static_cast<long>(bits(d)));
        expect_near(all.dy[i], d.y, static_cast<long>(bits(d)));
        expect_near(all.dz[i], d.z, static_cast<long>(bits(d)));
        EXPECT_GE(std::max({std::abs(all.dx[i]), std::abs(all.dy[i]), std::abs(all.dz[i])}), 0.5);
      }
    }
  }
}

TEST(LineImages, GatherPicksInTheGivenOrder) {
  Random random(9);
  const LineImages all = images(random_lines(random, 50, 9, 3));
  LineImages some;
  const std::vector<std::uint32_t> chosen{7, 0, 7, 3};
  some.gather(all, chosen);
  ASSERT_EQ(some.size(), 4U);
  EXPECT_EQ(some.exponent(), all.exponent());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(some.px[i], all.px[chosen[i]]);
    EXPECT_EQ(some.py[i], all.py[chosen[i]]);
    EXPECT_EQ(some.pz[i], all.pz[chosen[i]]);
    EXPECT_EQ(some.dx[i], all.dx[chosen[i]]);
    EXPECT_EQ(some.dy[i], all.dy[chosen[i]]);
    EXPECT_EQ(some.dz[i], all.dz[chosen[i]]);
  }
  some.gather(all, std::vector<std::uint32_t>{});
  EXPECT_EQ(some.size(), 0U);
}

TEST(ImageBound, IsATightUpperBound) {
  Random random(10);
  for (int repeat = 0; repeat < 20000; ++repeat) {
    const auto size = [&] { return static_cast<unsigned long>(below(random, repeat % 2 ? 70 : 2500) + 1); };
    const mpz_class numerator = abs(random_integer(random, size())), denominator = abs(random_integer(random, size())) + 1;
    const long exponent = below(random, 1500) - (repeat % 3 ? 0 : 600);
    mpq_class value(numerator, denominator);
    value.canonicalize();
    value = times_power_of_four(value, -exponent);
    const RoundingMode mode(rounding_modes[repeat % 4]);
    const double bound = image_bound(numerator, denominator, exponent);
    if (bound == infinite) {
      ASSERT_GE(value, mpq_class(power_of_two(1000)));
      continue;
    }
    ASSERT_GE(mpq_class(bound), value);
    ASSERT_TRUE(bound == least_normal || mpq_class(bound) <= mpq_class(value * (1 + mpq_class(0x1p-48))));
  }
}

TEST(ImageBound, AtTheEndsOfTheRange) {
  EXPECT_EQ(image_bound(0, 7, 3), least_normal);
  EXPECT_EQ(image_bound(1, power_of_two(5000), 0), least_normal);
  EXPECT_EQ(image_bound(1, power_of_two(1023), 0), least_normal);
  EXPECT_EQ(image_bound(power_of_two(5000), 1, 0), infinite);
  EXPECT_LT(image_bound(power_of_two(5000), 1, 2400), infinite);
  EXPECT_EQ(image_bound(1, 1, 100000), least_normal);
}

}  // namespace
}  // namespace fathom::kernels
