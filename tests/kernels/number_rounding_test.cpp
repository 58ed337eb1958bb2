// SPDX-License-Identifier: GPL-3.0-or-later
// Correct rounding against a twin that does not cut: it bisects over all floating-point numbers in
// order and asks exact questions only (is x <= q? is x^2 <= q?).
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "tests/support/full_size.hpp"
#include "tests/support/property.hpp"

namespace fathom::kernels {
namespace {

using testing::random_in;
using testing::random_word;
using testing::square;

mpq_class two_to(long exponent) {
  mpq_class one = 1;
  return exponent < 0 ? mpq_class(one >> static_cast<mp_bitcnt_t>(-exponent))
                      : mpq_class(one << static_cast<mp_bitcnt_t>(exponent));
}

mpq_class ratio(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

/// The finite numbers x >= 0 of a format are those of its bit patterns 0 .. last, in the same
/// order.
template <class Float>
struct Patterns;
template <>
struct Patterns<double> {
  using Bits = std::uint64_t;
  static constexpr long top = 1024;
};
template <>
struct Patterns<float> {
  using Bits = std::uint32_t;
  static constexpr long top = 128;
};

/// The exact value; infinity stands for 2^top, the number that would follow the largest.
template <class Float>
mpq_class value_of(Float x) {
  return std::isinf(x) ? two_to(Patterns<Float>::top) : exact_value(x);
}

template <class Float>
struct Neighbours {
  Float rd, ru, rn;
};

/// Whether x stands left of (-1), at (0) or right of (1) the number that was asked for.
int side_of_value(const mpq_class& x, const mpq_class& q) { return cmp(x, q); }
int side_of_root(const mpq_class& x, const mpq_class& q) { return cmp(square(x), q); }
using Side = int (*)(const mpq_class&, const mpq_class&);

template <class Float>
Neighbours<Float> naive(const mpq_class& q, Side side) {
  using Bits = typename Patterns<Float>::Bits;
  const auto number = [](Bits bits) { return std::bit_cast<Float>(bits); };
  Bits low = 0,
       high =
           std::bit_cast<Bits>(std::numeric_limits<Float>::infinity());  // low <= the number; high, or infinity, above
  while (high - low > 1) {
    const Bits middle = low + (high - low) / 2;
    (side(value_of(number(middle)), q) <= 0 ? low : high) = middle;
  }
  if (side(value_of(number(low)), q) == 0) return {number(low), number(low), number(low)};
  const int half = side(mpq_class((value_of(number(low)) + value_of(number(high))) / 2), q);
  const bool to_low = half > 0 || (half == 0 && low % 2 == 0);
  return {number(low), number(high), number(to_low ? low : high)};
}

template <class Float>
Neighbours<Float> rounded_value(const mpq_class& q) {
  if constexpr (std::is_same_v<Float, double>) {
    return {round_binary64(q, Rounding::rd), round_binary64(q, Rounding::ru), round_binary64(q, Rounding::rn)};
  } else {
    return {round_binary32(q, Rounding::rd), round_binary32(q, Rounding::ru), round_binary32(q, Rounding::rn)};
  }
}

template <class Float>
Neighbours<Float> rounded_root(const mpq_class& q) {
  if constexpr (std::is_same_v<Float, double>) {
    return {root_binary64(q, Rounding::rd), root_binary64(q, Rounding::ru), root_binary64(q, Rounding::rn)};
  } else {
    return {root_binary32(q, Rounding::rd), root_binary32(q, Rounding::ru), root_binary32(q, Rounding::rn)};
  }
}

template <class Float>
bool same(const Neighbours<Float>& a, const Neighbours<Float>& b) {
  using Bits = typename Patterns<Float>::Bits;
  return std::bit_cast<Bits>(a.rd) == std::bit_cast<Bits>(b.rd) &&
         std::bit_cast<Bits>(a.ru) == std::bit_cast<Bits>(b.ru) &&
         std::bit_cast<Bits>(a.rn) == std::bit_cast<Bits>(b.rn);
}

template <class Float>
Neighbours<Float> in_order(const EveryMode<Float>& rounded) {
  return {rounded.rd, rounded.ru, rounded.rn};
}

/// All roundings at once are those one by one.
bool at_once(const mpq_class& q) {
  const Roundings value = roundings(q), negative = roundings(mpq_class(-q)), root = roundings_of_root(q);
  return same(in_order(value.binary64), rounded_value<double>(q)) &&
         same(in_order(value.binary32), rounded_value<float>(q)) &&
         same(in_order(negative.binary64), rounded_value<double>(mpq_class(-q))) &&
         same(in_order(negative.binary32), rounded_value<float>(mpq_class(-q))) &&
         same(in_order(root.binary64), rounded_root<double>(q)) &&
         same(in_order(root.binary32), rounded_root<float>(q));
}

/// The four doors on one number, against the twin.
void expect_as_naive(const mpq_class& q) {
  const auto told = [&](const char* what) { return std::string(what) + " of " + exact_text(q).substr(0, 200); };
  EXPECT_TRUE(same(rounded_value<double>(q), naive<double>(q, side_of_value))) << told("binary64");
  EXPECT_TRUE(same(rounded_value<float>(q), naive<float>(q, side_of_value))) << told("binary32");
  EXPECT_TRUE(same(rounded_root<double>(q), naive<double>(q, side_of_root))) << told("root in binary64");
  EXPECT_TRUE(same(rounded_root<float>(q), naive<float>(q, side_of_root))) << told("root in binary32");
  EXPECT_TRUE(at_once(q)) << told("all at once");
}

/// A finite number x >= 0 and the one after it (2^top after the largest), by any bit pattern:
/// subnormals and the border included.
template <class Float>
std::pair<mpq_class, mpq_class> random_neighbours(std::uint64_t seed) {
  using Bits = typename Patterns<Float>::Bits;
  const Bits infinity = std::bit_cast<Bits>(std::numeric_limits<Float>::infinity());
  const Bits count = infinity;  // as many finite patterns as the pattern of infinity says
  Bits bits = static_cast<Bits>(seed % count);
  if (seed >> 60 == 0) bits = static_cast<Bits>(seed % 9);                            // near zero
  if (seed >> 60 == 1) bits = static_cast<Bits>(count - 1 - seed % 9);                // near the overflow
  if (seed >> 60 == 2) bits &= ~Bits{0} << (std::numeric_limits<Float>::digits - 3);  // near a power of two
  return {value_of(std::bit_cast<Float>(bits)), value_of(std::bit_cast<Float>(static_cast<Bits>(bits + 1)))};
}

/// x, the middle to the next number, and points a hair beside both.
std::vector<mpq_class> hard_points(const std::pair<mpq_class, mpq_class>& neighbours) {
  const mpq_class middle = (neighbours.first + neighbours.second) / 2;
  const mpq_class hair = (neighbours.second - neighbours.first) / mpq_class(mpz_class(1) << 200);
  std::vector<mpq_class> points{neighbours.first, middle, mpq_class(middle - hair), mpq_class(middle + hair),
                                mpq_class(neighbours.first + hair)};
  if (neighbours.first > hair) points.push_back(mpq_class(neighbours.first - hair));
  return points;
}

mpz_class random_integer() {
  mpz_class result = 0;
  for (auto words = random_in(1, 5); words > 0; --words)
    result = (result << 64) + mpz_class(std::to_string(random_word()));
  return mpz_class(result >> static_cast<mp_bitcnt_t>(random_in(0, 64)));
}

TEST(Rounding, NumbersTiesAndHairsOfBinary64) {
  EXPECT_TRUE(holds({.seed = 20, .runs = 2000}, [] {
    for (const mpq_class& x : hard_points(random_neighbours<double>(random_word()))) {
      RC_ASSERT(at_once(x) && at_once(square(x)));
      RC_ASSERT(same(rounded_value<double>(x), naive<double>(x, side_of_value)));
      RC_ASSERT(same(rounded_root<double>(square(x)), naive<double>(square(x), side_of_root)));
    }
  }));
}

TEST(Rounding, NumbersTiesAndHairsOfBinary32) {
  EXPECT_TRUE(holds({.seed = 20, .runs = 2000}, [] {
    for (const mpq_class& x : hard_points(random_neighbours<float>(random_word()))) {
      RC_ASSERT(at_once(x) && at_once(square(x)));
      RC_ASSERT(same(rounded_value<float>(x), naive<float>(x, side_of_value)));
      RC_ASSERT(same(rounded_root<float>(square(x)), naive<float>(square(x), side_of_root)));
    }
  }));
}

TEST(Rounding, RandomRationals) {
  EXPECT_TRUE(holds({.seed = 20, .runs = 2000}, [] {
    const mpq_class q = ratio(random_integer(), mpz_class(random_integer() + 1)) * two_to(random_in(-2300, 2300));
    expect_as_naive(q);
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

// The three results stated directly: rd <= root <= ru by squares, they are neighbours or equal, and
// rn is the nearer one.
TEST(Rounding, TheRootLiesBetweenNeighboursBySquaring) {
  EXPECT_TRUE(holds({.seed = 20, .runs = 2000}, [] {
    const mpq_class q = ratio(random_integer(), mpz_class(random_integer() + 1));
    const auto [rd, ru, rn] = rounded_root<double>(q);
    const mpq_class low = exact_value(rd), high = exact_value(ru), middle = (low + high) / 2;
    RC_ASSERT(square(low) <= q && q <= square(high));
    RC_ASSERT((rd == ru ? square(low) == q : ru == std::nextafter(rd, HUGE_VAL)));
    const int half = cmp(square(middle), q);
    RC_ASSERT(half == 0 || rn == (half > 0 ? rd : ru));
    RC_ASSERT(half != 0 || (std::bit_cast<std::uint64_t>(rn) & 1) == 0);
  }));
}

TEST(Rounding, TheRootOfANearTieIsDecidedHoweverNear) {
  const mpq_class middle = 1 + two_to(-53);  // between 1 and its successor
  const double next = std::nextafter(1.0, 2.0);
  for (const long bits : {60L, 500L, 5000L, 100000L}) {
    EXPECT_EQ(root_binary64(mpq_class(square(middle) - two_to(-bits - 110)), Rounding::rn), 1.0) << bits;
    EXPECT_EQ(root_binary64(mpq_class(square(middle) + two_to(-bits - 110)), Rounding::rn), next) << bits;
  }
  EXPECT_EQ(root_binary64(square(middle), Rounding::rn), 1.0);
  EXPECT_EQ(root_binary64(square(mpq_class(middle + two_to(-52))), Rounding::rn), std::nextafter(next, 2.0));
}

// Long numbers go another way than short ones. One value has both forms, as lowest terms are not
// needed.
TEST(Rounding, ShortAndLongFormsOfAValueAgree) {
  const mpz_class large = (mpz_class(1) << 2000) + 1;
  EXPECT_TRUE(holds({.seed = 21, .runs = 2000}, [&large] {
    mpq_class q = ratio(random_integer(), mpz_class(random_integer() + 1)) * two_to(random_in(-900, 900));
    if (random_in(0, 3) == 0) q = square(mpq_class(q.get_num()));
    const mpq_class same(q.get_num() * large, q.get_den() * large);
    const Roundings short_form = roundings(q), long_form = roundings(same), root = roundings_of_root(q),
                    long_root = roundings_of_root(same);
    RC_ASSERT(short_form.binary64 == long_form.binary64 && short_form.binary32 == long_form.binary32);
    RC_ASSERT(root.binary64 == long_root.binary64 && root.binary32 == long_root.binary32);
  }));
}

TEST(Rounding, PerfectSquares) {
  for (long n = 0; n < 3000; ++n) {
    const mpq_class root = ratio(n, 1024);
    for (const Rounding mode : {Rounding::rn, Rounding::rd, Rounding::ru}) {
      ASSERT_EQ(root_binary64(square(root), mode), static_cast<double>(n) / 1024);
      ASSERT_EQ(root_binary32(square(root), mode), static_cast<float>(n) / 1024);
    }
  }
}

TEST(Rounding, OverflowBorder) {
  constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const mpq_class border = two_to(1024) - two_to(970);  // the largest number plus half an ulp
  const mpq_class hair = two_to(-3000);
  for (const mpq_class& x :
       {border, mpq_class(border - hair), mpq_class(border + hair), two_to(1024), mpq_class(two_to(1024) - hair),
        exact_value(largest), mpq_class(exact_value(largest) + hair)}) {
    EXPECT_EQ(round_binary64(x, Rounding::rd), largest);
    EXPECT_EQ(round_binary64(x, Rounding::ru), x == exact_value(largest) ? largest : infinity);
    EXPECT_EQ(round_binary64(x, Rounding::rn), x < border ? largest : infinity);
    EXPECT_EQ(root_binary64(square(x), Rounding::rd), largest);
    EXPECT_EQ(root_binary64(square(x), Rounding::ru), x == exact_value(largest) ? largest : infinity);
    EXPECT_EQ(root_binary64(square(x), Rounding::rn), x < border ? largest : infinity);
  }
  constexpr float largest32 = std::numeric_limits<float>::max(), infinity32 = std::numeric_limits<float>::infinity();
  const mpq_class border32 = two_to(128) - two_to(103);
  EXPECT_EQ(round_binary32(mpq_class(border32 - hair), Rounding::rn), largest32);
  EXPECT_EQ(round_binary32(border32, Rounding::rn), infinity32);
  EXPECT_EQ(root_binary32(square(mpq_class(border32 - hair)), Rounding::rn), largest32);
  EXPECT_EQ(root_binary32(square(border32), Rounding::rn), infinity32);
  EXPECT_EQ(round_binary32(border32, Rounding::rd), largest32);
}

TEST(Rounding, UnderflowBorder) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const mpq_class half = two_to(-1075), hair = two_to(-5000);
  for (const mpq_class& x : {half, mpq_class(half - hair), mpq_class(half + hair), hair}) {
    EXPECT_EQ(round_binary64(x, Rounding::rd), 0.0);
    EXPECT_EQ(round_binary64(x, Rounding::ru), least);
    EXPECT_EQ(round_binary64(x, Rounding::rn), x > half ? least : 0.0);
    EXPECT_EQ(root_binary64(square(x), Rounding::rd), 0.0);
    EXPECT_EQ(root_binary64(square(x), Rounding::ru), least);
    EXPECT_EQ(root_binary64(square(x), Rounding::rn), x > half ? least : 0.0);
  }
  EXPECT_EQ(round_binary32(two_to(-150), Rounding::rn), 0.0f);
  EXPECT_EQ(round_binary32(mpq_class(two_to(-150) + hair), Rounding::rn), std::numeric_limits<float>::denorm_min());
}

TEST(Rounding, FarBeyondBothEnds) {
  const mpq_class huge = *parse_number("1e100000", Decimals::exact).value, tiny = 1 / huge;
  EXPECT_EQ(root_binary64(square(huge), Rounding::rd), std::numeric_limits<double>::max());
  EXPECT_EQ(root_binary64(square(huge), Rounding::rn), HUGE_VAL);
  EXPECT_EQ(root_binary64(square(tiny), Rounding::rn), 0.0);
  EXPECT_EQ(root_binary64(square(tiny), Rounding::ru), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(root_binary32(square(tiny), Rounding::ru), std::numeric_limits<float>::denorm_min());
}

TEST(Rounding, NegativeValuesMirrorAndNegativeSquaresThrow) {
  EXPECT_TRUE(holds({.seed = 20, .runs = 2000}, [] {
    const mpq_class q = ratio(random_integer(), mpz_class(random_integer() + 1)) * two_to(random_in(-1200, 1100));
    const mpq_class minus = -q;
    RC_ASSERT(round_binary64(minus, Rounding::rn) == -round_binary64(q, Rounding::rn));
    RC_ASSERT(round_binary64(minus, Rounding::rd) == -round_binary64(q, Rounding::ru));
    RC_ASSERT(round_binary64(minus, Rounding::ru) == -round_binary64(q, Rounding::rd));
    RC_ASSERT(round_binary32(minus, Rounding::rd) == -round_binary32(q, Rounding::ru));
  }));
  EXPECT_TRUE(std::signbit(round_binary64(mpq_class(-two_to(-2000)), Rounding::rn)));
  EXPECT_FALSE(std::signbit(round_binary64(mpq_class(0), Rounding::rd)));
  EXPECT_THROW(root_binary64(mpq_class(-1), Rounding::rn), std::domain_error);
  EXPECT_THROW(root_binary32(mpq_class(-1), Rounding::rn), std::domain_error);
}

// A filter may leave the processor in any rounding mode; fractions need not be in lowest terms.
TEST(Rounding, TheEnvironmentHasNoSay) {
  const mpq_class third = ratio(1, 3), loose(mpz_class(12), mpz_class(36));
  const Neighbours<double> expected = rounded_root<double>(third);
  const Neighbours<double> subnormal = rounded_value<double>(third * two_to(-1070));
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Neighbours<double> found = rounded_root<double>(third), of_loose = rounded_root<double>(loose);
    const Neighbours<double> small = rounded_value<double>(third * two_to(-1070));
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(same(found, expected) && same(of_loose, expected) && same(small, subnormal)) << mode;
  }
}

TEST(HexText, AsPercentAPrintsIt) {
  EXPECT_EQ(hex_text(0.1), "0x1.999999999999ap-4");
  EXPECT_EQ(hex_text(0.0), "0x0p+0");
  EXPECT_EQ(hex_text(-0.0), "-0x0p+0");
  EXPECT_EQ(hex_text(HUGE_VAL), "inf");
  EXPECT_EQ(hex_text(-HUGE_VAL), "-inf");
  EXPECT_EQ(hex_text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(hex_text(std::numeric_limits<double>::denorm_min()), "0x0.0000000000001p-1022");
  EXPECT_EQ(hex_text(std::numeric_limits<float>::denorm_min()), "0x1p-149");
  EXPECT_EQ(hex_text(0.1f), "0x1.99999ap-4");
  EXPECT_TRUE(holds({.seed = 20, .runs = 2000}, [] {
    const std::uint64_t word = random_word();
    for (const std::uint64_t bits : {word, word >> 1, word >> 12, word & ~std::uint64_t{0} << 40}) {
      const double x = std::bit_cast<double>(bits);
      if (std::isnan(x)) continue;
      char expected[64];
      std::snprintf(expected, sizeof expected, "%a", x);
      RC_ASSERT(hex_text(x) == expected);
    }
  }));
}

mpq_class value(const Dyadic& d) {
  mpq_class q(d.mantissa);
  if (d.exponent >= 0) mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(d.exponent));
  else mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-d.exponent));
  return q;
}

TEST(Dyadic, IsTheExactValueOfEveryDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(i % 5 == 0 ? random() & 0x800fffffffffffffU : random());
    if (!std::isfinite(x)) continue;
    const Dyadic d = dyadic(x);
    ASSERT_EQ(value(d), exact_value(x)) << x;
    ASSERT_TRUE(d.mantissa % 2 != 0 || x == 0) << x;
  }
  for (const double x : {0.0, -0.0}) EXPECT_TRUE(dyadic(x).mantissa == 0 && dyadic(x).exponent == 0);
  EXPECT_THROW(dyadic(std::nan("")), std::invalid_argument);
  EXPECT_THROW(dyadic(-std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(ShortRational, HasOddPartsOfAtMost63Bits) {
  const mpz_class most = (mpz_class(1) << 63) - 1, far = mpz_class(1) << 200;
  for (const mpq_class& q :
       {mpq_class(0), mpq_class(12), mpq_class(-7, 8), mpq_class(most), mpq_class(-most, 2), mpq_class(far),
        mpq_class(most * far), mpq_class(-5, 3 * far), mpq_class(1, 3), mpq_class(-5, 12), mpq_class(far * 3, most),
        mpq_class(most - 2, most * far), mpq_class(mpz_class(1) << 63), mpq_class(mpz_class(most << 1), 5)}) {
    const auto r = short_rational(q);
    ASSERT_TRUE(r) << q;
    EXPECT_EQ(value(*r) / mpq_class(mpz_class(r->divisor)), q);
    EXPECT_TRUE(r->mantissa % 2 != 0 || q == 0);
    EXPECT_EQ(r->divisor % 2, 1U);
  }
  for (const mpz_class& odd : {mpz_class(most + 2), mpz_class(far + 1), mpz_class((far << 1) + (far >> 1) + 1)}) {
    for (const mpz_class& even : {odd, mpz_class(odd << 1), mpz_class(odd * far)}) {
      EXPECT_FALSE(short_rational(mpq_class(even))) << even;
      EXPECT_FALSE(short_rational(mpq_class(-1, even))) << even;
    }
  }
  EXPECT_FALSE(short_rational(mpq_class(2, 4))) << "not in lowest terms";
  EXPECT_FALSE(short_rational(mpq_class(0, 3)));
  EXPECT_FALSE(short_rational(mpq_class(1, -4)));
  EXPECT_FALSE(short_rational(mpq_class(1, 0)));
}

/// Against every number by itself, and GMP's least common multiple.
TEST(Divisors, TellOfAllNumbersAtOnce) {
  std::mt19937_64 random(4);
  std::size_t lowest = 0, broken = 0, common = 0, long_ones = 0;
  for (int i = 0; i < 4000; ++i) {
    Divisors divisors;
    bool all = true;
    mpz_class multiple = 1;
    const std::uint64_t most = std::uint64_t{1} << (2 + random() % 40);
    const std::array<std::uint64_t, 2> few{random() % most | 1, random() % most | 1};
    for (int k = 0; k < 6; ++k) {
      const std::uint64_t divisor = few[random() % 2];
      const auto numerator = static_cast<std::int64_t>(random() >> (1 + random() % 62) | 1);
      if (divisor == 1) continue;
      ASSERT_TRUE(divisors.add({{random() % 2 == 0 ? numerator : -numerator, 3}, divisor}));
      all = all && gcd(mpz_class(numerator), mpz_class(divisor)) == 1;
      multiple = lcm(multiple, mpz_class(divisor));
    }
    ASSERT_EQ(divisors.in_lowest_terms(), all);
    if (all) EXPECT_NO_THROW(divisors.require_lowest_terms());
    else EXPECT_THROW(divisors.require_lowest_terms(), std::invalid_argument);
    ++(all ? lowest : broken);
    const std::optional<std::uint64_t> found = divisors.common(62);
    ASSERT_EQ(found.has_value(), mpz_sizeinbase(multiple.get_mpz_t(), 2) <= 62);
    ASSERT_TRUE(!found || mpz_class(*found) == multiple);
    ++(found ? common : long_ones);
  }
  for (const std::size_t n : {lowest, broken, common, long_ones}) EXPECT_GT(n, 300U);
  Divisors many;
  for (std::uint64_t d = 3; d < 131; d += 2) ASSERT_TRUE(many.add({{1, 0}, d})) << d;
  EXPECT_FALSE(many.add({{1, 0}, 131}));
  EXPECT_TRUE(many.add({{2, 0}, 3})) << "one that is known";
}

TEST(Dyadic, InBinary64AreItsNumbersAlone) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<double>(i % 5 == 0 ? random() & 0x800fffffffffffffU : random());
    if (!std::isfinite(x)) continue;
    const mpq_class exact = exact_value(x), third = exact / 3;
    ASSERT_EQ(in_binary64(exact), std::optional(x + 0.0)) << x;
    const bool is_number = exact_value(round_binary64(third)) == third;
    ASSERT_EQ(in_binary64(third).has_value(), is_number) << x;
  }
  const mpq_class top = value({1, 1024}), least = value({1, -1074});
  for (const mpq_class& q :
       {top, mpq_class(-top), mpq_class(least / 2), mpq_class(3 * least / 2), value({(1L << 53) + 1, 0}),
        value({(1L << 53) + 1, 900}), mpq_class(1, 3), mpq_class(1, -4), mpq_class(1, 0)})
    EXPECT_FALSE(in_binary64(q)) << q;
  EXPECT_EQ(in_binary64(mpq_class(top - value({1, 971}))), std::numeric_limits<double>::max());
  EXPECT_EQ(in_binary64(least), 0x1p-1074);
}

TEST(Dyadic, EachOfThreeIsRoundedToBinary32) {
  for (const double x : {0.1, -0.7, 1e-42, 1e300}) {
    std::array<double, 3> p{x, 2 * x, 3 * x};
    for (double& c : p) c = nearest_binary32(c);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const mpq_class exact = exact_value(static_cast<double>(i + 1) * x);
      EXPECT_EQ(p[i], static_cast<double>(round_binary32(exact))) << x;
    }
  }
}

}  // namespace
}  // namespace fathom::kernels
