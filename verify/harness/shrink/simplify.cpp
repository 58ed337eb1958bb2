// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/shrink/search.hpp"

namespace fathom::harness {
namespace {

constexpr long ladder[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 44};

/// `value` / 2^bits towards 0.
mpz_class cut(const mpz_class& value, unsigned bits) {
  mpz_class result;
  mpz_tdiv_q_2exp(result.get_mpz_t(), value.get_mpz_t(), bits);
  return result;
}

}  // namespace

mpz_class nearest_integer(const mpq_class& value) {
  mpz_class result;
  const mpz_class numerator = 2 * value.get_num() + value.get_den(), denominator = 2 * value.get_den();
  mpz_fdiv_q(result.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  return result;
}

mpq_class to_multiple(const mpq_class& value, long exponent) {
  return scaled(mpq_class(nearest_integer(scaled(value, -exponent))), exponent);
}

mpq_class to_bits(const mpq_class& value, long bits) {
  return value == 0 ? value : to_multiple(value, exponent_of(value) + 1 - std::max(bits, 1L));
}

std::vector<mpq_class> simpler(const mpq_class& value) {
  if (value == 0) return {};
  std::vector<mpq_class> result = {0, sgn(value), nearest_integer(value)};
  if (value < 0) result.push_back(-value);
  for (const long bits : ladder) result.push_back(to_bits(value, bits));
  if (value.get_den() == 1) {
    for (const unsigned bits : {1U, 2U, 4U, 8U}) result.emplace_back(cut(value.get_num(), bits));
    result.emplace_back(value - sgn(value));
  }
  const auto worse = [&, own = cost(value)](const mpq_class& other) {
    const std::size_t price = cost(other);
    return price > own || (price == own && (other >= 0) == (value >= 0));
  };
  std::erase_if(result, worse);
  return result;
}

}  // namespace fathom::harness
