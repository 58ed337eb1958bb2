// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/double_images.hpp"

#include <cmath>

namespace fathom {

double image(const mpz_class& c, long exponent) {
  constexpr long negligible = -500;
  if (c == 0) return 0;
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, c.get_mpz_t());
  return own - exponent < negligible ? 0 : std::ldexp(mantissa, static_cast<int>(own - exponent));
}

Vec3<double> image(const Vector& v, long exponent) { return {image(v.x, exponent), image(v.y, exponent), image(v.z, exponent)}; }

}  // namespace fathom
