// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's quickhull over indices of points. Its questions go to kernels/filters/plane.hpp, so there is one path for small and for enormous
// integers, and the triangles come back with the ids of the input.
//
// CGAL counts a facet as visible from the points of its plane, so a facet with k corners would be torn down and rebuilt k times. Here
// a point counts as moved inward by an infinitesimal whenever it lies on the plane in question: facets grow, and k corners cost O(k).
//
// What this relies on and no manual of CGAL promises, the first triangle, the fourth corner, who decides what a point sees, and which way
// round triangles come back, is pinned by tests/polytope/quickhull_behaviour_test.cpp.
//
// CGAL's ready-made kernel for doubles is passed by: there convex_hull_3 compares with a static error bound, derived for rounding to
// nearest, while it rounds upward, where each operation may err by twice as much.
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "reference/polytope/hull.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

/// CGAL's ConvexHullTraits_2 on indices: the points as `turn` sees them along coordinate `axis`.
struct PlanarTraits {
  const kernels::BoxedPoints* points;
  int axis;

  [[nodiscard]] bool less(Index p, Index q, int major, int minor) const {
    const auto at = [&](Index i, int c) -> const mpz_class& { return kernels::coordinate(points->exact(i), (axis + c) % 3); };
    const int c = cmp(at(p, major), at(q, major));
    return c != 0 ? c < 0 : at(p, minor) < at(q, minor);
  }

  using Point_2 = Index;
  using Equal_2 = std::equal_to<Index>;
  using Less_xy_2 = std::function<bool(Index, Index)>;
  using Less_yx_2 = Less_xy_2;
  using Left_turn_2 = std::function<bool(Index, Index, Index)>;
  using Orientation_2 = std::function<CGAL::Orientation(Index, Index, Index)>;

  [[nodiscard]] Equal_2 equal_2_object() const { return {}; }
  [[nodiscard]] Less_xy_2 less_xy_2_object() const {
    return [view = *this](Index p, Index q) { return view.less(p, q, 1, 2); };
  }
  [[nodiscard]] Less_yx_2 less_yx_2_object() const {
    return [view = *this](Index p, Index q) { return view.less(p, q, 2, 1); };
  }
  [[nodiscard]] Left_turn_2 left_turn_2_object() const {
    return [view = *this](Index p, Index q, Index r) { return kernels::turn(*view.points, view.axis, p, q, r) == kernels::Sign::positive; };
  }
  [[nodiscard]] Orientation_2 orientation_2_object() const {
    return [view = *this](Index p, Index q, Index r) {
      return static_cast<CGAL::Orientation>(kernels::turn(*view.points, view.axis, p, q, r));
    };
  }
};

/// A point that lies in the interior of every intermediate hull: just off the centroid of CGAL's first triangle, on the side where the
/// fourth corner of its first tetrahedron lies.
struct Heart {
  Index p, q, r;
  int side;
};

/// CGAL's ConvexHullTraits_3 on indices.
struct SpatialTraits {
  const kernels::BoxedPoints* points;
  Heart heart;

  using Point_3 = Index;
  struct Plane_3 {
    kernels::Plane plane;
    Index corner;
    mutable std::optional<int> heart_side{};  // found for the first point on the plane
  };

  using Equal_3 = std::equal_to<Index>;
  struct Collinear_3 {
    const kernels::BoxedPoints* points;
    bool operator()(Index p, Index q, Index r) const { return kernels::Plane(*points, p, q, r).degenerate(); }
  };
  struct Coplanar_3 {
    const kernels::BoxedPoints* points;
    bool operator()(Index p, Index q, Index r, Index s) const { return kernels::Plane(*points, p, q, r).side(s) == kernels::Sign::zero; }
  };
  struct Construct_plane_3 {
    const kernels::BoxedPoints* points;
    Plane_3 operator()(Index p, Index q, Index r) const { return {kernels::Plane(*points, p, q, r), p}; }
  };
  struct Less_signed_distance_to_plane_3 {
    bool operator()(const Plane_3& h, Index s, Index t) const { return h.plane.rise(s, t) == kernels::Sign::positive; }
  };
  struct Less_distance_to_point_3 {
    const kernels::BoxedPoints* points;
    bool operator()(Index p, Index s, Index t) const {
      const Vector ps = points->exact(s) - points->exact(p), pt = points->exact(t) - points->exact(p);
      return dot(ps, ps) < dot(pt, pt);
    }
  };
  /// Whether s, moved towards the heart by an infinitesimal if it lies on the plane, lies above it.
  struct Has_on_positive_side_3 {
    const SpatialTraits* traits;
    bool operator()(const Plane_3& h, Index s) const {
      if (const kernels::Sign side = h.plane.side(s); side != kernels::Sign::zero) return side == kernels::Sign::positive;
      if (!h.heart_side) h.heart_side = traits->heart_side(h);
      return *h.heart_side > 0;
    }
  };

  /// Where the centroid lies on the plane, the way on from there decides.
  [[nodiscard]] int heart_side(const Plane_3& h) const {
    const auto from_corner = [&](Index i) { return points->exact(i) - points->exact(h.corner); };
    const Vector to_centroid = from_corner(heart.p) + from_corner(heart.q) + from_corner(heart.r);
    if (const int side = sgn(dot(h.plane.normal(), to_centroid))) return side;
    return heart.side * sgn(dot(h.plane.normal(), kernels::Plane(*points, heart.p, heart.q, heart.r).normal()));
  }

  using Traits_xy_3 = PlanarTraits;
  using Traits_yz_3 = PlanarTraits;
  using Traits_xz_3 = PlanarTraits;

  [[nodiscard]] Equal_3 equal_3_object() const { return {}; }
  [[nodiscard]] Collinear_3 collinear_3_object() const { return {points}; }
  [[nodiscard]] Coplanar_3 coplanar_3_object() const { return {points}; }
  [[nodiscard]] Construct_plane_3 construct_plane_3_object() const { return {points}; }
  [[nodiscard]] Has_on_positive_side_3 has_on_positive_side_3_object() const { return {this}; }
  [[nodiscard]] Less_signed_distance_to_plane_3 less_signed_distance_to_plane_3_object() const { return {}; }
  [[nodiscard]] Less_distance_to_point_3 less_distance_to_point_3_object() const { return {points}; }
  [[nodiscard]] PlanarTraits construct_traits_xy_3_object() const { return {points, 2}; }
  [[nodiscard]] PlanarTraits construct_traits_yz_3_object() const { return {points, 0}; }
  [[nodiscard]] PlanarTraits construct_traits_xz_3_object() const { return {points, 1}; }
};

/// Moves three points that are not on one line to the front: there convex_hull_3 takes its first triangle. The fourth corner it takes
/// from the triangle's negative side if any point lies there.
Heart choose_heart(const kernels::BoxedPoints& points, std::vector<Index>& order) {
  const auto off_line = [&](Index r) { return !kernels::Plane(points, order[0], order[1], r).degenerate(); };
  std::iter_swap(order.begin() + 2, std::find_if(order.begin() + 2, order.end(), off_line));
  const kernels::Plane plane(points, order[0], order[1], order[2]);
  const bool below = std::ranges::any_of(order, [&](Index s) { return plane.side(s) == kernels::Sign::negative; });
  return {order[0], order[1], order[2], below ? -1 : 1};
}

/// Four points come back from CGAL inside out, more come back right. Asks one triangle and turns all.
void orient_outward(const kernels::BoxedPoints& points, std::span<const Index> corners, std::vector<HullTriangle>& triangles) {
  const kernels::Plane plane(points, triangles[0][0], triangles[0][1], triangles[0][2]);
  const auto off_plane = std::ranges::find_if(corners, [&](Index v) { return plane.side(v) != kernels::Sign::zero; });
  if (plane.side(*off_plane) == kernels::Sign::negative) return;
  for (HullTriangle& t : triangles) std::swap(t[0], t[1]);
}

}  // namespace

std::vector<HullTriangle> hull_triangles(std::span<const Vector> points, std::span<const std::uint32_t> ids) {
  const kernels::BoxedPoints boxed(points);
  std::vector<Index> order(ids.begin(), ids.end()), corners;
  std::vector<HullTriangle> triangles;
  const SpatialTraits traits{&boxed, choose_heart(boxed, order)};
  // CGAL 5.5 has a template parameter here that it neither uses nor deduces.
  CGAL::convex_hull_3<std::vector<Index>::iterator, void>(order.begin(), order.end(), corners, triangles, traits);
  for (HullTriangle& t : triangles) {
    for (Index& v : t) v = corners[v];
  }
  orient_outward(boxed, corners, triangles);
  return triangles;
}

std::vector<std::uint32_t> hull_cycle(std::span<const Vector> points, std::span<const std::uint32_t> ids, int axis) {
  const kernels::BoxedPoints boxed(points);
  std::vector<Index> cycle;
  CGAL::convex_hull_2(ids.begin(), ids.end(), std::back_inserter(cycle), PlanarTraits{&boxed, axis});
  return cycle;
}

}  // namespace fathom::polytope
