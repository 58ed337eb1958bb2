// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {

double image(const mpz_class& c, long exponent) {
  constexpr long negligible = -500;
  if (c == 0) return 0;
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, c.get_mpz_t());
  return own - exponent < negligible ? 0 : std::ldexp(mantissa, static_cast<int>(own - exponent));
}

Vec3<double> image(const Vector& v, long exponent) { return {image(v.x, exponent), image(v.y, exponent), image(v.z, exponent)}; }

Vec3<double> direction_image(const Vector& v) {
  const auto bits = [](const mpz_class& c) { return static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2)); };
  return image(v, std::max({bits(v.x), bits(v.y), bits(v.z)}));
}

}  // namespace fathom::kernels
