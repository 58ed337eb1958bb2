// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of shapes for tests of the judge.
#pragma once

#include <cmath>

#include "fathom/judge.hpp"
#include "fathom/shape.hpp"

namespace fathom::testing {

inline const Triple diagonal{-std::sqrt(0.5), -std::sqrt(0.5), 0};

inline Shape at(const Shape& shape, const mpq_class& x, const mpq_class& y = 0, const mpq_class& z = 0) {
  return moved(shape, rigid_pose({1, 0, 0, 0}, {x, y, z}));
}

/// Unit balls, the depth is 1/2.
inline ShapeTruth balls() { return truth_about(sphere(1), at(sphere(1), mpq_class(3, 2))); }
/// Parallel cylinders with axes 5/4 sqrt(2) apart: the depth is 2 - 5/4 sqrt(2).
inline ShapeTruth cylinders() {
  const Shape one = cylinder(1, 1);
  return truth_about(one, at(one, mpq_class(5, 4), mpq_class(5, 4)));
}

}  // namespace fathom::testing
