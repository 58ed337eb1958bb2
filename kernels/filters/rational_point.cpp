// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "kernels/filters/meeting_points.hpp"
#include "kernels/filters/rounded_plane.hpp"
#include "kernels/predicates/direction.hpp"

namespace fathom::kernels {
namespace {

// Of a sum of four products of images, relative to the sum of their sizes; far more than its roundings and the errors of the images.
constexpr double of_side = 64 * error_bound::unit;
constexpr double of_square = 256 * error_bound::unit;
constexpr double of_underflow = 0x1p-350;  // images of points are less than 2^60 in size

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // every comparison with it fails: the exact one decides

template <class Integer>
Integer square(const Vec3<Integer>& v) {
  return dot(v, v);
}

// v / w * 2^-exponent.
double quotient(mpz_srcptr v, mpz_srcptr w, long exponent) {
  if (mpz_sgn(v) == 0) return 0;
  long i = 0, j = 0;
  const double m = mpz_get_d_2exp(&i, v), n = mpz_get_d_2exp(&j, w);
  const long power = i - j - exponent;
  if (power > 58) return unknown;
  return power < -480 ? 0 : std::ldexp(m / n, static_cast<int>(power));
}
double quotient(const mpz_class& v, const mpz_class& w, long exponent) { return quotient(v.get_mpz_t(), w.get_mpz_t(), exponent); }
template <unsigned Bits>
double quotient(const FixedInteger<Bits>& v, const FixedInteger<Bits>& w, long exponent) {
  mpz_t of_v, of_w;
  v.view(of_v);
  w.view(of_w);
  return quotient(static_cast<mpz_srcptr>(of_v), static_cast<mpz_srcptr>(of_w), exponent);
}

// Divides a plane's equation by what its normal's components share.
void reduce(Vector& normal, mpz_class& height) {
  const mpz_class shared = gcd(gcd(normal.x, normal.y), normal.z);
  if (shared <= 1) return;
  for (mpz_class* c : {&normal.x, &normal.y, &normal.z, &height}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), shared.get_mpz_t());
}
template <unsigned Bits>
void reduce(Vec3<FixedInteger<Bits>>& normal, FixedInteger<Bits>& height) {
  if (bit_length(normal) <= 63 && std::gcd(std::gcd(normal.x.to_word(), normal.y.to_word()), normal.z.to_word()) == 1) return;
  Vector wide = as<mpz_class>(normal);
  mpz_class wide_height = height.to_mpz();
  reduce(wide, wide_height);
  normal = as<FixedInteger<Bits>>(wide);
  height = FixedInteger<Bits>(wide_height);
}

long bit_length(const Vector& v) {
  const auto bits = [](const mpz_class& c) { return static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2)); };
  return std::max({bits(v.x), bits(v.y), bits(v.z)});
}

}  // namespace

template <class Numbers>
OrientedPlaneIn<Numbers> oriented_plane(Vec3<typename Numbers::OfPlane> normal, typename Numbers::OfPlane height, long exponent) {
  reduce(normal, height);
  const long own = bit_length(normal);
  const PlaneImage rounded{image(normal, own), image(height, own + exponent)};
  return {std::move(normal), std::move(height), rounded};
}

template <class Numbers>
RationalPointIn<Numbers> rational_point(const Vec3<typename Numbers::Product>& v, const typename Numbers::Product& w, long exponent) {
  using Integer = typename Numbers::OfPoint;
  RationalPointIn<Numbers> p{as<Integer>(v), as<Integer>(w), {}, 0};
  if (sgn(p.w) < 0) {
    p.v = -p.v;
    p.w = -p.w;
  }
  p.image = {quotient(p.v.x, p.w, exponent), quotient(p.v.y, p.w, exponent), quotient(p.v.z, p.w, exponent)};
  p.image_square = dot(p.image, p.image);
  return p;
}

template <class Numbers>
SquaredDistanceIn<Numbers> squared_distance(const RationalPointIn<Numbers>& p) {
  using Product = typename Numbers::Product;
  const auto& w = as<Product>(p.w);
  return {square(as<Product>(p.v)), Product(w * w), p.image_square};
}

template <class Numbers>
int side(const OrientedPlaneIn<Numbers>& plane, const RationalPointIn<Numbers>& p) {
  const Vec3<double>& n = plane.image.normal;
  const double x = n.x * p.image.x, y = n.y * p.image.y, z = n.z * p.image.z, height = plane.image.height;
  const double size = std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(height);
  if (const auto sure = sure_sign(x + y + z - height, of_side * size + of_underflow)) return to_int(*sure);
  using Product = typename Numbers::Product;
  return sgn(Product(dot(as<Product>(plane.normal), as<Product>(p.v)) - as<Product>(plane.height) * as<Product>(p.w)));
}

template <class Numbers>
int compare(const RationalPointIn<Numbers>& p, const SquaredDistanceIn<Numbers>& squared) {
  const double difference = p.image_square - squared.image;
  if (const auto sure = sure_sign(difference, of_square * (p.image_square + squared.image) + of_underflow)) return to_int(*sure);
  using Product = typename Numbers::Product;
  const auto& w = as<Product>(p.w);
  return cmp(Product(square(as<Product>(p.v)) * squared.denominator), Product(squared.numerator * w * w));
}

template <class Numbers>
bool farther(const OrientedPlaneIn<Numbers>& plane, const SquaredDistanceIn<Numbers>& squared) {
  if (sgn(plane.height) <= 0) return false;
  const double h = plane.image.height * plane.image.height, limit = squared.image * dot(plane.image.normal, plane.image.normal);
  if (const auto sure = sure_sign(h - limit, of_square * (h + limit) + of_underflow)) return *sure == Sign::positive;
  using Product = typename Numbers::Product;
  const auto& height = as<Product>(plane.height);
  return cmp(Product(height * height * squared.denominator), Product(squared.numerator * square(as<Product>(plane.normal)))) > 0;
}

template OrientedPlaneIn<AnyNumbers> oriented_plane<AnyNumbers>(Vec3<AnyNumbers::OfPlane>, AnyNumbers::OfPlane, long);
template RationalPointIn<AnyNumbers> rational_point<AnyNumbers>(const Vec3<AnyNumbers::Product>&, const AnyNumbers::Product&, long);
template SquaredDistanceIn<AnyNumbers> squared_distance(const RationalPointIn<AnyNumbers>&);
template int side(const OrientedPlaneIn<AnyNumbers>&, const RationalPointIn<AnyNumbers>&);
template int compare(const RationalPointIn<AnyNumbers>&, const SquaredDistanceIn<AnyNumbers>&);
template bool farther(const OrientedPlaneIn<AnyNumbers>&, const SquaredDistanceIn<AnyNumbers>&);

template OrientedPlaneIn<FixedNumbers> oriented_plane<FixedNumbers>(Vec3<FixedNumbers::OfPlane>, FixedNumbers::OfPlane, long);
template RationalPointIn<FixedNumbers> rational_point<FixedNumbers>(const Vec3<FixedNumbers::Product>&, const FixedNumbers::Product&, long);
template SquaredDistanceIn<FixedNumbers> squared_distance(const RationalPointIn<FixedNumbers>&);
template int side(const OrientedPlaneIn<FixedNumbers>&, const RationalPointIn<FixedNumbers>&);
template int compare(const RationalPointIn<FixedNumbers>&, const SquaredDistanceIn<FixedNumbers>&);
template bool farther(const OrientedPlaneIn<FixedNumbers>&, const SquaredDistanceIn<FixedNumbers>&);

}  // namespace fathom::kernels
