// SPDX-License-Identifier: GPL-3.0-or-later
// The filter in wide floats against exact arithmetic: what is thrown out is farther, and little that is farther stays.
#include <gtest/gtest.h>

#include "kernels/filters/line_filter.hpp"
#include "tests/support/exact_floats.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

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
