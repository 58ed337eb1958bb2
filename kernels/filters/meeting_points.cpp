// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/meeting_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {
namespace {

using error_bound::unit;

// Of a sum of four products of images, and of a comparison of squares, relative to the sum of their
// sizes; far more than their roundings and the errors of the images.
constexpr double of_side = 64 * unit, of_order = 256 * unit;
constexpr double of_underflow = 0x1p-350;  // images of points are less than 2^60 in size

constexpr double unknown =
    std::numeric_limits<double>::quiet_NaN();  // every comparison with it fails: the exact one decides

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
double quotient(const mpz_class& v, const mpz_class& w, long exponent) {
  return quotient(v.get_mpz_t(), w.get_mpz_t(), exponent);
}
template <unsigned Bits>
double quotient(const FixedInteger<Bits>& v, const FixedInteger<Bits>& w, long exponent) {
  return of_views([](mpz_srcptr n, mpz_srcptr d, long e) { return quotient(n, d, e); }, v, w, exponent);
}

// Divides a plane's equation by what its numbers share: all that the normal's components do, if the
// plane goes through a lattice point.
void reduce(Vector& normal, mpz_class& height) {
  mpz_class shared = gcd(gcd(normal.x, normal.y), normal.z);
  if (shared > 1) shared = gcd(shared, height);
  if (shared <= 1) return;
  for (mpz_class* c : {&normal.x, &normal.y, &normal.z, &height})
    mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), shared.get_mpz_t());
}
template <unsigned Bits>
void reduce(Vec3<FixedInteger<Bits>>& normal, FixedInteger<Bits>& height) {
  if (bit_length(normal) <= 63 && std::gcd(std::gcd(normal.x.to_word(), normal.y.to_word()), normal.z.to_word()) == 1)
    return;
  Vector wide = as<mpz_class>(normal);
  mpz_class wide_height = height.to_mpz();
  reduce(wide, wide_height);
  normal = as<FixedInteger<Bits>>(wide);
  height = FixedInteger<Bits>(wide_height);
}

// Of the components of g x h; of <g x h, e>; of |g x h|^2; of |g|^2. Normals have components of at
// most 1.
constexpr double of_direction = 16 * unit, of_determinant = 64 * unit, of_square = 256 * unit, of_normal = 16 * unit;
// Of the numerators of a plane's foot, a line's foot and the meeting of three planes, relative to
// the sum of the heights' sizes.
constexpr double of_plane_foot = 4 * unit, of_line_foot = 64 * unit, of_meeting = 32 * unit;
// Beyond these, underflow could count.
constexpr double most_height = 0x1p20, least_denominator = 0x1p-40;

// v / w, where each component of v errs by `error_v`, and w by `error_w`.
PointImage image_of_quotient(const Vec3<double>& v, double error_v, double w, double error_w, double heights) {
  const double least = std::fabs(w) - error_w;
  if (!(least > least_denominator && heights < most_height)) return {{}, std::numeric_limits<double>::infinity()};
  const Vec3<double> p{v.x / w, v.y / w, v.z / w};
  const double size = largest(p);
  return {p, 2 * (error_v + size * error_w) / least + 4 * unit * size + of_underflow};
}

Vec3<double> scaled(double s, const Vec3<double>& v) { return {s * v.x, s * v.y, s * v.z}; }

}  // namespace

template <class Numbers>
OrientedPlaneIn<Numbers> oriented_plane(Vec3<typename Numbers::OfPlane> normal, typename Numbers::OfPlane height,
                                        long exponent) {
  reduce(normal, height);
  const long own = bit_length(normal);
  const PlaneImage rounded{image(normal, own), image(height, own + exponent)};
  return {std::move(normal), std::move(height), rounded};
}

template <class Numbers>
RationalPointIn<Numbers> rational_point(const Vec3<typename Numbers::Product>& v, const typename Numbers::Product& w,
                                        long exponent) {
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
int compare(const RationalPointIn<Numbers>& p, const RationalPointIn<Numbers>& q, int axis) {
  const double of_p = coordinate(p.image, axis), of_q = coordinate(q.image, axis);
  const double size = std::fabs(of_p) + std::fabs(of_q);
  if (const auto sure = sure_sign(of_p - of_q, of_side * size + of_underflow)) return to_int(*sure);
  using Product = typename Numbers::Product;
  return cmp(Product(as<Product>(coordinate(p.v, axis)) * as<Product>(q.w)),
             Product(as<Product>(coordinate(q.v, axis)) * as<Product>(p.w)));
}

template <class Numbers>
int compare(const RationalPointIn<Numbers>& p, const SquaredDistanceIn<Numbers>& squared) {
  const double difference = p.image_square - squared.image;
  if (const auto sure = sure_sign(difference, of_order * (p.image_square + squared.image) + of_underflow))
    return to_int(*sure);
  using Product = typename Numbers::Product;
  const auto& w = as<Product>(p.w);
  return cmp(Product(square(as<Product>(p.v)) * squared.denominator), Product(squared.numerator * w * w));
}

template <class Numbers>
bool farther(const OrientedPlaneIn<Numbers>& plane, const SquaredDistanceIn<Numbers>& squared) {
  if (sgn(plane.height) <= 0) return false;
  const double h = plane.image.height * plane.image.height,
               limit = squared.image * dot(plane.image.normal, plane.image.normal);
  if (const auto sure = sure_sign(h - limit, of_order * (h + limit) + of_underflow)) return *sure == Sign::positive;
  using Product = typename Numbers::Product;
  const auto& height = as<Product>(plane.height);
  return cmp(Product(height * height * squared.denominator),
             Product(squared.numerator * square(as<Product>(plane.normal)))) > 0;
}

template OrientedPlaneIn<AnyNumbers> oriented_plane<AnyNumbers>(Vec3<AnyNumbers::OfPlane>, AnyNumbers::OfPlane, long);
template RationalPointIn<AnyNumbers> rational_point<AnyNumbers>(const Vec3<AnyNumbers::Product>&,
                                                                const AnyNumbers::Product&, long);
template SquaredDistanceIn<AnyNumbers> squared_distance(const RationalPointIn<AnyNumbers>&);
template int side(const OrientedPlaneIn<AnyNumbers>&, const RationalPointIn<AnyNumbers>&);
template int compare(const RationalPointIn<AnyNumbers>&, const RationalPointIn<AnyNumbers>&, int);
template int compare(const RationalPointIn<AnyNumbers>&, const SquaredDistanceIn<AnyNumbers>&);
template bool farther(const OrientedPlaneIn<AnyNumbers>&, const SquaredDistanceIn<AnyNumbers>&);

template OrientedPlaneIn<FixedNumbers> oriented_plane<FixedNumbers>(Vec3<FixedNumbers::OfPlane>, FixedNumbers::OfPlane,
                                                                    long);
template RationalPointIn<FixedNumbers> rational_point<FixedNumbers>(const Vec3<FixedNumbers::Product>&,
                                                                    const FixedNumbers::Product&, long);
template SquaredDistanceIn<FixedNumbers> squared_distance(const RationalPointIn<FixedNumbers>&);
template int side(const OrientedPlaneIn<FixedNumbers>&, const RationalPointIn<FixedNumbers>&);
template int compare(const RationalPointIn<FixedNumbers>&, const RationalPointIn<FixedNumbers>&, int);
template int compare(const RationalPointIn<FixedNumbers>&, const SquaredDistanceIn<FixedNumbers>&);
template bool farther(const OrientedPlaneIn<FixedNumbers>&, const SquaredDistanceIn<FixedNumbers>&);

PointImage foot_image(const PlaneImage& g) {
  const Vec3<double>& n = g.normal;
  const double height = std::fabs(g.height);
  return image_of_quotient(scaled(g.height, n), of_plane_foot * height, dot(n, n), of_normal, height);
}

MeetingLine::MeetingLine(const PlaneImage& g, const PlaneImage& h)
    : g_(g), h_(h), direction_(cross(g.normal, h.normal)) {}

bool MeetingLine::surely_exists() const { return largest(direction_) > of_direction; }

PointImage MeetingLine::foot() const {
  const Vec3<double> v =
      scaled(g_.height, cross(h_.normal, direction_)) + scaled(h_.height, cross(direction_, g_.normal));
  const double heights = std::fabs(g_.height) + std::fabs(h_.height);
  return image_of_quotient(v, of_line_foot * heights, dot(direction_, direction_), of_square, heights);
}

std::optional<Sign> MeetingLine::leads_beyond(const PlaneImage& e) const {
  return sure_sign(dot(direction_, e.normal), of_determinant);
}

PointImage MeetingLine::meeting(const PlaneImage& e) const {
  const Vec3<double> v = scaled(g_.height, cross(h_.normal, e.normal)) + scaled(h_.height, cross(e.normal, g_.normal)) +
                         scaled(e.height, direction_);
  const double heights = std::fabs(g_.height) + std::fabs(h_.height) + std::fabs(e.height);
  return image_of_quotient(v, of_meeting * heights, dot(direction_, e.normal), of_determinant, heights);
}

std::optional<Sign> sure_side(const PlaneImage& plane, const PointImage& p) {
  const double x = plane.normal.x * p.at.x, y = plane.normal.y * p.at.y, z = plane.normal.z * p.at.z;
  const double size = std::fabs(x) + std::fabs(y) + std::fabs(z) + std::fabs(plane.height);
  return sure_sign(x + y + z - plane.height, of_side * size + 4 * p.error + of_underflow);
}

std::optional<Sign> sure_order(const PointImage& p, double squared) {
  const double square = dot(p.at, p.at), error = 8 * p.error * (largest(p.at) + p.error);
  return sure_sign(square - squared, of_order * (square + squared) + error + of_underflow);
}

}  // namespace fathom::kernels
