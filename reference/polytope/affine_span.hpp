// SPDX-License-Identifier: GPL-3.0-or-later
// The affine span of points, over integers of any kind.
#pragma once

#include <cstddef>
#include <utility>

#include "kernels/vector.hpp"

namespace fathom::polytope {

/// The rank of a set of points, up to 3, and for rank 2 a normal of their plane.
template <class Integer>
struct Span {
  int rank = 0;
  Vec3<Integer> normal;
};

/// Of points[0], points[1], ... Linear at worst; stops as soon as the rank is 3. There must be a point.
template <class Integer, class Points>
Span<Integer> affine_span(const Points& points, std::size_t size) {
  Span<Integer> span;
  const Vec3<Integer> origin = points[0];
  Vec3<Integer> direction;
  for (std::size_t i = 1; i < size && span.rank < 3; ++i) {
    Vec3<Integer> d = points[i] - origin;
    if (span.rank == 0) {
      if (is_zero(d)) continue;
      direction = std::move(d);
      span.rank = 1;
    } else if (span.rank == 1) {
      span.normal = cross(direction, d);
      if (!is_zero(span.normal)) span.rank = 2;
    } else if (sgn(dot(span.normal, d)) != 0) {
      span.rank = 3;
    }
  }
  return span;
}

}  // namespace fathom::polytope
