// SPDX-License-Identifier: GPL-3.0-or-later
// The filter of the line scans against exact rationals: whatever it leaves out is strictly farther
// than the bound.

#include "kernels/filters/line_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/gaussian/gaussian_diagram.hpp"
#include "tests/support/exact_floats.hpp"
#include "tests/support/line_scenes.hpp"
#include "tests/support/signs.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

/// Bounds at which a filter would err: the squared distances themselves and their neighbours, and
/// the ends of the range.
std::vector<double> bounds(const Scene& scene, std::size_t one) {
  std::vector<double> result{0, least_normal, 1e-300, 1e-200, 1e-20, 1, std::numeric_limits<double>::max(), infinite};
  for (const Line& m : scene.lines) {
    const Squared s = squared_distance(scene.lines[one], m);
    if (s.denominator == 0) continue;
    const double tie = image_bound(s.numerator, s.denominator, scene.exponent);
    result.insert(result.end(), {tie, std::nextafter(tie, 0), tie * (1 - 0x1p-49), tie * (1 + 0x1p-40),
                                 tie * (1 - 0x1p-30), tie / 2});
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
            ASSERT_TRUE(strictly_farther(scene.lines[one], scene.lines[j], bound, scene.exponent))
                << bound << ' ' << scene.exponent;
          }
        }
      }
    }
  }
}

// Two lines with one squared distance D, and D as the bound: the tie must come back, whatever the
// images make of it.
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

// Where large products cancel the images' errors add up to several units, while the distance is
// next to nothing.
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
    for (int i = 0; i < 4; ++i)
      lines.push_back({random_vector(random, 60), (random_integer(random, 40) * mpz_class(2) + 1) * d});
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

// Lines in random position with the least of all their distances as bound: almost nothing else
// comes back.
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
    for (std::uint32_t j = 0; j < b.size(); ++j)
      EXPECT_NE(surely_farther(a, i, b, j, least), std::ranges::binary_search(unsure, j));
    back += unsure.size();
  }
  EXPECT_GE(back, 1U);
  EXPECT_LE(back, 2U);
}

// Well away from parallel and from meeting, the filter tells distances apart that differ by a part
// in 10^12.
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
    const double tie = image_bound(s.numerator, s.denominator, pair.exponent),
                 squared_length = dx * dx + dy * dy + dz * dz;
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
    const mpz_class numerator = abs(random_integer(random, size())),
                    denominator = abs(random_integer(random, size())) + 1;
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

// The filter of the scan over pairs of arcs against exact signs: whatever it leaves out does not
// cross, or is strictly farther.

/// Arcs of a diagram of rank 3, with lines along their circles' normals.
struct Arcs {
  gaussian::GaussianDiagram diagram;
  std::vector<Line> lines;
  [[nodiscard]] const gaussian::Arc& arc(std::size_t i) const {
    return diagram.arcs[gaussian::ArcId(static_cast<std::uint32_t>(i))];
  }
};

/// Arcs of small integers, rank 3 or (half-circles between the poles) rank 2: shared ends, ends on
/// circles, overlaps.
Arcs random_arcs(Random& random, int rank, unsigned long size, int n) {
  Arcs arcs;
  arcs.diagram.rank = rank;
  const auto add = [&](const Vector& from, const Vector& to, const Vector& circle) {
    const auto node = static_cast<std::uint32_t>(arcs.diagram.nodes.size());
    arcs.diagram.nodes.emplace_back(from);
    arcs.diagram.nodes.emplace_back(to);
    arcs.diagram.arcs.push_back({Direction(circle), gaussian::NodeId(node), gaussian::NodeId(node + 1), {}, {}});
    arcs.lines.push_back({random_vector(random, size), circle});
  };
  const Vector pole = random_direction(random, size);
  while (arcs.lines.size() < static_cast<std::size_t>(n)) {
    const Vector from = rank == 2 ? pole : random_direction(random, size), other = random_direction(random, size);
    const Vector circle = cross(from, other);
    if (!is_zero(circle)) add(from, rank == 2 ? -pole : other, circle);
  }
  return arcs;
}

ArcImages arc_images(const gaussian::GaussianDiagram& diagram) {
  ArcImages result;
  for (const gaussian::Arc& arc : diagram.arcs)
    result.push_back(diagram.nodes[arc.from].exact(), diagram.nodes[arc.to].exact());
  return result;
}

/// Calls check(i, j, whether the pair came back) for all pairs of two sets of arcs.
template <class Check>
void scan_arcs(const Arcs& one, const Arcs& many, double bound, const Check& check) {
  const std::size_t size = std::max(bits(one.lines[0].point), bits(many.lines[0].point)) + 60;
  const LineImages a = images(Scene{static_cast<long>(size), one.lines}),
                   b = images(Scene{static_cast<long>(size), many.lines});
  const ArcImages arcs_a = arc_images(one.diagram), arcs_b = arc_images(many.diagram);
  std::vector<std::uint32_t> unsure;
  for (std::size_t i = 0; i < a.size(); ++i) {
    crossing_and_not_farther({a, arcs_a}, i, {b, arcs_b}, bound, unsure);
    const std::vector<std::uint32_t> out = left_out(b.size(), unsure);
    for (const std::uint32_t j : unsure) check(i, j, true);
    for (const std::uint32_t j : out) check(i, j, false);
  }
}

// With small integers the images' products are exact up to much less than the least product: the
// filter decides as exact signs would.
TEST(CrossingAndNotFarther, KeepsThePairsThatTouchAndNoOthers) {
  Random random(11);
  int kept = 0, dropped = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    const Arcs one = random_arcs(random, 2 + repeat % 2, 3, 12), many = random_arcs(random, 2 + repeat / 2 % 2, 3, 70);
    scan_arcs(one, many, infinite, [&](std::size_t i, std::uint32_t j, bool back) {
      const gaussian::Arc &e = one.arc(i), &f = many.arc(j);
      const bool parallel = is_zero(cross(e.circle.exact(), f.circle.exact()));
      ASSERT_EQ(back, parallel || gaussian::touch(one.diagram, e, many.diagram, f));
      ASSERT_TRUE(back || gaussian::strict_crossings(unperturbed().kernel, one.diagram, e, many.diagram, f).empty());
      ++(back ? kept : dropped);
    });
  }
  EXPECT_GT(kept, 5000);
  EXPECT_GT(dropped, 20000);
}

TEST(CrossingAndNotFarther, KeepsWhatBothTestsKeep) {
  Random random(13);
  std::vector<std::uint32_t> crossing, near, both, expected;
  for (int repeat = 0; repeat < 30; ++repeat) {
    const Arcs one = random_arcs(random, 3, 30, 5), many = random_arcs(random, 3, 30, 131);
    const LineImages a = images(Scene{30, one.lines}), b = images(Scene{30, many.lines});
    const ArcImages arcs_a = arc_images(one.diagram), arcs_b = arc_images(many.diagram);
    for (std::size_t i = 0; i < a.size(); ++i) {
      crossing_and_not_farther({a, arcs_a}, i, {b, arcs_b}, infinite, crossing);
      for (const double bound : {least_normal, 0.01, 0.3}) {
        not_farther(a, i, b, bound, near);
        crossing_and_not_farther({a, arcs_a}, i, {b, arcs_b}, bound, both);
        expected.clear();
        std::set_intersection(crossing.begin(), crossing.end(), near.begin(), near.end(), std::back_inserter(expected));
        ASSERT_EQ(both, expected);
      }
    }
  }
}

TEST(CrossingAndNotFarther, LeavesOutOnlyWhatDoesNotCrossOrIsFarther) {
  Random random(12);
  int near = 0, far = 0;
  for (int repeat = 0; repeat < 40; ++repeat) {
    const unsigned long size = repeat % 4 == 0 ? 4 : repeat % 4 == 1 ? 30 : 400;
    const Arcs one = random_arcs(random, 2 + repeat % 2, size, 6);
    Arcs many = random_arcs(random, 3, size, 30);
    // Ends one unit off the circles of the others.
    for (std::uint32_t k = 0; k < 20; ++k) {
      const Vector& circle = one.lines[k % 6].direction;
      const Vector end = cross(circle, random_direction(random, size)) + random_vector(random, 1);
      const Vector other = many.diagram.nodes[many.diagram.arcs[gaussian::ArcId(k)].to].exact(),
                   normal = cross(end, other);
      if (is_zero(normal)) continue;
      many.diagram.nodes[many.diagram.arcs[gaussian::ArcId(k)].from] = Direction(end);
      many.diagram.arcs[gaussian::ArcId(k)].circle = Direction(normal);
      many.lines[k].direction = normal;
    }
    const long exponent = static_cast<long>(std::max(bits(one.lines[0].point), bits(many.lines[0].point)) + 60);
    const Squared tie = squared_distance(one.lines[1], many.lines[3]);
    if (tie.denominator == 0) continue;
    for (const double bound : {infinite, image_bound(tie.numerator, tie.denominator, exponent), least_normal}) {
      const RoundingMode mode(rounding_modes[repeat / 2 % 4]);
      scan_arcs(one, many, bound, [&](std::size_t i, std::uint32_t j, bool back) {
        const gaussian::Arc &e = one.arc(i), &f = many.arc(j);
        ++(back ? near : far);
        ASSERT_TRUE(back || !gaussian::touch(one.diagram, e, many.diagram, f) ||
                    strictly_farther(one.lines[i], many.lines[j], bound, exponent));
      });
    }
  }
  EXPECT_GT(near, 500);
  EXPECT_GT(far, 5000);
}

// The vertex test's filter against exact integers, on lines that are hard for it, in all rounding
// modes.

// <s,w> > 0 and <s,w>^2 > bound |w|^2 at all corners of the lines i, i' and j, j'.
bool exactly_beyond(const Line& p, const Line& q, const std::array<const Line*, 2>& rows,
                    const std::array<const Line*, 2>& columns, const mpq_class& bound) {
  for (const Line* i : rows) {
    for (const Line* j : columns) {
      const Vector w = cross(i->direction, j->direction);
      const mpz_class height = dot(q.point - p.point, w);
      if (height <= 0 || mpq_class(height * height) <= bound * dot(w, w)) return false;
    }
  }
  return true;
}

TEST(CornersBeyond, VerdictsAreThoseOfExactArithmetic) {
  Random random(8);
  std::size_t beyond = 0, within = 0, unsure = 0;
  for (int repeat = 0; repeat < 80; ++repeat) {
    for (const Scene& scene : adversarial_scenes(random, 6)) {
      const LineImages all = images(scene);
      const std::size_t n = scene.lines.size();
      if (n < 6) continue;
      for (int k = 0; k < 12; ++k) {
        // Rows and columns of two lines each, the difference from any two; the bound from one of
        // the four crossings.
        const std::size_t i = random() % (n - 1), j = random() % (n - 1), of_a = random() % n, of_b = random() % n;
        const Line &p = scene.lines[of_a], &q = scene.lines[of_b];
        const Vector w = cross(scene.lines[i].direction, scene.lines[j].direction);
        const mpz_class height = dot(q.point - p.point, w), square = dot(w, w);
        if (square == 0) continue;
        mpz_class numerator = height * height, denominator = square;
        if (k % 3 == 1) numerator *= 2;
        if (k % 3 == 2) denominator *= 1000;
        LineBound bound;
        CornerVerdict verdict;
        {
          const RoundingMode mode(rounding_modes[k % 4]);
          bound = line_bound(numerator, denominator, scene.exponent);
          verdict = corners_beyond(all, all, {{i, of_a, i + 1}, {j, of_b, j + 1}}, bound);
        }
        const mpq_class exact = mpq_class(numerator) / mpq_class(denominator);
        EXPECT_LE(mpq_class(bound.below), times_power_of_four(exact, -scene.exponent));
        const bool truth =
            exactly_beyond(p, q, {&scene.lines[i], &scene.lines[i + 1]}, {&scene.lines[j], &scene.lines[j + 1]}, exact);
        ASSERT_TRUE(truth || verdict != CornerVerdict::beyond);
        ASSERT_TRUE(!truth || verdict != CornerVerdict::within);
        beyond += verdict == CornerVerdict::beyond;
        within += verdict == CornerVerdict::within;
        unsure += verdict == CornerVerdict::unsure;
      }
    }
  }
  EXPECT_GT(beyond, 100U);
  EXPECT_GT(within, 5000U);
  EXPECT_GT(unsure, 100U);
}

TEST(CornersBeyond, AnInfiniteBoundIsNeverPassed) {
  Random random(9);
  const Scene scene = random_lines(random, 30, 8);
  const LineImages all = images(scene);
  for (std::size_t i = 0; i < 7; ++i)
    EXPECT_NE(corners_beyond(all, all, {{i, i, i + 1}, {0, 0, 1}}, {infinite, 0}), CornerVerdict::beyond);
}

// The filter in wide floats against exact arithmetic: what is thrown out is farther, and little
// that is farther stays.

class RandomLines {
 public:
  explicit RandomLines(unsigned long seed) : random_(gmp_randinit_default) { random_.seed(seed); }

  mpz_class number(unsigned long bits) { return random_.get_z_bits(bits) - (mpz_class(1) << (bits - 1)); }
  Vector vector(unsigned long bits) { return {number(bits), number(bits), number(bits)}; }

 private:
  gmp_randclass random_;
};

mpq_class distance(const Line& a, const Line& b) {
  const Squared s = squared_distance(a, b);
  mpq_class squared(s.numerator, s.denominator);
  squared.canonicalize();
  return squared;
}

bool thrown_out(const Line& a, const Line& b, const mpq_class& squared) {
  const long exponent = scene({a, b}).exponent;
  return surely_farther(wide_line(a.point, a.direction, exponent), wide_line(b.point, b.direction, exponent),
                        wide_bound(squared.get_num(), squared.get_den(), exponent));
}

mpq_class near_one(int sign, int k) { return 1 + mpq_class(sign, mpz_class(1) << k); }

void expect_sound(const Line& a, const Line& b) {
  const mpq_class squared = distance(a, b);
  EXPECT_FALSE(thrown_out(a, b, squared));
  for (const int k : {4, 60, 100, 110, 118, 300}) EXPECT_FALSE(thrown_out(a, b, squared * near_one(1, k))) << k;
}

TEST(WideFilter, APairIsThrownOutOnlyIfItIsFarther) {
  RandomLines random(1);
  for (const unsigned long bits : {10UL, 53UL, 122UL, 123UL, 2000UL}) {
    for (int i = 0; i < 400; ++i) {
      const Line a{random.vector(bits), random.vector(1 + bits / 3)}, b{random.vector(bits), random.vector(bits)};
      if (is_zero(cross(a.direction, b.direction))) continue;
      const RoundingMode mode(rounding_modes[i % 4]);
      expect_sound(a, b);
    }
  }
}

TEST(WideFilter, SoundOnWildLines) {
  Random random(6);
  for (int n = 0; n < 6; ++n) {
    for (const Scene& s : adversarial_scenes(random, 8)) {
      for (std::size_t i = 0; i < s.lines.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (!is_zero(cross(s.lines[i].direction, s.lines[j].direction))) expect_sound(s.lines[i], s.lines[j]);
          else EXPECT_FALSE(thrown_out(s.lines[i], s.lines[j], 0)) << "parallel";
        }
      }
    }
  }
}

TEST(WideFilter, APairThatIsFartherByAHairIsThrownOut) {
  RandomLines random(2);
  int thrown = 0;
  for (int i = 0; i < 200; ++i) {
    const Line a{random.vector(2000), random.vector(2000)}, b{random.vector(2000), random.vector(1900)};
    thrown += thrown_out(a, b, distance(a, b) * near_one(-1, 100));
  }
  EXPECT_GT(thrown, 190);
}

// Parallel to within the last bits, or meeting: nothing can be said, and nothing is.
TEST(WideFilter, NearlyParallelLinesAreLeft) {
  RandomLines random(3);
  for (int i = 0; i < 200; ++i) {
    const Line a{random.vector(1000), random.vector(1000)};
    for (const unsigned long apart : {1UL, 500UL, 870UL, 890UL, 960UL}) {
      const Line b{random.vector(1000), a.direction + random.vector(apart)};
      if (!is_zero(cross(a.direction, b.direction))) expect_sound(a, b);
      const Line meets{a.point, b.direction};
      EXPECT_FALSE(thrown_out(a, meets, 0));
    }
  }
}

TEST(WideBound, IsAboveAndClose) {
  RandomLines random(4);
  for (int i = 0; i < 500; ++i) {
    const mpz_class n = abs(random.number(900 + static_cast<unsigned long>(i) / 2)), d = abs(random.number(1000)) + 1;
    mpq_class exact(n, d);
    exact.canonicalize();
    const mpq_class bound = exactly(wide_bound(n, d, 0));
    EXPECT_GE(bound, exact);
    EXPECT_LE(bound, exact * near_one(1, 113));
  }
}

TEST(WideLines, AreMadeWhenAskedForAndOnce) {
  Random random(5);
  const Scene s = random_lines(random, 200, 20);
  std::vector<int> made(20, 0);
  const WideLines lines(20, [&](std::size_t i) {
    ++made[i];
    return wide_line(s.lines[i].point, s.lines[i].direction, s.exponent);
  });
  const Vec3<WideFloat>& first = lines.point(7);
  for (const std::size_t i : {7UL, 3UL, 7UL, 19UL, 3UL}) {
    const WideLine expected = wide_line(s.lines[i].point, s.lines[i].direction, s.exponent);
    EXPECT_TRUE(lines[i].point.x == expected.point.x && lines[i].direction.z == expected.direction.z);
  }
  EXPECT_EQ(&first, &lines.point(7)) << "lines stay where they are";
  EXPECT_EQ(made[7] + made[3] + made[19], 3);
  EXPECT_EQ(std::count(made.begin(), made.end(), 0), 17);
}

}  // namespace
}  // namespace fathom::kernels
