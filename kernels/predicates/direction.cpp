// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/predicates/direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fathom::kernels {

// mpz_get_d_2exp truncates: it leaves m 2^e with 1/2 <= |m| < 1, and the value lies at m 2^e or
// less than one unit in the last place beyond it, away from zero. Scaling to a normal number is
// exact.
DoubleInterval enclose(const mpz_class& c, long shift) {
  if (c == 0) return {};
  constexpr double inf = std::numeric_limits<double>::infinity();
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, c.get_mpz_t());
  exponent -= shift;
  const double scaled = std::ldexp(mantissa, static_cast<int>(std::max(exponent, -4000L)));
  // Below the normal range ldexp rounds too, to one of the neighbours; possibly up to the least
  // normal number.
  if (exponent < std::numeric_limits<double>::min_exponent)
    return {std::nextafter(scaled, -inf), std::nextafter(scaled, inf)};
  const std::size_t bits = mpz_sizeinbase(c.get_mpz_t(), 2);
  const bool truncated = bits > 53 && bits - mpz_scan1(c.get_mpz_t(), 0) > 53;
  if (!truncated) return {scaled, scaled};
  return scaled > 0 ? DoubleInterval{scaled, std::nextafter(scaled, inf)}
                    : DoubleInterval{std::nextafter(scaled, -inf), scaled};
}

Vec3<DoubleInterval> enclose(const Vector& v) {
  const long shift = bit_length(v);
  return {enclose(v.x, shift), enclose(v.y, shift), enclose(v.z, shift)};
}

double image(const Leading& c, long exponent) {
  if (c.mantissa == 0 || c.exponent - exponent < negligible_image) return 0;
  return std::ldexp(c.mantissa, static_cast<int>(c.exponent - exponent));
}

Vec3<double> image(const Vector& v, long exponent) {
  return {image(v.x, exponent), image(v.y, exponent), image(v.z, exponent)};
}

Vec3<double> direction_image(const Vector& v) { return image(v, bit_length(v)); }

}  // namespace fathom::kernels
