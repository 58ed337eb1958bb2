// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and roundings of sums of roots, against floating-point numbers of so many bits that no case here is in doubt.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "verify/families/random.hpp"

namespace fathom::kernels {
namespace {

constexpr mp_bitcnt_t bits = 8192;

mpf_class slow(const mpq_class& x) {
  mpf_class numerator(x.get_num(), bits), denominator(x.get_den(), bits);
  return mpf_class(numerator / denominator, bits);
}

mpf_class slow_root(const mpq_class& x) {
  const mpf_class root(sqrt(slow(abs(x))), bits);
  return sgn(x) < 0 ? mpf_class(-root, bits) : root;
}

/// Nothing here is that small but 0.
int slow_sign(const mpf_class& x) {
  mpf_class hair(1, bits);
  mpf_div_2exp(hair.get_mpf_t(), hair.get_mpf_t(), bits / 2);
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
      const int expected = slow_sign(mpf_class(slow(q) + slow_root(x), bits));
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
        const int expected = slow_sign(mpf_class(slow(q) + slow_root(x) + slow_root(y), bits));
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
      const mpf_class left(slow(p) + slow_root(q), bits), right(slow(r) + slow_root(s), bits);
      const int with_rational = slow_sign(mpf_class(left - slow(r), bits)), with_surd = slow_sign(mpf_class(left - right, bits));
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
    const mpq_class s = families::ratio(random.between(1, 1000000), random.between(1, 1000)) + families::times_power_of_two(1, -i);
    // A rational that agrees with the root to i bits: cancellation.
    mpq_class near(slow_root(s));
    near = families::times_power_of_two(mpq_class(mpz_class(families::times_power_of_two(near, i))), -i);
    expect_rounded({near, -s}, mpf_class(slow(near) - slow_root(s), bits));
    expect_rounded({near, s}, mpf_class(slow(near) + slow_root(s), bits));
    expect_rounded({-near, -s}, mpf_class(-slow(near) - slow_root(s), bits));
    // From the subnormal numbers of binary32 to those of binary64, and beyond.
    const mpq_class tiny = families::times_power_of_two(near, -100 - 3 * i), square = families::times_power_of_two(s, -200 - 6 * i);
    expect_rounded({tiny, -square}, mpf_class(slow(tiny) - slow_root(square), bits));
    expect_rounded({tiny, square}, mpf_class(slow(tiny) + slow_root(square), bits));
    // And to infinity.
    const mpq_class huge = families::times_power_of_two(near, 3 * i), large = families::times_power_of_two(s, 6 * i);
    expect_rounded({huge, large}, mpf_class(slow(huge) + slow_root(large), bits));
    expect_nearest(nearest_root_binary64({near + 1, s}), mpf_class(sqrt(mpf_class(slow(near + 1) + slow_root(s), bits)), bits));
    if (near * near > s)
      expect_nearest(nearest_root_binary64({near, -s}), mpf_class(sqrt(mpf_class(slow(near) - slow_root(s), bits)), bits));
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
  const Enclosure e = enclose(value, digits);
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
  EXPECT_THROW(enclose({1, 2}, 0), std::invalid_argument);
  EXPECT_THROW(enclose({1, 2}, most_root_digits + 1), std::invalid_argument);
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
    const mpq_class s = families::ratio(random.between(1, 1000000), random.between(1, 1000)) + families::times_power_of_two(1, -i);
    mpq_class near(slow_root(s));
    near = families::times_power_of_two(mpq_class(mpz_class(families::times_power_of_two(near, i))), -i);
    for (const Surd& surd : {Surd{near, -s}, Surd{near, s}, Surd{-near, s}, Surd{-near, -s}, Surd{near - i, s}}) {
      const mpf_class value(slow(surd.rational) + slow_root(surd.root), bits);
      if (slow_sign(value) == 0) continue;
      const unsigned long digits = 1 + static_cast<unsigned long>(i) % 40;
      const auto [low, high] = around(value);
      const mpq_class expected = cut(low, digits);
      if (expected != cut(high, digits)) continue;  // a rational value that is a decimal itself: they are in print above
      const Enclosure found = enclose(surd, digits);
      EXPECT_EQ(abs(read(sgn(value) > 0 ? found.low : found.high)), expected) << surd.rational << " " << surd.root;
      EXPECT_LE(compare(surd, read(found.high)), 0);
      EXPECT_GE(compare(surd, read(found.low)), 0);
    }
  }
}

TEST(EncloseSurd, ToAHundredThousandDigits) {
  const Enclosure found = enclose({1, 2}, 100000), root = enclose_root(2, 100000);
  EXPECT_EQ(found.low.substr(1), root.low.substr(1));
  EXPECT_EQ(found.high.substr(1), root.high.substr(1));
}

}  // namespace
}  // namespace fathom::kernels
