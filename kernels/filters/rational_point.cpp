// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/rational_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kernels/filters/double_images.hpp"

namespace fathom::kernels {
namespace {

// Of a sum of four products of images, relative to the sum of their sizes; far more than its roundings and the errors of the images.
constexpr double of_side = 64 * error_bound::unit;
constexpr double of_square = 256 * error_bound::unit;
constexpr double of_underflow = 0x1p-350;  // images of points are less than 2^60 in size

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // every comparison with it fails: the exact one decides

// v / w * 2^-exponent.
double quotient(const mpz_class& v, const mpz_class& w, long exponent) {
  if (v == 0) return 0;
  long i = 0, j = 0;
  const double m = mpz_get_d_2exp(&i, v.get_mpz_t()), n = mpz_get_d_2exp(&j, w.get_mpz_t());
  const long power = i - j - exponent;
  if (power > 58) return unknown;
  return power < -480 ? 0 : std::ldexp(m / n, static_cast<int>(power));
}

mpz_class square(const Vector& v) { return dot(v, v); }

}  // namespace

OrientedPlane oriented_plane(Vector normal, mpz_class height, long exponent) {
  mpz_class shared = gcd(gcd(normal.x, normal.y), normal.z);
  if (shared > 1) {
    for (mpz_class* c : {&normal.x, &normal.y, &normal.z, &height}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), shared.get_mpz_t());
  }
  const auto bits = [](const mpz_class& c) { return static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2)); };
  const long own = std::max({bits(normal.x), bits(normal.y), bits(normal.z)});
  OrientedPlane plane{std::move(normal), std::move(height)};
  plane.image_normal = image(plane.normal, own);
  plane.image_height = image(plane.height, own + exponent);
  return plane;
}

RationalPoint rational_point(Vector v, mpz_class w, long exponent) {
  RationalPoint p{std::move(v), std::move(w)};
  if (p.w < 0) {
    p.v = -p.v;
    p.w = -p.w;
  }
  p.image = {quotient(p.v.x, p.w, exponent), quotient(p.v.y, p.w, exponent), quotient(p.v.z, p.w, exponent)};
  p.image_square = dot(p.image, p.image);
  return p;
}

SquaredDistance squared_distance(const RationalPoint& p) { return {square(p.v), p.w * p.w, p.image_square}; }

int side(const OrientedPlane& plane, const RationalPoint& p) {
  const double x = plane.image_normal.x * p.image.x, y = plane.image_normal.y * p.image.y, z = plane.image_normal.z * p.image.z;
  const double value = x + y + z - plane.image_height;
  const double size = std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(plane.image_height);
  if (const auto sure = sure_sign(value, of_side * size + of_underflow)) return to_int(*sure);
  return sgn(mpz_class(dot(plane.normal, p.v) - plane.height * p.w));
}

int compare(const RationalPoint& p, const SquaredDistance& squared) {
  const double difference = p.image_square - squared.image;
  if (const auto sure = sure_sign(difference, of_square * (p.image_square + squared.image) + of_underflow)) return to_int(*sure);
  return cmp(mpz_class(square(p.v) * squared.denominator), mpz_class(squared.numerator * p.w * p.w));
}

bool farther(const OrientedPlane& plane, const SquaredDistance& squared) {
  if (sgn(plane.height) <= 0) return false;
  const double h = plane.image_height * plane.image_height, limit = squared.image * dot(plane.image_normal, plane.image_normal);
  if (const auto sure = sure_sign(h - limit, of_square * (h + limit) + of_underflow)) return *sure == Sign::positive;
  return plane.height * plane.height * squared.denominator > squared.numerator * square(plane.normal);
}

}  // namespace fathom::kernels
