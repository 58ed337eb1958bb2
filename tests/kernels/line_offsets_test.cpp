// SPDX-License-Identifier: GPL-3.0-or-later
// The offset test against exact distances: on smooth chains with noise that no frame can hold, and with bounds at the distances of pairs.
#include <gtest/gtest.h>

#include <set>

#include "kernels/filters/line_frame.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

// How far corners, and whole lines, are off.
struct Noise {
  long corners, lines;
};

// Chords of a parabola over [-reach, reach] / 2^40, in the xz-plane or, upside down, the yz-plane; noise in multiples of 2^-40.
Scene chain(Random& random, bool across, int n, long reach, const Noise& noise) {
  const auto off = [&](long size) { return mpz_class(size > 0 ? below(random, 2 * size + 1) - size : 0); };
  const auto any = [&](long size) { return Vector{off(size), off(size), off(size)}; };
  std::vector<Vector> points;
  for (long k = 0; k <= n; ++k) {
    const mpz_class x = mpz_class(2 * k - n) * reach / n, z = (mpz_class(1) << 40) - (x * x >> 42);
    points.push_back((across ? Vector{0, x, z} : Vector{x, 0, mpz_class(-z)}) + any(noise.corners));
  }
  std::vector<Line> lines;
  for (std::size_t k = 1; k < points.size(); ++k) lines.push_back({points[k - 1] + any(noise.lines), points[k] - points[k - 1]});
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
    const LineFrame<WideFloat> of_rows = line_frame(wide_rows, row_run), of_columns = line_frame(wide_columns, column_run);
    const auto margin = frames_margin(of_rows, of_columns, b);
    const auto smooth = margin_model(of_rows.smooth(), of_columns.smooth(), b);
    Result result{margin && *margin > 0, {}};
    if (smooth) result.left = pairs_left({wide_rows, row_run, of_rows}, {wide_columns, column_run, of_columns}, b, *smooth, most);
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

// Lines that are off by as much as the smooth chains' distances differ, over a small extent: no box holds that, one number a line does.
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
