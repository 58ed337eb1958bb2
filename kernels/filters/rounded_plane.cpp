// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a rounded plane. Images p', q', r', s' lie within 2^-52 of the points, |.| <= 2. An operation errs by e = 2^-52 of its result
// at most, whatever the rounding mode; what underflows is far below the terms in d^2 and d^3.
//   edges     u' = fl(q' - p'): components up to 4, so |u' - u| <= 2 * 2^-52 + 2^-51 = d = 2^-50; the same for v' and w' = fl(s' - p')
//   normal    with U = max |u'_i|, V = max |v'_i|:  |n'_i - n_i| <= 2 d (U + V) + 2 d^2 + 4.1 e U V  <  N = 4 (d (U + V) + d^2 + 2 e U V),
//             and |n'_i| <= M = 2.1 U V
//   product   with W = max |w'_i|:  |fl<n',w'> - <n,w>| <= 3 (N (W + d) + M d) + 8.1 e M W  <  (4 N + 12 e M) W + 4 d (N + M)
// The same holds with w = p itself. N, the slope and the floor are computed with errors that the slack in their constants covers.
//   length    |n| <= |n'| + sqrt(3) N < |n'| + 2 N; squares of n' that underflow are below N
#include "kernels/filters/rounded_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/filters/double_images.hpp"

namespace fathom {
namespace {

constexpr double e = 0x1p-52, d = 0x1p-50;
constexpr long negligible = -500;
constexpr double slack = 1 + 0x1p-40;

Vec3<double> minus(const Vec3<double>& a, const Vec3<double>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

double product(const Vec3<double>& a, const Vec3<double>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

double greatest(const Vec3<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// Truncated to 53 bits: below 2 that is an error under 2^-52.
double rounded(const mpz_class& c, long exponent) {
  if (c == 0) return 0;
  long k = 0;
  const double m = mpz_get_d_2exp(&k, c.get_mpz_t());
  return k - exponent < negligible ? 0 : std::ldexp(m, static_cast<int>(k - exponent));
}

}  // namespace

Vec3<double> rounded(const Vector& v, long exponent) { return {rounded(v.x, exponent), rounded(v.y, exponent), rounded(v.z, exponent)}; }

// sqrt(m / n) has few roundings, each by a factor below 1 + 2^-51.
double root_from_above(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  if (numerator == 0) return 0;
  long i = 0, j = 0;
  const double m = mpz_get_d_2exp(&i, numerator.get_mpz_t()), n = mpz_get_d_2exp(&j, denominator.get_mpz_t());
  const long k = i - j - (i - j) % 2;  // even, and what is left is -1, 0 or 1
  const double root = std::sqrt(std::ldexp(m / n, static_cast<int>(i - j - k))) * slack;
  const long shift = k / 2 - exponent;
  if (shift > -negligible) return std::numeric_limits<double>::infinity();
  return std::ldexp(root, static_cast<int>(std::max(shift, negligible)));
}

RoundedPlane::RoundedPlane(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r) : p_(p) {
  const Vec3<double> u = minus(q, p), v = minus(r, p);
  n_ = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double U = greatest(u), V = greatest(v);
  const double N = 4 * (d * (U + V) + d * d + 2 * e * U * V), M = 2.1 * U * V;
  slope_ = 4 * N + 12 * e * M;
  floor_ = 4 * d * (N + M);
  const double height = product(n_, p), length = std::sqrt(product(n_, n_));
  height_ = height - error(greatest(p));
  length_ = length + 2 * N;
  distance_ = length > 0 ? height / length : 0;
  trustworthy_ = length > 0x1p20 * N;
}

std::optional<Sign> RoundedPlane::side(const Vec3<double>& s) const {
  const Vec3<double> w = minus(s, p_);
  return sure_sign(product(n_, w), error(greatest(w)));
}

bool RoundedPlane::surely_beyond(double radius) const { return height_ > 0 && height_ > radius * length_ * slack; }

}  // namespace fathom
