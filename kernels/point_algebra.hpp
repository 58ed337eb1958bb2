// SPDX-License-Identifier: GPL-3.0-or-later
// The algebra of positions and of vectors along them. It is in fathom, as Point is, where argument-dependent lookup finds it.
#pragma once

#include "kernels/vector.hpp"

namespace fathom {

inline Point rational(const Vector& v) { return {v.x, v.y, v.z}; }

inline Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
inline Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
inline Point operator-(const Point& p) { return {-p.x, -p.y, -p.z}; }
inline Point operator*(const mpq_class& s, const Point& p) { return {s * p.x, s * p.y, s * p.z}; }
inline Point operator*(const mpq_class& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }

inline mpq_class dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline mpq_class dot(const Vector& u, const Point& p) { return u.x * p.x + u.y * p.y + u.z * p.z; }
inline Point cross(const Point& p, const Point& q) { return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x}; }

/// The primitive vector of the same direction; of O the zero vector.
inline Vector primitive_along(const Point& p) {
  const mpz_class unit = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
  const auto times_unit = [&](const mpq_class& c) { return mpz_class(c.get_num() * (unit / c.get_den())); };
  return primitive({times_unit(p.x), times_unit(p.y), times_unit(p.z)});
}

}  // namespace fathom
