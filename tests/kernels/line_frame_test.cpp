// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor models against exact rationals: whatever two models hold, their product and sums hold.

#include "kernels/filters/line_frame.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kernels/filters/line_filter.hpp"
#include "tests/support/exact_floats.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;
using taylor::combination;
using taylor::least;
using taylor::operator*;
using error_bound::unit_of;

double any_double(Random& random) {
  return std::ldexp(static_cast<double>(random() % 2000001) - 1000000, -static_cast<int>(random() % 40));
}

template <class Number>
Number any(Random& random) {
  Number x = any_double(random);
  // Digits all the way down.
  if constexpr (std::is_same_v<Number, WideFloat>)
    x = x * (1 + WideFloat(any_double(random)) * 0x1p-70) + any_double(random) * 0x1p-60;
  return x;
}

template <class Number>
TaylorModel<Number> any_model(Random& random) {
  TaylorModel<Number> m;
  for (Number& c : m.c) c = random() % 5 == 0 ? Number(0) : any<Number>(random);
  m.radius = random() % 2 ? std::fabs(any_double(random)) : 0;
  // Radii as small as the numbers' own errors, or they would hide these.
  if (random() % 2) m.radius *= unit_of<Number>;
  return m;
}

template <class Number>
mpq_class polynomial(const TaylorModel<Number>& m, const mpq_class& s, const mpq_class& t) {
  const auto c = [&](std::size_t i) { return exactly(m.c[i]); };
  return c(0) + c(1) * s + c(2) * t + c(3) * s * s + c(4) * s * t + c(5) * t * t;
}

// A value at (s, t) of some function that the model holds.
template <class Number>
mpq_class held(const TaylorModel<Number>& m, const mpq_class& s, const mpq_class& t, Random& random) {
  return polynomial(m, s, t) + mpq_class(m.radius) * mpq_class(static_cast<long>(random() % 3) - 1);
}

mpq_class in_range(Random& random) {
  mpq_class x(static_cast<long>(random() % 2001) - 1000, 1000);
  x.canonicalize();
  return x;
}

template <class Number>
void expect_holds(const TaylorModel<Number>& m, const mpq_class& s, const mpq_class& t, const mpq_class& value) {
  EXPECT_LE(abs(mpq_class(value - polynomial(m, s, t))), mpq_class(m.radius));
}

template <class Number>
class TaylorModels : public ::testing::Test {};
using Numbers = ::testing::Types<double, WideFloat>;
TYPED_TEST_SUITE(TaylorModels, Numbers);

TYPED_TEST(TaylorModels, OperationsHoldWhatTheyShould) {
  using Number = TypeParam;
  Random random(3);
  for (int n = 0; n < 20000; ++n) {
    const TaylorModel<Number> f = any_model<Number>(random), g = any_model<Number>(random);
    const Number a = any<Number>(random), b = any<Number>(random);
    TaylorModel<Number> product, sum;
    Number below = 0;
    {
      const RoundingMode mode(rounding_modes[n % 4]);
      product = f * g;
      sum = combination(a, f, b, g);
      below = least(f);
    }
    const mpq_class s = n % 3 ? in_range(random) : mpq_class(n % 2 ? 1 : -1),
                    t = n % 5 ? in_range(random) : mpq_class(1);
    const mpq_class x = held(f, s, t, random), y = held(g, s, t, random);
    expect_holds(product, s, t, x * y);
    expect_holds(sum, s, t, exactly(a) * x + exactly(b) * y);
    EXPECT_LE(exactly(below), x);
  }
}

TYPED_TEST(TaylorModels, ProductOfSidesIsTheProduct) {
  using Number = TypeParam;
  Random random(4);
  for (int n = 0; n < 20000; ++n) {
    TaylorModel<Number> f = any_model<Number>(random), g = any_model<Number>(random);
    f.c[2] = f.c[4] = f.c[5] = g.c[1] = g.c[3] = g.c[4] = 0;
    const RoundingMode mode(rounding_modes[n % 4]);
    const TaylorModel<Number> product = taylor::product_of_sides(f, g), any = f * g;
    EXPECT_TRUE(product.c == any.c && product.radius == any.radius);
  }
}

// Not just sound: where the square's minimum is known the bound attains it, up to rounding.
TYPED_TEST(TaylorModels, LeastIsAttained) {
  const auto least_of = [](std::array<TypeParam, 6> c) {
    TaylorModel<TypeParam> m;
    m.c = c;
    return truncated(least(m));
  };
  EXPECT_NEAR(least_of({7, 0, 0, 0, 0, 0}), 7, 1e-12);
  EXPECT_NEAR(least_of({0, 1, 2, 0, 0, 0}), -3, 1e-12);
  EXPECT_NEAR(least_of({0, 1, 0, 1, 0, 1}), -0.25, 1e-12);          // at s = -1/2
  EXPECT_NEAR(least_of({0, 0, 0, 1, 2, 1}), 0, 1e-12);              // (s + t)^2
  EXPECT_NEAR(least_of({0, -2, -2, 1, 2, 1}), -1, 1e-12);           // (s + t - 1)^2 - 1
  EXPECT_NEAR(least_of({0, 0, 0, 0, 1, 0}), -1, 1e-12);             // s t
  EXPECT_NEAR(least_of({0, 0, 0, -1, 0, -1}), -2, 1e-12);           // concave: at a corner
  EXPECT_NEAR(least_of({0, 5, 0, 1, 0.5, 1}), -4 - 0.0625, 1e-12);  // at s = -1, t = 1/4
}

// The frame test against exact distances, on smooth chains and on wild lines.

// Chords of the parabola z = -x^2 / 800 in the xz-plane or, upside down, the yz-plane, at nearly
// equal steps.
Scene chain(Random& random, bool across, int n, long noise) {
  std::vector<Vector> points;
  const long step = 100000;
  for (long k = 0; k <= n; ++k) {
    const mpz_class x =
        (k - n / 2) * step + (noise ? static_cast<long>(random() % static_cast<std::uint64_t>(noise)) : 0);
    const mpz_class z = mpz_class(1000000) * 1000 - x * x / 8000000;
    points.push_back(across ? Vector{0, x, z} : Vector{x, 0, mpz_class(-z)});
  }
  std::vector<Line> lines;
  for (std::size_t k = 1; k < points.size(); ++k) lines.push_back({points[k - 1], points[k] - points[k - 1]});
  return {31, std::move(lines)};
}

struct FrameTally {
  int tests = 0, clear = 0, wide = 0;  // wide: cleared in wide floats only
};

void check(const Scene& a, const Scene& b, const mpq_class& bound, FrameTally& tally, int mode_number) {
  const std::vector<std::uint32_t> rows = all_indices(a.lines.size()), columns = all_indices(b.lines.size());
  bool beyond = false;
  {
    const RoundingMode mode(rounding_modes[mode_number % 4]);
    const double above = image_bound(bound.get_num(), bound.get_den(), a.exponent);
    const bool in_binary64 = frames_beyond(line_frame(images(a), rows), line_frame(images(b), columns), above);
    const std::optional<WideFloat> margin =
        frames_margin(line_frame(wide_lines(a), rows), line_frame(wide_lines(b), columns),
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

// On smooth chains the test is sharp: it clears a bound a part in 100 below the least distance, and
// never one at it.
TEST(FramesBeyond, SharpOnSmoothChains) {
  Random random(4);
  FrameTally below, at;
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

// Where the bound is nearer than binary64 can tell: wide floats clear it, up to 2^-100, and never
// one at the least distance.
TEST(FramesBeyond, WideFramesTellNearerBounds) {
  Random random(14);
  for (const unsigned long digits : {56UL, 70UL, 90UL, 100UL}) {
    FrameTally tally;
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
  FrameTally tally;
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

// The offset test against exact distances: on smooth chains with noise that no frame can hold, and
// with bounds at the distances of pairs.

// How far corners, and whole lines, are off.
struct Noise {
  long corners, lines;
};

// Chords of a parabola over [-reach, reach] / 2^40, in the xz-plane or, upside down, the yz-plane;
// noise in multiples of 2^-40.
Scene chain(Random& random, bool across, int n, long reach, const Noise& noise) {
  const auto off = [&](long size) { return mpz_class(size > 0 ? below(random, 2 * size + 1) - size : 0); };
  const auto any = [&](long size) { return Vector{off(size), off(size), off(size)}; };
  std::vector<Vector> points;
  for (long k = 0; k <= n; ++k) {
    const mpz_class x = mpz_class(2 * k - n) * reach / n, z = (mpz_class(1) << 40) - (x * x >> 42);
    points.push_back((across ? Vector{0, x, z} : Vector{x, 0, mpz_class(-z)}) + any(noise.corners));
  }
  std::vector<Line> lines;
  for (std::size_t k = 1; k < points.size(); ++k)
    lines.push_back({points[k - 1] + any(noise.lines), points[k] - points[k - 1]});
  return {42, std::move(lines)};
}

// Two chains as wide lines, oriented so that all heights are positive.
struct Block {
  Scene rows, columns;
  WideLines wide_rows, wide_columns;
  std::vector<std::uint32_t> row_run, column_run;

  Block(Scene a, Scene b)
      : rows(std::move(a)),
        columns(std::move(b)),
        wide_rows(wide_lines(rows)),
        wide_columns(wide_lines(columns)),
        row_run(all_indices(rows.lines.size())),
        column_run(all_indices(columns.lines.size())) {}

  [[nodiscard]] mpq_class squared(std::size_t i, std::size_t j) const {
    const Squared s = squared_distance(rows.lines[i], columns.lines[j]);
    mpq_class result(s.numerator, s.denominator);
    result.canonicalize();
    return result;
  }
  [[nodiscard]] std::size_t pairs() const { return row_run.size() * column_run.size(); }

  struct Result {
    bool framed = false;  // the frame test, in wide floats, clears the block
    std::optional<std::vector<LinePair>> left;
  };
  [[nodiscard]] Result test(const mpq_class& bound, std::size_t most) const {
    const WideFloat b = wide_bound(bound.get_num(), bound.get_den(), rows.exponent);
    const LineFrame<WideFloat> of_rows = line_frame(wide_rows, row_run),
                               of_columns = line_frame(wide_columns, column_run);
    const auto margin = frames_margin(of_rows, of_columns, b);
    const auto smooth = margin_model(of_rows.smooth(), of_columns.smooth(), b);
    Result result{margin && *margin > 0, {}};
    if (smooth)
      result.left = pairs_left({wide_rows, row_run, of_rows}, {wide_columns, column_run, of_columns}, b, *smooth, most);
    return result;
  }
};

Block block(Random& random, int n, long reach, const Noise& noise) {
  return {chain(random, false, n, reach, noise), chain(random, true, n, reach, noise)};
}

Block turned_block(Random& random, int n, long reach, const Noise& noise) {
  return {turned(chain(random, false, n, reach, noise)), turned(chain(random, true, n, reach, noise))};
}

TEST(PairsLeft, HoldEveryPairThatIsAsNear) {
  Random random(8);
  std::size_t tests = 0, kept = 0, all = 0;
  for (int n = 0; n < 400; ++n) {
    const int size = 2 + n % 12;
    const long reach = 1L << (22 + n % 16);
    const Noise noise{n % 3 == 0 ? 0 : std::min(1L << (n % 30), reach / (8 * size)), n % 2 == 0 ? 0 : 1L << (n % 36)};
    const Block b = n % 4 < 2 ? block(random, size, reach, noise) : turned_block(random, size, reach, noise);
    for (int k = 0; k < 6; ++k) {
      const std::size_t i = random() % b.row_run.size(), j = random() % b.column_run.size();
      const mpq_class bound = b.squared(i, j);
      const RoundingMode mode(rounding_modes[k % 4]);
      const auto left = b.test(bound, b.pairs()).left;
      if (!left) continue;
      ++tests;
      kept += left->size();
      all += b.pairs();
      const std::set<LinePair> listed(left->begin(), left->end());
      EXPECT_EQ(listed.size(), left->size()) << "a pair is listed twice";
      for (const std::uint32_t r : b.row_run) {
        for (const std::uint32_t c : b.column_run) {
          if (listed.contains({r, c})) continue;
          ASSERT_GT(b.squared(r, c), bound) << "pair " << r << ", " << c << " of block " << n;
        }
      }
    }
  }
  EXPECT_GT(tests, 1500U);
  EXPECT_LT(kept, all * 9 / 10) << "it throws out pairs, too";
}

// Lines that are off by as much as the smooth chains' distances differ, over a small extent: no box
// holds that, one number a line does.
TEST(PairsLeft, AreFewWhereNoFrameClears) {
  Random random(9);
  int tests = 0;
  for (int n = 0; n < 40; ++n) {
    const Noise noise{0, 1L << 20};
    const Block b = n % 2 == 0 ? block(random, 32, 1L << 30, noise) : turned_block(random, 32, 1L << 30, noise);
    mpq_class least = b.squared(0, 0);
    for (const std::uint32_t i : b.row_run)
      for (const std::uint32_t j : b.column_run) least = std::min(least, b.squared(i, j));
    const Block::Result result = b.test(least, b.pairs());
    ASSERT_TRUE(result.left.has_value());
    EXPECT_FALSE(result.framed);
    EXPECT_LE(result.left->size(), 32U);
    EXPECT_GE(result.left->size(), 1U);
    // It gives up where more would be left than it may leave, and only there.
    EXPECT_EQ(b.test(least, result.left->size()).left, result.left);
    EXPECT_EQ(b.test(least, result.left->size() - 1).left, std::nullopt);
    ++tests;
  }
  EXPECT_EQ(tests, 40);
}

TEST(PairsLeft, NothingIsSaidWithoutFrames) {
  Random random(10);
  Scene scene = random_lines(random, 20, 1);
  scene.lines.push_back({scene.lines[0].point, -scene.lines[0].direction});
  const WideLines lines = wide_lines(scene);
  const std::vector<std::uint32_t> run = all_indices(2);
  const LineFrame<WideFloat> none = line_frame(lines, run);
  EXPECT_FALSE(none.valid);
  EXPECT_EQ(pairs_left({lines, run, none}, {lines, run, none}, 0, {}, 100), std::nullopt);
  // Parallel runs: w is 0.
  const std::vector<std::uint32_t> one = all_indices(1);
  const LineFrame<WideFloat> single = line_frame(lines, one);
  EXPECT_EQ(pairs_left({lines, one, single}, {lines, one, single}, 0, {}, 100), std::nullopt);
}

}  // namespace
}  // namespace fathom::kernels
