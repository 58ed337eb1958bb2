// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and roundings of sums of roots, against floating-point numbers of so many bits that no case
// here is in doubt.

#include "kernels/number/irrational.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "tests/support/full_size.hpp"
#include "tests/support/property.hpp"
#include "verify/families/random.hpp"

namespace fathom::kernels {
namespace {

using testing::random_in;
using testing::random_word;
using testing::square;

constexpr mp_bitcnt_t slow_bits = 8192;

mpf_class slow(const mpq_class& x) {
  mpf_class numerator(x.get_num(), slow_bits), denominator(x.get_den(), slow_bits);
  return mpf_class(numerator / denominator, slow_bits);
}

mpf_class slow_root(const mpq_class& x) {
  const mpf_class root(sqrt(slow(abs(x))), slow_bits);
  return sgn(x) < 0 ? mpf_class(-root, slow_bits) : root;
}

/// Nothing here is that small but 0.
int slow_sign(const mpf_class& x) {
  mpf_class hair(1, slow_bits);
  mpf_div_2exp(hair.get_mpf_t(), hair.get_mpf_t(), slow_bits / 2);
  return abs(x) < hair ? 0 : sgn(x);
}

/// Small numbers, squares and their neighbours: so that sums often vanish, or nearly.
std::vector<mpq_class> numbers() {
  const mpq_class hair = families::times_power_of_two(1, -300);
  std::vector<mpq_class> result{0, hair};
  for (const long p : {1, 2, 3, 4, 8, 9, 18, 25, 32, 50}) {
    for (const mpq_class& x : {mpq_class(p), families::ratio(p, 9), mpq_class(p + hair)}) result.push_back(x);
  }
  for (std::size_t i = result.size(); i-- > 1;) result.push_back(-result[i]);
  return result;
}

TEST(Surd, SignsOfOneRoot) {
  int zeros = 0;
  for (const mpq_class& q : numbers()) {
    for (const mpq_class& x : numbers()) {
      const int expected = slow_sign(mpf_class(slow(q) + slow_root(x), slow_bits));
      EXPECT_EQ(sign({q, x}), expected) << q << " " << x;
      zeros += expected == 0;
    }
  }
  EXPECT_GT(zeros, 10);
}

TEST(Surd, SignsOfTwoRoots) {
  int zeros = 0;
  const std::vector<mpq_class> all = numbers();
  for (const mpq_class& q : all) {
    for (const mpq_class& x : all) {
      for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / 17) {
        const mpq_class& y = all[(k + x.get_num().get_ui()) % all.size()];
        const int expected = slow_sign(mpf_class(slow(q) + slow_root(x) + slow_root(y), slow_bits));
        EXPECT_EQ(sign_of_sum(q, x, y), expected) << q << " " << x << " " << y;
        zeros += expected == 0;
      }
    }
  }
  EXPECT_EQ(sign_of_sum(-3, 2, mpq_class(3 - 2)), -1);
  EXPECT_EQ(sign_of_sum(0, 2, -2), 0);
  EXPECT_EQ(sign_of_sum(-5, 4, 9), 0);
  EXPECT_GT(zeros, 50);
}

TEST(Surd, ComparesWithRationalsAndWithEachOther) {
  const std::vector<mpq_class> all = numbers();
  std::size_t k = 0, equal = 0;
  for (const mpq_class& p : all) {
    for (const mpq_class& q : all) {
      const mpq_class &r = all[++k * 7 % all.size()], &s = all[k * 11 % all.size()];
      const mpf_class left(slow(p) + slow_root(q), slow_bits), right(slow(r) + slow_root(s), slow_bits);
      const int with_rational = slow_sign(mpf_class(left - slow(r), slow_bits)),
                with_surd = slow_sign(mpf_class(left - right, slow_bits));
      EXPECT_EQ(compare(Surd{p, q}, r), with_rational) << p << " " << q << " " << r;
      EXPECT_EQ(compare(Surd{p, q}, Surd{r, s}), with_surd) << p << " " << q << " " << r << " " << s;
      equal += with_surd == 0 || with_rational == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(equal, 10U);
  EXPECT_EQ(compare(Surd{3, 0}, Surd{1, 4}), 0) << "one number, two forms";
  EXPECT_EQ(compare(Surd{0, 8}, Surd{0, 2}), 1);
}

/// Rationals around the value, nearer to it than 2^-3000 of its size.
struct Around {
  mpq_class low, high;
};

Around around(const mpf_class& x) {
  const mpq_class q(x), hair = families::times_power_of_two(abs(q), -3000);
  return {q - hair, q + hair};
}

void expect_nearest(double rounded, const mpf_class& value) {
  EXPECT_EQ(rounded, round_binary64(around(value).low, Rounding::rn));
  EXPECT_EQ(rounded, round_binary64(around(value).high, Rounding::rn));
}

/// In each mode of the function, whatever mode the processor is in.
void expect_rounded(const Surd& surd, const mpf_class& value) {
  const auto [low, high] = around(value);
  for (const Rounding mode : {Rounding::rn, Rounding::rd, Rounding::ru}) {
    const double wide = round_binary64(low, mode);
    const float narrow = round_binary32(low, mode);
    ASSERT_EQ(wide, round_binary64(high, mode)) << "the test needs more bits";
    ASSERT_EQ(narrow, round_binary32(high, mode)) << "the test needs more bits";
    for (const int processor : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
      std::fesetround(processor);
      const double found = round_binary64(surd, mode);
      const float found_narrow = round_binary32(surd, mode);
      std::fesetround(FE_TONEAREST);
      EXPECT_EQ(found, wide) << surd.rational << " " << surd.root;
      EXPECT_EQ(std::signbit(found), std::signbit(wide)) << surd.rational << " " << surd.root;
      EXPECT_EQ(found_narrow, narrow) << surd.rational << " " << surd.root;
      EXPECT_EQ(std::signbit(found_narrow), std::signbit(narrow)) << surd.rational << " " << surd.root;
    }
  }
}

TEST(Surd, RoundsIrrationalNumbers) {
  families::Random random(5);
  for (int i = 0; i < 400; ++i) {
    const mpq_class s =
        families::ratio(random.between(1, 1000000), random.between(1, 1000)) + families::times_power_of_two(1, -i);
    // A rational that agrees with the root to i bits: cancellation.
    mpq_class near(slow_root(s));
    near = families::times_power_of_two(mpq_class(mpz_class(families::times_power_of_two(near, i))), -i);
    expect_rounded({near, -s}, mpf_class(slow(near) - slow_root(s), slow_bits));
    expect_rounded({near, s}, mpf_class(slow(near) + slow_root(s), slow_bits));
    expect_rounded({-near, -s}, mpf_class(-slow(near) - slow_root(s), slow_bits));
    // A root alone, which goes another way.
    for (const mpq_class& root :
         {s, families::times_power_of_two(s, -200 - 6 * i), families::times_power_of_two(s, 6 * i)}) {
      expect_rounded({0, root}, slow_root(root));
      expect_rounded({0, -root}, mpf_class(-slow_root(root), slow_bits));
    }
    // From the subnormal numbers of binary32 to those of binary64, and beyond.
    const mpq_class tiny = families::times_power_of_two(near, -100 - 3 * i),
                    square = families::times_power_of_two(s, -200 - 6 * i);
    expect_rounded({tiny, -square}, mpf_class(slow(tiny) - slow_root(square), slow_bits));
    expect_rounded({tiny, square}, mpf_class(slow(tiny) + slow_root(square), slow_bits));
    // And to infinity.
    const mpq_class huge = families::times_power_of_two(near, 3 * i), large = families::times_power_of_two(s, 6 * i);
    expect_rounded({huge, large}, mpf_class(slow(huge) + slow_root(large), slow_bits));
    expect_nearest(nearest_root_binary64({near + 1, s}),
                   mpf_class(sqrt(mpf_class(slow(near + 1) + slow_root(s), slow_bits)), slow_bits));
    if (near * near > s)
      expect_nearest(nearest_root_binary64({near, -s}),
                     mpf_class(sqrt(mpf_class(slow(near) - slow_root(s), slow_bits)), slow_bits));
  }
}

TEST(Surd, RoundsRationalNumbersOnTheBorders) {
  const mpq_class half_ulp = families::times_power_of_two(1, -53);
  EXPECT_EQ(nearest_binary64({half_ulp, 1}), 1) << "a tie goes to the even side";
  EXPECT_EQ(nearest_binary64({3 * half_ulp, 1}), 1 + 0x1p-51);
  EXPECT_EQ(nearest_binary64({mpq_class(3, 5), mpq_class(-9, 25)}), 0);
  EXPECT_FALSE(std::signbit(nearest_binary64({mpq_class(3, 5), mpq_class(-9, 25)})));
  EXPECT_EQ(round_binary64(Surd{half_ulp, 1}, Rounding::ru), 1 + 0x1p-52);
  EXPECT_EQ(round_binary64(Surd{-1, 1}, Rounding::rd), 0);
  EXPECT_EQ(round_binary32(Surd{half_ulp, 1}, Rounding::rd), 1);
  EXPECT_EQ(round_binary32(Surd{half_ulp, -1}, Rounding::ru), -1 + 0x1p-24F);
  EXPECT_EQ(nearest_root_binary64({mpq_class(9, 2), mpq_class(81, 4)}), 3);
  EXPECT_EQ(nearest_root_binary64({3, -9}), 0);
  EXPECT_THROW(nearest_root_binary64({3, -10}), std::domain_error);
}

TEST(Surd, RoundsAtTheEndsOfTheRange) {
  const mpq_class large = families::times_power_of_two(2, 4000), small = families::times_power_of_two(2, -4000);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(nearest_binary64({0, large}), infinity);
  EXPECT_EQ(nearest_binary64({0, -large}), -infinity);
  EXPECT_EQ(nearest_binary64({0, -small}), 0);
  EXPECT_FALSE(std::signbit(nearest_binary64({0, -small})));
  EXPECT_EQ(nearest_binary64({0, families::times_power_of_two(2, -2148)}), 5e-324);
  EXPECT_EQ(nearest_binary64({1, -(1 + small)}), 0);
  EXPECT_EQ(round_binary64(Surd{1, -(1 + small)}, Rounding::rd), -5e-324);
  EXPECT_TRUE(std::signbit(round_binary64(Surd{1, -(1 + small)}, Rounding::ru)));
  // The largest number and half an ulp: the border of overflow, approached from both sides.
  const mpq_class border = exact_value(std::numeric_limits<double>::max()) + families::times_power_of_two(1, 970);
  EXPECT_EQ(round_binary64(Surd{border, -small}), std::numeric_limits<double>::max());
  EXPECT_EQ(round_binary64(Surd{border, small}), infinity);
  EXPECT_EQ(round_binary64(Surd{-border, -small}, Rounding::ru), -std::numeric_limits<double>::max());
}

// ---- any number of digits ----

std::string both(const Surd& value, std::size_t digits) {
  const Enclosure e = fathom::enclose(value, digits);
  return e.low + " " + e.high;
}

TEST(EncloseSurd, InPrint) {
  EXPECT_EQ(both({1, 2}, 5), "2.4142 2.4143");
  EXPECT_EQ(both({1, -2}, 5), "-0.41422 -0.41421");
  EXPECT_EQ(both({mpq_class(3, 2), 0}, 5), "1.5 1.5");
  EXPECT_EQ(both({mpq_class(-1, 3), 0}, 3), "-0.334 -0.333");
  EXPECT_EQ(both({1, 4}, 5), "3 3");
  EXPECT_EQ(both({mpq_class(1, 3), mpq_class(-1, 9)}, 5), "0 0");
  EXPECT_EQ(both({mpq_class(1, 3), mpq_class(4, 9)}, 1), "1 1");
  EXPECT_EQ(both({-100, mpq_class(9999)}, 3), "-0.00501 -0.00500");
  EXPECT_EQ(both({7, 9}, 1), "10 10");
  EXPECT_THROW(fathom::enclose({1, 2}, 0), std::invalid_argument);
  EXPECT_THROW(fathom::enclose({1, 2}, most_root_digits + 1), std::invalid_argument);
}

/// |x| cut to N digits, by trial of powers of ten.
mpq_class cut(const mpq_class& x, unsigned long digits) {
  mpz_class bound;
  mpz_ui_pow_ui(bound.get_mpz_t(), 10, digits);
  mpq_class scale = 1, y = abs(x);
  for (; y >= bound; y /= 10) scale *= 10;
  for (; 10 * y < bound; y *= 10) scale /= 10;
  return mpz_class(y.get_num() / y.get_den()) * scale;
}

TEST(EncloseSurd, EqualsDigitsCutFromALongNumber) {
  families::Random random(6);
  const auto read = [](const std::string& text) { return *parse_number(text, Decimals::exact).value; };
  for (int i = 0; i < 300; ++i) {
    const mpq_class s =
        families::ratio(random.between(1, 1000000), random.between(1, 1000)) + families::times_power_of_two(1, -i);
    mpq_class near(slow_root(s));
    near = families::times_power_of_two(mpq_class(mpz_class(families::times_power_of_two(near, i))), -i);
    for (const Surd& surd : {Surd{near, -s}, Surd{near, s}, Surd{-near, s}, Surd{-near, -s}, Surd{near - i, s}}) {
      const mpf_class value(slow(surd.rational) + slow_root(surd.root), slow_bits);
      if (slow_sign(value) == 0) continue;
      const unsigned long digits = 1 + static_cast<unsigned long>(i) % 40;
      const auto [low, high] = around(value);
      const mpq_class expected = cut(low, digits);
      if (expected != cut(high, digits))
        continue;  // a rational value that is a decimal itself: they are in print above
      const Enclosure found = fathom::enclose(surd, digits);
      EXPECT_EQ(abs(read(sgn(value) > 0 ? found.low : found.high)), expected) << surd.rational << " " << surd.root;
      EXPECT_LE(compare(surd, read(found.high)), 0);
      EXPECT_GE(compare(surd, read(found.low)), 0);
    }
  }
}

TEST(EncloseSurd, ToAHundredThousandDigits) {
  const Enclosure found = fathom::enclose({1, 2}, 100000), root = enclose_root(2, 100000);
  EXPECT_EQ(found.low.substr(1), root.low.substr(1));
  EXPECT_EQ(found.high.substr(1), root.high.substr(1));
}

// Enclosures of roots against a twin in integers: the whole part of 10^s sqrt(q), cut to N digits.

mpq_class power_of_ten(long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? mpq_class(1, result) : mpq_class(result);
}

mpq_class read(const std::string& text) {
  const ParsedNumber parsed = parse_number(text, Decimals::exact);
  EXPECT_TRUE(parsed.value.has_value()) << parsed.error;
  return parsed.value.value_or(mpq_class(-1));
}

mpz_class floor_of(const mpq_class& x) { return mpz_class(x.get_num() / x.get_den()); }  // for x >= 0

struct Values {
  mpq_class low, high;
  friend bool operator==(const Values&, const Values&) = default;
};

Values values(const Enclosure& enclosure) { return {read(enclosure.low), read(enclosure.high)}; }

/// Twin, for q > 0: the power 10^s with 10^(N-1) <= 10^s sqrt(q) < 10^N by trial, then one integer
/// root.
Values naive(const mpq_class& q, long digits) {
  long scale = 0;
  while (square(power_of_ten(scale)) * q >= square(power_of_ten(digits))) --scale;
  while (square(power_of_ten(scale)) * q < square(power_of_ten(digits - 1))) ++scale;
  const mpz_class below = sqrt(floor_of(mpq_class(square(power_of_ten(scale)) * q)));
  const mpq_class low = below * power_of_ten(-scale);
  return {low, square(low) == q ? low : mpq_class((below + 1) * power_of_ten(-scale))};
}

void expect_as_naive(const mpq_class& q, long digits) {
  EXPECT_EQ(values(enclose_root(q, static_cast<std::size_t>(digits))), naive(q, digits))
      << exact_text(q) << " to " << digits;
}

TEST(EncloseRoot, InPrint) {
  const auto both = [](const mpq_class& q, std::size_t digits) {
    const Enclosure e = enclose_root(q, digits);
    return e.low + " " + e.high;
  };
  EXPECT_EQ(both(2, 1), "1 2");
  EXPECT_EQ(both(2, 5), "1.4142 1.4143");
  EXPECT_EQ(both(2, 30), "1.41421356237309504880168872420 1.41421356237309504880168872421");
  EXPECT_EQ(both(mpq_class(1, 100), 20), "0.1 0.1");
  EXPECT_EQ(both(mpq_class(1, 9), 4), "0.3333 0.3334");
  EXPECT_EQ(both(0, 7), "0 0");
  EXPECT_EQ(both(mpq_class(99, 1), 1), "9 10");
  EXPECT_EQ(both(mpq_class(9999, 1), 3), "99.9 100");
  EXPECT_EQ(both(100, 5), "10 10");
  EXPECT_EQ(both(12345 * 12345, 5), "12345 12345");
  EXPECT_EQ(both(12345 * 12345, 4), "12340 12350");
  EXPECT_EQ(both(mpq_class(1) / (1 << 20), 3), "0.000976 0.000977");
  EXPECT_EQ(both(power_of_ten(-13), 3), "3.16e-7 3.17e-7");
  EXPECT_EQ(both(power_of_ten(-14), 3), "1e-7 1e-7");
  EXPECT_EQ(both(power_of_ten(32), 3), "10000000000000000 10000000000000000");
  EXPECT_EQ(both(power_of_ten(34), 3), "1e17 1e17");
  EXPECT_EQ(both(2 * power_of_ten(36), 25), "1414213562373095048.801688 1414213562373095048.801689");
  EXPECT_EQ(both(power_of_ten(41), 3), "3.16e20 3.17e20");
}

TEST(EncloseRoot, AsTheNaiveTwin) {
  EXPECT_TRUE(holds({.seed = 22, .runs = 4000}, [] {
    mpq_class q(mpz_class(std::to_string(random_word())) + 1, mpz_class(std::to_string(random_word())) + 1);
    q.canonicalize();
    q *= power_of_ten(random_in(-40, 41));
    expect_as_naive(q, random_in(1, 60));
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

// Roots that are decimals, and squares off by far less than any working precision, at every digit
// count around the decimal's own.
TEST(EncloseRoot, DecimalsAndHairsBesideThem) {
  EXPECT_TRUE(holds({.seed = 22, .runs = 4000}, [] {
    const mpz_class digits = mpz_class(std::to_string(random_word() >> random_in(0, 64))) + 1;
    const mpq_class root = digits * power_of_ten(random_in(-30, 31));
    const mpq_class hair = square(root) * power_of_ten(-500);
    const long count = static_cast<long>(digits.get_str().size()) + random_in(-2, 3);
    for (const mpq_class& q : {square(root), mpq_class(square(root) - hair), mpq_class(square(root) + hair)}) {
      expect_as_naive(q, std::max(count, 1L));
    }
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TEST(EncloseRoot, HairsBesidePowersOfTen) {
  for (const long exponent : {-20L, -1L, 0L, 1L, 20L}) {
    for (const long digits : {1L, 2L, 19L, 60L}) {
      for (const int sign : {-1, 0, 1})
        expect_as_naive(mpq_class(power_of_ten(2 * exponent) * (1 + sign * power_of_ten(-3000))), digits);
    }
  }
}

/// The digits of a decimal's significand.
std::size_t significant_digits(const std::string& text) {
  std::size_t count = 0;
  for (const char c : text.substr(0, text.find('e'))) count += c >= '0' && c <= '9' && (c != '0' || count > 0) ? 1 : 0;
  return count;
}

/// The claim itself, without a twin: for irrational roots too large or too long to search for.
void expect_enclosed(const mpq_class& q, std::size_t digits) {
  const Enclosure enclosure = enclose_root(q, digits);
  const auto [low, high] = values(enclosure);
  EXPECT_TRUE(square(low) < q && q < square(high)) << digits;
  EXPECT_EQ(significant_digits(enclosure.low), digits);
  const mpq_class unit = high - low;  // of the last digit: low is a multiple of it, between 10^(N-1) and 10^N units
  const mpq_class units = low / unit;
  EXPECT_EQ(units.get_den(), 1);
  EXPECT_TRUE(power_of_ten(static_cast<long>(digits) - 1) <= units && units < power_of_ten(static_cast<long>(digits)))
      << digits;
}

TEST(EncloseRoot, ManyDigits) {
  for (const std::size_t digits : {1000u, 10000u, 100000u}) {
    expect_enclosed(2, digits);
    expect_enclosed(mpq_class(2, 3), digits);
  }
  EXPECT_EQ(enclose_root(mpq_class(1, 4), 100000), (Enclosure{"0.5", "0.5"}));
}

TEST(EncloseRoot, HugeAndTinyNumbers) {
  for (const long exponent : {-199999L, -199997L, 199999L, 200001L}) {
    for (const std::size_t digits : {1u, 17u, 50u}) expect_enclosed(power_of_ten(exponent), digits);
  }
  EXPECT_EQ(enclose_root(power_of_ten(200000), 9), (Enclosure{"1e100000", "1e100000"}));
  EXPECT_EQ(enclose_root(power_of_ten(-200000), 9), (Enclosure{"1e-100000", "1e-100000"}));
}

TEST(EncloseRoot, ANarrowedExponentRangeIsNoObstacle) {
  const mpfr_exp_t least = mpfr_get_emin(), greatest = mpfr_get_emax();
  mpfr_set_emin(-100);
  mpfr_set_emax(100);
  const Enclosure huge = enclose_root(power_of_ten(2001), 3), tiny = enclose_root(power_of_ten(-2001), 3);
  EXPECT_EQ(mpfr_get_emin(), -100);
  EXPECT_EQ(mpfr_get_emax(), 100);
  mpfr_set_emin(least);
  mpfr_set_emax(greatest);
  EXPECT_EQ(huge, (Enclosure{"3.16e1000", "3.17e1000"}));
  EXPECT_EQ(tiny, (Enclosure{"3.16e-1001", "3.17e-1001"}));
}

TEST(EncloseRoot, RefusesWhatHasNoAnswer) {
  EXPECT_THROW(enclose_root(mpq_class(-1), 5), std::domain_error);
  EXPECT_THROW(enclose_root(mpq_class(2), 0), std::invalid_argument);
  EXPECT_THROW(enclose_root(mpq_class(2), most_root_digits + 1), std::invalid_argument);
}

/// Two neighbouring sums of Taylor's series, between which the cosine or sine of x lies for 0 < x <
/// 2.
std::pair<mpq_class, mpq_class> taylor(const mpq_class& x, bool sine) {
  mpq_class term = sine ? x : mpq_class(1), sum = term, before;
  for (unsigned k = sine ? 1 : 0; k < 60; k += 2) {
    term *= -x * x / ((k + 1) * (k + 2));
    before = sum;
    sum += term;
  }
  return sum < before ? std::pair(sum, before) : std::pair(before, sum);
}

/// Half the distance of two numbers of 53 bits near `value`, or of those below it if it is a power
/// of two.
mpq_class half_ulp(const mpq_class& value) {
  mpq_class ulp(1);
  while (ulp > abs(value)) ulp /= 2;
  while (ulp * 2 <= abs(value)) ulp *= 2;
  return ulp / (mpz_class(1) << 53);
}

void expect_nearest(const mpq_class& value, const std::pair<mpq_class, mpq_class>& bounds) {
  const mpz_class odd = value.get_num() >> mpz_scan1(value.get_num_mpz_t(), 0);
  EXPECT_LE(mpz_sizeinbase(odd.get_mpz_t(), 2), 53U);
  const mpq_class slack = half_ulp(value);
  EXPECT_LE(abs(mpq_class(value - bounds.first)), slack);
  EXPECT_LE(abs(mpq_class(value - bounds.second)), slack);
}

TEST(Angle, IsCorrectlyRoundedAsTaylorSays) {
  for (int i = 1; i < 200; ++i) {
    const mpq_class x(i, 101);
    const CosineAndSine found = cosine_and_sine(x, AngleUnit::radians);
    expect_nearest(found.cosine, taylor(x, false));
    expect_nearest(found.sine, taylor(x, true));
  }
  const mpq_class tiny(1, mpz_class(1) << 2000);
  expect_nearest(cosine_and_sine(tiny, AngleUnit::radians).sine, taylor(tiny, true));
  EXPECT_EQ(cosine_and_sine(tiny, AngleUnit::radians).cosine, 1);
}

TEST(Angle, IsExactWhereItCanBe) {
  const mpq_class half(1, 2);
  const std::pair<int, std::pair<mpq_class, mpq_class>> exactly[] = {{0, {1, 0}},        {90, {0, 1}},   {180, {-1, 0}},
                                                                     {270, {0, -1}},     {-90, {0, -1}}, {360, {1, 0}},
                                                                     {36000090, {0, 1}}, {-180, {-1, 0}}};
  for (const auto& [degrees, expected] : exactly) {
    const CosineAndSine found = cosine_and_sine(degrees, AngleUnit::degrees);
    EXPECT_EQ(std::pair(found.cosine, found.sine), expected) << degrees;
  }
  EXPECT_EQ(cosine_and_sine(60, AngleUnit::degrees).cosine, half);
  EXPECT_EQ(cosine_and_sine(240, AngleUnit::degrees).cosine, -half);
  EXPECT_EQ(cosine_and_sine(150, AngleUnit::degrees).sine, half);
  EXPECT_EQ(cosine_and_sine(-30, AngleUnit::degrees).sine, -half);
  EXPECT_EQ(cosine_and_sine(0, AngleUnit::radians).cosine, 1);
  EXPECT_EQ(cosine_and_sine(0, AngleUnit::radians).sine, 0);
}

TEST(Angle, OfDegreesHasTheSymmetriesOfTheCircle) {
  for (int i = -400; i < 800; i += 7) {
    const mpq_class angle(i, 3);
    const CosineAndSine here = cosine_and_sine(angle, AngleUnit::degrees),
                        there = cosine_and_sine(90 - angle, AngleUnit::degrees),
                        back = cosine_and_sine(-angle, AngleUnit::degrees),
                        again = cosine_and_sine(angle + 720, AngleUnit::degrees);
    EXPECT_EQ(here.cosine, there.sine) << i;
    EXPECT_EQ(here.cosine, back.cosine) << i;
    EXPECT_EQ(here.sine, -back.sine) << i;
    EXPECT_EQ(here.sine, again.sine) << i;
    const mpq_class one = here.cosine * here.cosine + here.sine * here.sine;
    EXPECT_LT(abs(mpq_class(one - 1)), mpq_class(1, mpz_class(1) << 51)) << i;
  }
}

}  // namespace
}  // namespace fathom::kernels
