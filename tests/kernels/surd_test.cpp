// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and roundings of sums of roots, against floating-point numbers of so many bits that no case here is in doubt.
#include "kernels/number/surd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "fathom/numbers.hpp"
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

/// A rational below the value, and nearer to it than 2^-3000 of its size.
mpq_class just_below(const mpf_class& x) {
  mpq_class q(x);
  const mpq_class hair = families::times_power_of_two(abs(q), -3000);
  return q - hair;
}

void expect_nearest(double rounded, const mpf_class& value) {
  EXPECT_EQ(rounded, round_binary64(just_below(value), Rounding::rn));
  EXPECT_EQ(rounded, round_binary64(mpq_class(2 * mpq_class(value) - just_below(value)), Rounding::rn));
}

TEST(Surd, RoundsIrrationalNumbers) {
  families::Random random(5);
  for (int i = 0; i < 400; ++i) {
    const mpq_class s = families::ratio(random.between(1, 1000000), random.between(1, 1000)) + families::times_power_of_two(1, -i);
    // A rational that agrees with the root to i bits: cancellation.
    mpq_class near(slow_root(s));
    near = families::times_power_of_two(mpq_class(mpz_class(families::times_power_of_two(near, i))), -i);
    expect_nearest(nearest_binary64({near, -s}), mpf_class(slow(near) - slow_root(s), bits));
    expect_nearest(nearest_binary64({near, s}), mpf_class(slow(near) + slow_root(s), bits));
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
}

}  // namespace
}  // namespace fathom::kernels
