// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/vector.hpp"

#include <algorithm>

namespace fathom::kernels {

long bit_length(const mpz_class& n) { return n == 0 ? 0 : static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); }

long bit_length(const Vector& v) { return std::max({bit_length(v.x), bit_length(v.y), bit_length(v.z)}); }

}  // namespace fathom::kernels

namespace fathom {

Vector primitive(const Vector& v) {
  mpz_class g;
  mpz_gcd(g.get_mpz_t(), v.x.get_mpz_t(), v.y.get_mpz_t());
  if (g != 1) mpz_gcd(g.get_mpz_t(), g.get_mpz_t(), v.z.get_mpz_t());
  if (g <= 1) return v;
  Vector r;
  mpz_divexact(r.x.get_mpz_t(), v.x.get_mpz_t(), g.get_mpz_t());
  mpz_divexact(r.y.get_mpz_t(), v.y.get_mpz_t(), g.get_mpz_t());
  mpz_divexact(r.z.get_mpz_t(), v.z.get_mpz_t(), g.get_mpz_t());
  return r;
}

bool same_direction(const Vector& a, const Vector& b) {
  return sgn(a.x) == sgn(b.x) && sgn(a.y) == sgn(b.y) && sgn(a.z) == sgn(b.z) && is_zero(cross(a, b));
}

}  // namespace fathom
