// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal digits of integers are those of GMP.
#include <gtest/gtest.h>

#include <string>

#include "fathom/numbers.hpp"
#include "kernels/number/text.hpp"

namespace fathom::kernels {
namespace {

void expect_same(const mpz_class& n) {
  for (const mpz_class& signed_one : {n, mpz_class(-n)}) {
    std::string text = "n = ";
    append_digits(signed_one.get_mpz_t(), text);
    ASSERT_EQ(text, "n = " + signed_one.get_str());
    ASSERT_LE(text.size() - 4, most_digits(signed_one.get_mpz_t()));
  }
}

// Whole chunks of zeros and of nines, through the number of words that go to GMP.
TEST(Decimal, PowersOfTenAreThoseOfGmp) {
  mpz_class power = 1;
  for (int digits = 0; digits < 600; ++digits, power *= 10)
    for (const int off : {-1, 0, 1}) expect_same(power + off);
}

// Beyond the powers of 2 that are kept, too.
TEST(Decimal, WordsTimesPowersOfTwoAreThoseOfGmp) {
  for (unsigned long shift = 0; shift < 1700; ++shift) {
    const mpz_class power = mpz_class(1) << shift;
    for (const int off : {-1, 0, 1}) expect_same(power + off);
    for (const unsigned long n : {3UL, 10UL, 0x1fffffffffffffUL, 0x8000000000000001UL, ~0UL}) expect_same(power * n);
  }
}

TEST(Decimal, CoordinatesInBinary64AreThoseOfGmp) {
  for (long exponent = 0; exponent <= 1074; ++exponent) {
    for (const std::int64_t mantissa : {1L, -1L, (1L << 53) - 1, -(1L << 53) + 1}) {
      const Dyadic n{mantissa, exponent};
      std::string text(most_digits(n), ' ');
      text.resize(static_cast<std::size_t>(put_digits(text.data(), n) - text.data()));
      ASSERT_EQ(text, mpz_class(mpz_class(mantissa) << static_cast<unsigned long>(exponent)).get_str());
    }
  }
}

TEST(Decimal, RandomOnesAreThoseOfGmp) {
  gmp_randclass random(gmp_randinit_mt);
  for (unsigned bits = 1; bits < 2000; ++bits) {
    const mpz_class n = random.get_z_bits(bits), d = random.get_z_bits(bits % 300) + 1;
    expect_same(n);
    mpq_class q(n, d);
    q.canonicalize();
    ASSERT_EQ(exact_text(q), q.get_str());
    ASSERT_EQ(exact_text(mpq_class(-q)), mpq_class(-q).get_str());
  }
}

}  // namespace
}  // namespace fathom::kernels
