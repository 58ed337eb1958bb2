// SPDX-License-Identifier: GPL-3.0-or-later
// The frame test against exact distances, on smooth chains and on wild lines.
#include "kernels/filters/line_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/filters/line_filter.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

// Chords of the parabola z = -x^2 / 800 in the xz-plane or, upside down, the yz-plane, at nearly equal steps.
Scene chain(Random& random, bool across, int n, long noise) {
  std::vector<Vector> points;
  const long step = 100000;
  for (long k = 0; k <= n; ++k) {
    const mpz_class x = (k - n / 2) * step + (noise ? static_cast<long>(random() % static_cast<std::uint64_t>(noise)) : 0);
    const mpz_class z = mpz_class(1000000) * 1000 - x * x / 8000000;
    points.push_back(across ? Vector{0, x, z} : Vector{x, 0, mpz_class(-z)});
  }
  std::vector<Line> lines;
  for (std::size_t k = 1; k < points.size(); ++k) lines.push_back({points[k - 1], points[k] - points[k - 1]});
  return {31, std::move(lines)};
}

struct Tally {
  int tests = 0, clear = 0, wide = 0;  // wide: cleared in wide floats only
};

void check(const Scene& a, const Scene& b, const mpq_class& bound, Tally& tally, int mode_number) {
  const std::vector<std::uint32_t> rows = all_indices(a.lines.size()), columns = all_indices(b.lines.size());
  bool beyond = false;
  {
    const RoundingMode mode(rounding_modes[mode_number % 4]);
    const double above = image_bound(bound.get_num(), bound.get_den(), a.exponent);
    const bool in_binary64 = frames_beyond(line_frame(images(a), rows), line_frame(images(b), columns), above);
    const std::optional<WideFloat> margin = frames_margin(line_frame(wide_lines(a), rows), line_frame(wide_lines(b), columns),
                                                          wide_bound(bound.get_num(), bound.get_den(), a.exponent));
    beyond = margin && *margin > 0;
    tally.wide += beyond && !in_binary64;
    beyond |= in_binary64;
  }
  ++tally.tests;
  tally.clear += beyond;
  if (!beyond) return;
  for (const Line& l : a.lines) {
    for (const Line& m : b.lines) {
      const Vector w = cross(l.direction, m.direction);
      const mpz_class height = dot(m.point - l.point, w);
      ASSERT_GT(height, 0);
      ASSERT_GT(mpq_class(height * height), bound * dot(w, w));
    }
  }
}

mpq_class least(const Scene& a, const Scene& b) {
  std::optional<mpq_class> least;
  for (const Line& l : a.lines) {
    for (const Line& m : b.lines) {
      const Squared s = squared_distance(l, m);
      if (s.denominator == 0) continue;
      mpq_class squared(s.numerator, s.denominator);
      squared.canonicalize();
      if (!least || squared < *least) least = squared;
    }
  }
  return least.value_or(0);
}

// On smooth chains the test is sharp: it clears a bound a part in 100 below the least distance, and never one at it.
TEST(FramesBeyond, SharpOnSmoothChains) {
  Random random(4);
  Tally below, at;
  for (int n = 0; n < 200; ++n) {
    const int size = 1 + n % 24;
    Scene a = chain(random, false, size, n % 2 ? 50 : 0), b = chain(random, true, size, n % 2 ? 50 : 0);
    if (n % 3 == 0) a = turned(a), b = turned(b);
    const mpq_class distance = least(a, b);
    check(a, b, distance * mpq_class(99, 100), below, n);
    check(a, b, distance, at, n);
  }
  EXPECT_EQ(at.clear, 0);
  EXPECT_GT(below.clear, 150) << "of " << below.tests;
}

// Where the bound is nearer than binary64 can tell: wide floats clear it, up to 2^-100, and never one at the least distance.
TEST(FramesBeyond, WideFramesTellNearerBounds) {
  Random random(14);
  for (const unsigned long digits : {56UL, 70UL, 90UL, 100UL}) {
    Tally tally;
    for (int n = 0; n < 40; ++n) {
      Scene a = chain(random, false, 1, 50), b = chain(random, true, 1, 50);
      if (n % 2 == 0) a = turned(a), b = turned(b);
      check(a, b, least(a, b) * (1 - mpq_class(1, mpz_class(1) << digits)), tally, n);
    }
    EXPECT_EQ(tally.wide, tally.tests) << digits;
  }
}

TEST(FramesBeyond, SoundOnWildLines) {
  Random random(5);
  Tally tally;
  for (int n = 0; n < 60; ++n) {
    const std::vector<Scene> scenes = adversarial_scenes(random, 6);
    for (const Scene& scene : scenes) {
      if (scene.lines.size() < 4) continue;
      const auto half = static_cast<std::ptrdiff_t>(scene.lines.size() / 2);
      const Scene a{scene.exponent, {scene.lines.begin(), scene.lines.begin() + half}};
      const Scene b{scene.exponent, {scene.lines.begin() + half, scene.lines.end()}};
      const Scene one{scene.exponent, {a.lines.front()}}, other{scene.exponent, {b.lines.front()}};
      check(a, b, least(a, b) / 2, tally, n);
      check(one, other, least(one, other) * mpq_class(999, 1000), tally, n);
      check(one, other, least(one, other), tally, n);
    }
  }
  EXPECT_GT(tally.clear, 200) << "of " << tally.tests;
}

TEST(LineFrame, TurningChainsHaveNone) {
  Random random(6);
  Scene scene = random_lines(random, 20, 1);
  scene.lines.push_back({scene.lines[0].point, -scene.lines[0].direction});
  EXPECT_FALSE(line_frame(images(scene), all_indices(2)).valid);
  EXPECT_FALSE(frames_beyond(line_frame(images(scene), all_indices(2)), line_frame(images(scene), all_indices(1)), 0));
}

}  // namespace
}  // namespace fathom::kernels
