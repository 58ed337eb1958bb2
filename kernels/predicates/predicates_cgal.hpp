// SPDX-License-Identifier: GPL-3.0-or-later
// The predicates, each written once over a CGAL kernel K: vectors of K in, a sign of CGAL out,
// uncertain where K::FT is an interval. Those with value() are the sign of a number.
//                                                       [proofs/kernels.md; docs/kernel_concept.md]
//
// A chart has a frame (v, z) with <v,z> = 0: the hemisphere <n,z> > 0 is projected centrally to the
// plane <n,z> = 1, v points upward there and v x z to the right. n is a node (a facet normal); d is
// the normal of an arc's great circle (an edge's direction), so no two facet normals are ever
// multiplied where an edge direction is at hand.
#pragma once

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include "fathom/counters.hpp"
#include "kernels/filters/error_bounds.hpp"

namespace fathom::kernels {

template <class K>
using SignOver = typename CGAL::Same_uncertainty_nt<CGAL::Sign, typename K::FT>::type;

/// Positive: n lies in the chart's hemisphere.
/// (1) odd in n and in z.
template <class K>
struct SideOfEquator {
  static constexpr Predicate id = Predicate::side_of_equator;
  static constexpr double error = error_bound::product;
  using result_type = SignOver<K>;
  using Vector_3 = typename K::Vector_3;

  static typename K::FT value(const Vector_3& n, const Vector_3& z) { return CGAL::scalar_product(n, z); }
  result_type operator()(const Vector_3& n, const Vector_3& z) const { return CGAL::sign(value(n, z)); }
};

/// Positive: n1 lies to the left of n2. Both must lie in one open hemisphere of a pole z with <v,z>
/// = 0; then, with x = <n, v x z>/<n,z>, det(n1,n2,v) |z|^2 = (x2 - x1) <n1,z><n2,z>, so this is an
/// order of the x-coordinates.
/// (1) XOrder(n1,n2) = -XOrder(n2,n1); (2) transitive in one hemisphere; (3) zero exactly on equal
///     x.
template <class K>
struct XOrder {
  static constexpr Predicate id = Predicate::x_order;
  static constexpr double error = error_bound::determinant;
  using result_type = SignOver<K>;
  using Vector_3 = typename K::Vector_3;

  static typename K::FT value(const Vector_3& n1, const Vector_3& n2, const Vector_3& v) {
    return CGAL::scalar_product(CGAL::cross_product(n1, n2), v);
  }
  result_type operator()(const Vector_3& n1, const Vector_3& n2, const Vector_3& v) const {
    return CGAL::sign(value(n1, n2, v));
  }
};

/// Positive: n lies on the side of the great circle d to which d points. In the chart that is above
/// the arc when <d,v> > 0.
/// (1) odd in n and in d; (2) zero exactly when n lies on the great circle.
template <class K>
struct SideOfArc {
  static constexpr Predicate id = Predicate::side_of_arc;
  static constexpr double error = error_bound::product;
  using result_type = SignOver<K>;
  using Vector_3 = typename K::Vector_3;

  static typename K::FT value(const Vector_3& n, const Vector_3& d) { return CGAL::scalar_product(n, d); }
  result_type operator()(const Vector_3& n, const Vector_3& d) const { return CGAL::sign(value(n, d)); }
};

/// Positive: arc d1 lies above arc d2 on the vertical through n, if <d1,v> and <d2,v> have the same
/// sign; below, if they differ. The point of arc d over n is n + t v with t = -<d,n>/<d,v>. Of
/// degree 4 in the coordinates (Binet-Cauchy).
/// (1) OrderOnVertical(d1,d2) = -OrderOnVertical(d2,d1); (2) odd in d1 and in d2.
template <class K>
struct OrderOnVertical {
  static constexpr Predicate id = Predicate::order_on_vertical;
  static constexpr double error = error_bound::order_on_vertical;
  using result_type = SignOver<K>;
  using FT = typename K::FT;
  using Vector_3 = typename K::Vector_3;

  static FT value(const Vector_3& d1, const Vector_3& d2, const Vector_3& n, const Vector_3& v) {
    using CGAL::scalar_product;
    return FT(FT(scalar_product(d2, n) * scalar_product(d1, v)) - FT(scalar_product(d1, n) * scalar_product(d2, v)));
  }
  result_type operator()(const Vector_3& d1, const Vector_3& d2, const Vector_3& n, const Vector_3& v) const {
    return CGAL::sign(value(d1, d2, n, v));
  }
};

/// Positive: d1 lies above d2 far to the left of the chart, and below it far to the right, if
/// <d1,v> and <d2,v> have the same sign; the other way round, if they differ. This is
/// OrderOnVertical with n = -(v x z), divided by |v|^2.
/// (1) antisymmetric; (2) odd in d1, d2 and z.
template <class K>
struct OrderAtInfinity {
  static constexpr Predicate id = Predicate::order_at_infinity;
  static constexpr double error = error_bound::determinant;
  using result_type = SignOver<K>;
  using Vector_3 = typename K::Vector_3;

  static typename K::FT value(const Vector_3& d1, const Vector_3& d2, const Vector_3& z) {
    return CGAL::scalar_product(CGAL::cross_product(d1, d2), z);
  }
  result_type operator()(const Vector_3& d1, const Vector_3& d2, const Vector_3& z) const {
    return CGAL::sign(value(d1, d2, z));
  }
};

/// Positive: q lies higher than p in the direction n. With the normal of a plane and a point p on
/// it: the side of q, CGAL's orientation.
/// (1) antisymmetric in p and q; (2) odd in n.
template <class K>
struct HeightOrder {
  using result_type = SignOver<K>;
  using Vector_3 = typename K::Vector_3;

  result_type operator()(const Vector_3& n, const Vector_3& p, const Vector_3& q) const {
    return CGAL::sign(CGAL::scalar_product(n, Vector_3(q - p)));
  }
};

/// Positive: p, q, r turn left, seen along the coordinate `axis` from its positive end. One
/// component of (q - p) x (r - p).
/// (1) CGAL's orientation of the projections.
template <class K>
struct ProjectedTurn {
  using result_type = SignOver<K>;
  using Vector_3 = typename K::Vector_3;
  int axis;

  result_type operator()(const Vector_3& p, const Vector_3& q, const Vector_3& r) const {
    const int right = (axis + 1) % 3, up = (axis + 2) % 3;
    const Vector_3 u = q - p, v = r - p;
    return CGAL::sign_of_determinant(u[right], u[up], v[right], v[up]);
  }
};

/// Positive: the plane <n,x> = h, h > 0, is farther from O than the root of num/den, den > 0; zero:
/// as far. No root is taken.
/// (1) not changed by a positive factor of n and h; (2) an order of planes, where num = h'^2 and
///     den = <n',n'>.
template <class K>
struct CompareDistance {
  using result_type = SignOver<K>;
  using FT = typename K::FT;

  result_type operator()(const typename K::Vector_3& n, const FT& h, const FT& num, const FT& den) const {
    return CGAL::compare(FT(h * h * den), FT(num * n.squared_length()));
  }
};

}  // namespace fathom::kernels
