// SPDX-License-Identifier: GPL-3.0-or-later
// The predicates of the Gaussian diagrams and their charts, each written once over a number type NT (a ring).        [proofs/kernels.md]
//
// A chart has a frame (v, z) with <v,z> = 0: the hemisphere <n,z> > 0 is projected centrally to the plane <n,z> = 1, v points upward
// there and v x z to the right. n is a node (a facet normal); d is the normal of an arc's great circle (an edge's direction), so no
// two facet normals are ever multiplied where an edge direction is at hand. Each functor returns a number whose sign is the answer.
#pragma once

#include "kernels/counters.hpp"
#include "kernels/vector.hpp"

namespace fathom {

/// Positive: n lies in the chart's hemisphere.
/// (1) odd in n and in z.
struct SideOfEquator {
  static constexpr Predicate id = Predicate::side_of_equator;
  template <class NT>
  NT operator()(const Vec3<NT>& n, const Vec3<NT>& z) const {
    return dot(n, z);
  }
};

/// Positive: n1 lies to the left of n2. Both must lie in one open hemisphere of a pole z with <v,z> = 0; then, with x = <n, v x z>/<n,z>,
/// det(n1,n2,v) |z|^2 = (x2 - x1) <n1,z><n2,z>, so this is an order of the x-coordinates.
/// (1) XOrder(n1,n2) = -XOrder(n2,n1); (2) transitive in one hemisphere; (3) zero exactly on equal x.
struct XOrder {
  static constexpr Predicate id = Predicate::x_order;
  template <class NT>
  NT operator()(const Vec3<NT>& n1, const Vec3<NT>& n2, const Vec3<NT>& v) const {
    return det(n1, n2, v);
  }
};

/// Positive: n lies on the side of the great circle d to which d points. In the chart that is above the arc when <d,v> > 0.
/// (1) odd in n and in d; (2) zero exactly when n lies on the great circle.
struct SideOfArc {
  static constexpr Predicate id = Predicate::side_of_arc;
  template <class NT>
  NT operator()(const Vec3<NT>& n, const Vec3<NT>& d) const {
    return dot(n, d);
  }
};

/// Positive: arc d1 lies above arc d2 on the vertical through n, if <d1,v> and <d2,v> have the same sign; below, if they differ.
/// The point of arc d over n is n + t v with t = -<d,n>/<d,v>. Of degree 4 in the coordinates (Binet-Cauchy).
/// (1) OrderOnVertical(d1,d2) = -OrderOnVertical(d2,d1); (2) odd in d1 and in d2.
struct OrderOnVertical {
  static constexpr Predicate id = Predicate::order_on_vertical;
  template <class NT>
  NT operator()(const Vec3<NT>& d1, const Vec3<NT>& d2, const Vec3<NT>& n, const Vec3<NT>& v) const {
    return NT(dot(d2, n) * dot(d1, v) - dot(d1, n) * dot(d2, v));
  }
};

/// Positive: d1 lies above d2 far to the left of the chart, and below it far to the right, if <d1,v> and <d2,v> have the same sign; the
/// other way round, if they differ. This is OrderOnVertical with n = -(v x z), divided by |v|^2.
/// (1) antisymmetric; (2) odd in d1, d2 and z.
struct OrderAtInfinity {
  static constexpr Predicate id = Predicate::order_at_infinity;
  template <class NT>
  NT operator()(const Vec3<NT>& d1, const Vec3<NT>& d2, const Vec3<NT>& z) const {
    return det(d1, d2, z);
  }
};

}  // namespace fathom
