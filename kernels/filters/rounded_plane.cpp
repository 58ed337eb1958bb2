// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/rounded_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {
// sqrt(m / n) has few roundings, each by a factor below 1 + 2^-51.
double root_from_above(mpz_srcptr numerator, mpz_srcptr denominator, long exponent) {
  if (mpz_sgn(numerator) == 0) return 0;
  long i = 0, j = 0;
  const double m = mpz_get_d_2exp(&i, numerator), n = mpz_get_d_2exp(&j, denominator);
  const long k = i - j - (i - j) % 2;  // even, and what is left is -1, 0 or 1
  const double root = std::sqrt(std::ldexp(m / n, static_cast<int>(i - j - k))) * error_bound::raised_root;
  const long shift = k / 2 - exponent;
  if (shift > 500) return std::numeric_limits<double>::infinity();
  return std::ldexp(root, static_cast<int>(std::max(shift, -500L)));
}

RoundedPlane::RoundedPlane(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r) : p_(p) {
  const Vec3<double> u = q - p, v = r - p;
  n_ = cross(u, v);
  error_ = error_bound::wide_plane(largest(u), largest(v));
  const double height = dot(n_, p), length = std::sqrt(dot(n_, n_));
  height_ = height - error(largest(p));
  length_ = length + 2 * error_.normal;
  distance_ = length > 0 ? height / length : 0;
  trustworthy_ = length > 0x1p20 * error_.normal;
}

std::optional<Sign> RoundedPlane::side(const Vec3<double>& s) const {
  const Vec3<double> w = s - p_;
  return sure_sign(dot(n_, w), error(largest(w)));
}

bool RoundedPlane::surely_beyond(double radius) const {
  return height_ > 0 && height_ > radius * length_ * error_bound::raised_root;
}

}  // namespace fathom::kernels
