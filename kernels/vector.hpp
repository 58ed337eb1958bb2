// SPDX-License-Identifier: GPL-3.0-or-later
// Signs, and the arithmetic of vectors and points. What is said of vectors is in fathom, as Vec3
// and Point are, where argument-dependent lookup finds it.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <type_traits>

#include "fathom/point.hpp"

namespace fathom::kernels {

/// What a predicate answers. Zero is an answer ("on"); a filter that cannot tell returns
/// std::optional<Sign> without a value.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

/// The sign of a comparison's result: any int, of which only the sign counts.
constexpr Sign sign_of(int value) { return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero; }
inline Sign sign_of(const mpz_class& value) { return sign_of(sgn(value)); }

constexpr int to_int(Sign s) { return static_cast<int>(s); }
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-to_int(s)); }
constexpr Sign operator*(Sign s, Sign t) { return static_cast<Sign>(to_int(s) * to_int(t)); }

/// Coordinate 0, 1 or 2 of v.
template <class NT>
const NT& coordinate(const Vec3<NT>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The number of bits of |n|, and of the largest component; 0 for 0.
inline long bit_length(const mpz_class& n) { return n == 0 ? 0 : static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); }
inline long bit_length(const Vector& v) { return std::max({bit_length(v.x), bit_length(v.y), bit_length(v.z)}); }

}  // namespace fathom::kernels

namespace fathom {

template <class NT>
NT dot(const Vec3<NT>& a, const Vec3<NT>& b) {
  return NT(a.x * b.x + a.y * b.y + a.z * b.z);
}

template <class NT>
Vec3<NT> cross(const Vec3<NT>& a, const Vec3<NT>& b) {
  return {NT(a.y * b.z - a.z * b.y), NT(a.z * b.x - a.x * b.z), NT(a.x * b.y - a.y * b.x)};
}

/// det(a, b, c) = <a x b, c>.
template <class NT>
NT det(const Vec3<NT>& a, const Vec3<NT>& b, const Vec3<NT>& c) {
  return dot(cross(a, b), c);
}

template <class NT>
Vec3<NT> operator+(const Vec3<NT>& a, const Vec3<NT>& b) {
  return {NT(a.x + b.x), NT(a.y + b.y), NT(a.z + b.z)};
}

template <class NT>
Vec3<NT> operator-(const Vec3<NT>& a, const Vec3<NT>& b) {
  return {NT(a.x - b.x), NT(a.y - b.y), NT(a.z - b.z)};
}

template <class NT>
Vec3<NT> operator-(const Vec3<NT>& a) {
  return {NT(-a.x), NT(-a.y), NT(-a.z)};
}

/// The kind of numbers is that of v: an int or an expression of GMP's becomes one of them.
template <class NT>
Vec3<NT> operator*(const std::type_identity_t<NT>& s, const Vec3<NT>& v) {
  return {NT(s * v.x), NT(s * v.y), NT(s * v.z)};
}

template <class NT>
bool is_zero(const Vec3<NT>& v) {
  return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0;
}

/// Lexicographic order on components, of vectors and of points; the order in which tied optima are
/// listed.
struct LexicographicOrder {
  template <class Triple>
  bool operator()(const Triple& a, const Triple& b) const {
    if (const int c = cmp(a.x, b.x)) return c < 0;
    if (const int c = cmp(a.y, b.y)) return c < 0;
    return cmp(a.z, b.z) < 0;
  }
};
inline constexpr LexicographicOrder lexicographically_less;

/// v divided by the greatest common divisor of its components; the zero vector stays.
inline Vector primitive(const Vector& v) {
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

/// Whether a = s b for a rational s > 0. Neither may be zero.
inline bool same_direction(const Vector& a, const Vector& b) {
  return sgn(a.x) == sgn(b.x) && sgn(a.y) == sgn(b.y) && sgn(a.z) == sgn(b.z) && is_zero(cross(a, b));
}

// Points, and vectors along them.

/// The same position. It is no function, so that argument-dependent lookup does not find it where a
/// room has a function of that name.
inline constexpr auto rational = [](const Vector& v) { return Point{v.x, v.y, v.z}; };

inline Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
inline Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
inline Point operator-(const Point& p) { return {-p.x, -p.y, -p.z}; }
inline Point operator*(const mpq_class& s, const Point& p) { return {s * p.x, s * p.y, s * p.z}; }
/// s n in lowest terms, as s is: n alone can share a factor with the denominator.
inline mpq_class rational_product(const mpq_class& s, const mpz_class& n) {
  mpq_class result;
  const mpz_ptr above = result.get_num_mpz_t(), below = result.get_den_mpz_t();
  mpz_gcd(below, n.get_mpz_t(), s.get_den_mpz_t());
  if (mpz_cmp_ui(below, 1) == 0) {
    mpz_mul(above, s.get_num_mpz_t(), n.get_mpz_t());
    mpz_set(below, s.get_den_mpz_t());
  } else {
    mpz_divexact(above, n.get_mpz_t(), below);
    mpz_mul(above, above, s.get_num_mpz_t());
    mpz_divexact(below, s.get_den_mpz_t(), below);
  }
  return result;
}

/// For rationals and their expressions alone: an int or an mpz_class times a vector is a vector.
template <class Expression>
Point operator*(const __gmp_expr<mpq_t, Expression>& factor, const Vector& v) {
  const mpq_class s(factor);
  return {rational_product(s, v.x), rational_product(s, v.y), rational_product(s, v.z)};
}

inline mpq_class dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline mpq_class dot(const Vector& u, const Point& p) { return u.x * p.x + u.y * p.y + u.z * p.z; }
inline Point cross(const Point& p, const Point& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// The factor > 0 that makes integers without a common divisor of these numbers; 1 if all are 0.
inline mpq_class primitive_factor(std::initializer_list<const mpq_class*> numbers) {
  mpz_class above = 1, below = 0;
  for (const mpq_class* x : numbers) above = lcm(above, x->get_den()), below = gcd(below, x->get_num());
  return {above, below == 0 ? mpz_class(1) : below};
}

/// The primitive vector of the same direction; of O the zero vector.
inline Vector primitive_along(const Point& p) {
  const Point along = primitive_factor({&p.x, &p.y, &p.z}) * p;
  return {along.x.get_num(), along.y.get_num(), along.z.get_num()};
}

}  // namespace fathom
