// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

mpq_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? mpq_class(mpz_class(1), power) : mpq_class(power);
}

/// The greatest power of ten that is not above x > 0.
long exponent_of(const mpq_class& x) {
  const auto digits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 10)); };
  long result = digits(x.get_num()) - digits(x.get_den()) + 1;  // or up to 3 less
  while (power_of_ten(result) > x) --result;
  return result;
}

std::string text_of(unsigned long digit, long exponent) {
  if (exponent > 4 || exponent < -4) return fmt::format("{}e{}", digit, exponent);
  if (exponent >= 0) return fmt::format("{}{}", digit, std::string(static_cast<std::size_t>(exponent), '0'));
  return fmt::format("0.{}{}", std::string(static_cast<std::size_t>(-exponent - 1), '0'), digit);
}

}  // namespace

RoundLength round_length(const mpq_class& most) {
  const long exponent = exponent_of(most);
  const mpq_class power = power_of_ten(exponent);
  unsigned long digit = 1;
  for (const unsigned long greater : {2UL, 5UL})
    if (greater * power <= most) digit = greater;
  return {mpq_class(digit * power), text_of(digit, exponent)};
}

}  // namespace fathom::picture
