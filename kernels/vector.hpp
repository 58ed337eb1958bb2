// SPDX-License-Identifier: GPL-3.0-or-later
// Arithmetic of vectors. It is in fathom, as Vec3 is, where argument-dependent lookup finds it.
#pragma once

#include "fathom/point.hpp"

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

inline Vector operator*(const mpz_class& s, const Vector& v) { return {mpz_class(s * v.x), mpz_class(s * v.y), mpz_class(s * v.z)}; }

template <class NT>
bool is_zero(const Vec3<NT>& v) {
  return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0;
}

/// Lexicographic order on components; the order in which tied optima are listed.
inline bool lexicographically_less(const Vector& a, const Vector& b) {
  if (const int c = cmp(a.x, b.x)) return c < 0;
  if (const int c = cmp(a.y, b.y)) return c < 0;
  return cmp(a.z, b.z) < 0;
}

/// v divided by the greatest common divisor of its components; the zero vector stays.
Vector primitive(const Vector& v);

/// Whether a = s b for a rational s > 0. Neither may be zero.
bool same_direction(const Vector& a, const Vector& b);

}  // namespace fathom
