// SPDX-License-Identifier: GPL-3.0-or-later
// Against exact arithmetic: what is thrown out is farther, and little that is farther stays.
#include "kernels/filters/truncated_lines.hpp"

#include <gtest/gtest.h>

#include "kernels/filters/support.hpp"

namespace fathom::kernels {
namespace {

class RandomLines {
 public:
  explicit RandomLines(unsigned long seed) : random_(gmp_randinit_default) { random_.seed(seed); }

  mpz_class number(unsigned long bits) { return random_.get_z_bits(bits) - (mpz_class(1) << (bits - 1)); }
  Vector vector(unsigned long bits) { return {number(bits), number(bits), number(bits)}; }

 private:
  gmp_randclass random_;
};

struct Line {
  Vector point, direction;
};

/// The squared distance of two lines that are not parallel.
mpq_class squared_distance(const Line& a, const Line& b) {
  const Vector w = cross(a.direction, b.direction);
  const mpz_class height = dot(Vector(b.point - a.point), w);
  mpq_class squared(height * height, dot(w, w));
  squared.canonicalize();
  return squared;
}

bool thrown_out(const Line& a, const Line& b, const mpq_class& squared) {
  const std::vector<Vector> points{a.point, b.point};
  const long exponent = binary_exponent(points);
  TruncatedLines of_a(exponent), of_b(exponent);
  of_a.push_back(a.point, a.direction);
  of_b.push_back(b.point, b.direction);
  return surely_farther(of_a, 0, of_b, 0, of_a.bound(squared.get_num(), squared.get_den()));
}

mpq_class near_one(int sign, int k) { return 1 + mpq_class(sign, mpz_class(1) << k); }

void expect_sound(const Line& a, const Line& b) {
  const mpq_class squared = squared_distance(a, b);
  EXPECT_FALSE(thrown_out(a, b, squared));
  for (const int k : {4, 60, 200, 250, 300}) EXPECT_FALSE(thrown_out(a, b, squared * near_one(1, k))) << k;
}

TEST(TruncatedLines, APairIsThrownOutOnlyIfItIsFarther) {
  RandomLines random(1);
  for (const unsigned long bits : {10UL, 256UL, 257UL, 2000UL}) {
    for (int i = 0; i < 200; ++i) {
      const Line a{random.vector(bits), random.vector(1 + bits / 3)}, b{random.vector(bits), random.vector(bits)};
      if (is_zero(cross(a.direction, b.direction))) continue;
      expect_sound(a, b);
    }
  }
}

TEST(TruncatedLines, APairThatIsFartherByAHairIsThrownOut) {
  RandomLines random(2);
  int thrown = 0;
  for (int i = 0; i < 200; ++i) {
    const Line a{random.vector(2000), random.vector(2000)}, b{random.vector(2000), random.vector(1900)};
    thrown += thrown_out(a, b, squared_distance(a, b) * near_one(-1, 200));
  }
  EXPECT_GT(thrown, 190);
}

// Parallel to within the last bits, or in common coordinates: nothing can be said, and nothing is.
TEST(TruncatedLines, NearlyParallelLinesAreLeft) {
  RandomLines random(3);
  for (int i = 0; i < 200; ++i) {
    const Line a{random.vector(1000), random.vector(1000)};
    for (const unsigned long apart : {1UL, 500UL, 744UL, 760UL, 900UL}) {
      const Line b{random.vector(1000), a.direction + random.vector(apart)};
      if (!is_zero(cross(a.direction, b.direction))) expect_sound(a, b);
      const Line meets{a.point, b.direction};
      EXPECT_FALSE(thrown_out(a, meets, 0));
    }
  }
}

}  // namespace
}  // namespace fathom::kernels
