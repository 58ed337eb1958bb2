// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "kernels/number/rational.hpp"

namespace fathom::kernels {

bool in_lowest_terms(const mpq_class& value) {
  const mpz_class &n = value.get_num(), &d = value.get_den();
  if (sgn(d) <= 0) return false;
  if (d == 1) return true;
  if (mpz_scan1(d.get_mpz_t(), 0) == mpz_sizeinbase(d.get_mpz_t(), 2) - 1) return mpz_odd_p(n.get_mpz_t()) != 0;  // a power of 2
  return gcd(n, d) == 1;
}

void require_lowest_terms(const mpq_class& value) {
  if (in_lowest_terms(value)) return;
  if (value.get_den() == 0) throw std::invalid_argument("the denominator of a number is 0");
  throw std::invalid_argument("a number is not in lowest terms over a positive denominator: mpq_class::canonicalize makes it so");
}

}  // namespace fathom::kernels
