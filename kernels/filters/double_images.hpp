// SPDX-License-Identifier: GPL-3.0-or-later
// Directions in binary64, and the signs that these settle: for searches that ask one node or one arc about many arcs and read the images
// of these from one array.                                                                       [proofs/kernels.md, "Plain doubles"]
#pragma once

#include "kernels/predicates/direction.hpp"

namespace fathom {

/// A direction in binary64: each component within 2^-53 of that of the exact one after scaling, hence in [-1, 1].
inline Vec3<double> image(const Direction& d) {
  const Vec3<DoubleInterval>& e = d.enclosure();
  return {e.x.low, e.y.low, e.z.low};
}

/// The sign of <n,d>, exact; or 0 for unsure. Of images or their negatives, in any rounding mode.
inline int sure_side_of_arc(const Vec3<double>& n, const Vec3<double>& d) {
  constexpr double error_bound = 0x1p-48;
  const double value = dot(n, d);
  return value > error_bound ? 1 : value < -error_bound ? -1 : 0;
}

/// The point of arc d1 on the vertical through n: OrderOnVertical(d1, d2, n, v) = <c, d2> for c = n <d1,v> - v <d1,n>.
class VerticalProbe {
 public:
  /// d1, n and v are images of directions, or the negatives of images.
  VerticalProbe(const Vec3<double>& d1, const Vec3<double>& n, const Vec3<double>& v) {
    const double s = dot(d1, v), t = dot(d1, n);
    c_ = {n.x * s - v.x * t, n.y * s - v.y * t, n.z * s - v.z * t};
  }

  /// The sign of OrderOnVertical(d1, d2, n, v), exact; or 0 for unsure. d2 as the others. In any rounding mode. [proofs/kernels.md]
  [[nodiscard]] int sign(const Vec3<double>& d2) const {
    const double value = dot(c_, d2);
    return value > error_bound ? 1 : value < -error_bound ? -1 : 0;
  }

 private:
  static constexpr double error_bound = 0x1p-44;
  Vec3<double> c_;
};

}  // namespace fathom
