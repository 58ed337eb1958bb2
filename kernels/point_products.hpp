// SPDX-License-Identifier: GPL-3.0-or-later
// Products of positions, in rationals. They are in fathom, as Point is, where argument-dependent lookup finds them.
#pragma once

#include "fathom/point.hpp"

namespace fathom {

inline mpq_class product(const Vector& u, const Point& p) { return u.x * p.x + u.y * p.y + u.z * p.z; }
inline mpq_class product(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline Point cross_product(const Point& p, const Point& q) { return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x}; }

}  // namespace fathom
