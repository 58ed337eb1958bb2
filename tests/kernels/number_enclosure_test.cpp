// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures of roots against a twin in integers: the whole part of 10^s sqrt(q), cut to N digits.
#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "fathom/numbers.hpp"

namespace fathom::kernels {
namespace {

// Deterministic, and many cases; the environment may ask for others.
[[maybe_unused]] const int configured = setenv("RC_PARAMS", "seed=22 max_success=4000", 0);

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

mpq_class square(const mpq_class& x) { return mpq_class(x * x); }

mpz_class floor_of(const mpq_class& x) { return mpz_class(x.get_num() / x.get_den()); }  // for x >= 0

struct Values {
  mpq_class low, high;
  friend bool operator==(const Values&, const Values&) = default;
};

Values values(const Enclosure& enclosure) { return {read(enclosure.low), read(enclosure.high)}; }

/// Twin, for q > 0: the power 10^s with 10^(N-1) <= 10^s sqrt(q) < 10^N by trial, then one integer root.
Values naive(const mpq_class& q, long digits) {
  long scale = 0;
  while (square(power_of_ten(scale)) * q >= square(power_of_ten(digits))) --scale;
  while (square(power_of_ten(scale)) * q < square(power_of_ten(digits - 1))) ++scale;
  const mpz_class below = sqrt(floor_of(mpq_class(square(power_of_ten(scale)) * q)));
  const mpq_class low = below * power_of_ten(-scale);
  return {low, square(low) == q ? low : mpq_class((below + 1) * power_of_ten(-scale))};
}

void expect_as_naive(const mpq_class& q, long digits) {
  EXPECT_EQ(values(enclose_root(q, static_cast<std::size_t>(digits))), naive(q, digits)) << exact_text(q) << " to " << digits;
}

// At full size from the first case on: RapidCheck would begin with small numbers.
std::uint64_t random_word() { return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()); }

/// From first to last - 1.
int random_in(int first, int last) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, last)); }

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
  EXPECT_TRUE(rc::check([] {
    mpq_class q(mpz_class(std::to_string(random_word())) + 1, mpz_class(std::to_string(random_word())) + 1);
    q.canonicalize();
    q *= power_of_ten(random_in(-40, 41));
    expect_as_naive(q, random_in(1, 60));
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

// Roots that are decimals, and squares off by far less than any working precision, at every digit count around the decimal's own.
TEST(EncloseRoot, DecimalsAndHairsBesideThem) {
  EXPECT_TRUE(rc::check([] {
    const mpz_class digits = mpz_class(std::to_string(random_word() >> random_in(0, 64))) + 1;
    const mpq_class root = digits * power_of_ten(random_in(-30, 31));
    const mpq_class hair = square(root) * power_of_ten(-500);
    const long count = static_cast<long>(digits.get_str().size()) + random_in(-2, 3);
    for (const mpq_class& q : {square(root), mpq_class(square(root) - hair), mpq_class(square(root) + hair)}) {
      expect_as_naive(q, std::max(count, 1L));
    }
    RC_ASSERT(!testing::Test::HasFailure());
  }));
}

TEST(EncloseRoot, HairsBesidePowersOfTen) {
  for (const long exponent : {-20L, -1L, 0L, 1L, 20L}) {
    for (const long digits : {1L, 2L, 19L, 60L}) {
      for (const int sign : {-1, 0, 1}) expect_as_naive(mpq_class(power_of_ten(2 * exponent) * (1 + sign * power_of_ten(-3000))), digits);
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
  EXPECT_TRUE(power_of_ten(static_cast<long>(digits) - 1) <= units && units < power_of_ten(static_cast<long>(digits))) << digits;
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

}  // namespace
}  // namespace fathom::kernels
