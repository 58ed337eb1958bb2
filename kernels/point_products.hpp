// SPDX-License-Identifier: GPL-3.0-or-later
// Products of positions in rationals, and vectors along them. They are in fathom, as Point is, where argument-dependent lookup finds them.
#pragma once

#include "kernels/vector.hpp"

namespace fathom {

inline mpq_class product(const Vector& u, const Point& p) { return u.x * p.x + u.y * p.y + u.z * p.z; }
inline mpq_class product(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline Point cross_product(const Point& p, const Point& q) { return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x}; }

/// The primitive vector of the same direction; of O the zero vector.
inline Vector primitive_along(const Point& p) {
  const mpz_class unit = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
  const auto times_unit = [&](const mpq_class& c) { return mpz_class(c.get_num() * (unit / c.get_den())); };
  return primitive({times_unit(p.x), times_unit(p.y), times_unit(p.z)});
}

}  // namespace fathom
