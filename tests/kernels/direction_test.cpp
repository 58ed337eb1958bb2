// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures against exact rationals: they hold the value, and are as narrow as stated.
#include "kernels/predicates/direction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>

#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

constexpr double inf = std::numeric_limits<double>::infinity();

std::size_t bits(const mpz_class& c) { return c == 0 ? 0 : mpz_sizeinbase(c.get_mpz_t(), 2); }

std::size_t significant_bits(const mpz_class& c) { return c == 0 ? 0 : bits(c) - mpz_scan1(c.get_mpz_t(), 0); }

/// c * 2^-shift.
mpq_class scaled(const mpz_class& c, std::size_t shift) {
  mpq_class r(c, power_of_two(shift));
  r.canonicalize();
  return r;
}

bool holds(const DoubleInterval& e, const mpq_class& value) { return mpq_class(e.low) <= value && value <= mpq_class(e.high); }

/// How many numbers lie in the enclosure: 4 stands for more than 3.
int width(const DoubleInterval& e) {
  int n = 1;
  for (double x = e.low; x != e.high && n < 4; x = std::nextafter(x, inf)) ++n;
  return n;
}

/// Checks all that enclose() promises, component by component.
void expect_enclosed(const Vector& v) {
  const Vec3<DoubleInterval> e = enclose(v);
  const std::size_t shift = std::max({bits(v.x), bits(v.y), bits(v.z)});
  double largest = 0;
  for (const auto& [c, x] : {std::pair(v.x, e.x), std::pair(v.y, e.y), std::pair(v.z, e.z)}) {
    const mpq_class value = scaled(c, shift);
    ASSERT_TRUE(holds(x, value)) << v << ": " << x.low << " to " << x.high;
    const bool normal = abs(value) >= mpq_class(std::numeric_limits<double>::min());
    const bool exact = c == 0 || (normal && significant_bits(c) <= 53);
    ASSERT_EQ(width(x), exact ? 1 : normal ? 2 : 3) << v << ": " << x.low << " to " << x.high;
    largest = std::max(largest, std::max(std::abs(x.low), std::abs(x.high)));
  }
  EXPECT_GE(largest, 0.5) << v;
  EXPECT_LE(largest, 1) << v;
}

TEST(Enclose, HoldsTheVectorTimesOnePowerOfTwo) {
  for (const Size size : all_sizes) EXPECT_TRUE(rc::check(name(size), [&] { expect_enclosed(*directions(size)); }));
}

TEST(Enclose, IsSymmetricAboutZero) {
  EXPECT_TRUE(rc::check("enclose(-v) = -enclose(v)", [] {
    const Vector v = *directions(Size::mixed);
    const Vec3<DoubleInterval> e = enclose(v), m = enclose(-v);
    RC_ASSERT(e.x.low == -m.x.high && e.x.high == -m.x.low && e.z.low == -m.z.high);
  }));
}

TEST(Enclose, IsAPointUpToFiftyThreeBits) {
  const mpz_class full = power_of_two(53) - 1;
  for (const mpz_class& c : {mpz_class(1), mpz_class(-3), full, mpz_class(full << 900), mpz_class(-full << 13)}) {
    const Vector v{c, 0, 1};
    EXPECT_EQ(width(enclose(v).x), 1) << c;
    expect_enclosed(v);
  }
  for (const mpz_class& c : {mpz_class(full + 2), mpz_class((full << 1) + 1), mpz_class(power_of_two(900) + 1)}) {
    EXPECT_EQ(width(enclose(Vector{c, 0, 1}).x), 2) << c;
    expect_enclosed(Vector{c, 0, 1});
    expect_enclosed(Vector{mpz_class(-c), 0, 1});
  }
  EXPECT_EQ(enclose(Vector{full, 0, 0}).x.low, 1 - 0x1p-53);
  EXPECT_EQ(enclose(Vector{-power_of_two(70), 0, 0}).x.high, -0.5);
}

// Components at every distance around the end of the normal and of the subnormal range, with mantissas that round in every way.
TEST(Enclose, HoldsWhatFallsBelowTheNormalRange) {
  const mpz_class mantissas[] = {1,
                                 3,
                                 power_of_two(52) + 1,
                                 power_of_two(53) - 1,
                                 power_of_two(54) - 1,
                                 power_of_two(80) - 1,
                                 power_of_two(80) + 1,
                                 (power_of_two(52) - 1) << 20};
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    for (const mpz_class& m : mantissas) {
      for (unsigned long top = 1000; top < 1160; ++top) expect_enclosed(Vector{power_of_two(top), m, mpz_class(-m)});
    }
    expect_enclosed(Vector{power_of_two(5000), 1, -7});
  }
  std::fesetround(FE_TONEAREST);
}

// 2^53 - 1 scaled to just below the least normal number, to which ldexp rounds it up.
TEST(Enclose, DoesNotTakeARoundedNumberForAnExactOne) {
  const DoubleInterval e = enclose(Vector{power_of_two(1074), power_of_two(53) - 1, 0}).y;
  EXPECT_LT(e.low, std::numeric_limits<double>::min());
  expect_enclosed(Vector{power_of_two(1074), power_of_two(53) - 1, 0});
}

TEST(Direction, KeepsTheExactVector) {
  const Vector v{power_of_two(300) + 1, -1, 0};
  const Direction d(v);
  EXPECT_EQ(d.exact(), v);
  EXPECT_EQ(d.enclosure().x.low, 0.5);
  EXPECT_EQ(d.enclosure().x.high, std::nextafter(0.5, 1));
  EXPECT_EQ(d.enclosure().z.low, 0);
}

}  // namespace
}  // namespace fathom::kernels
