// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that cover the boundary of a hull, twice: by a growing surface for few points, by
// CGAL's quickhull for many.
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "reference/polytope/hull.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

// The hull of few points: one after another joins a surface of triangles, each of which is asked
// whether it sees the point. A triangle does if the point lies strictly above it, so the surface
// stays that of the hull, with coplanar triangles side by side.
//                                                                     [proofs/polytope.md, lemma 1]

/// The corner of a triangle after corner k.
constexpr std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }

struct Face {
  HullTriangle corners;
  std::array<Index, 3> across;  // the face beyond the edge from corner k to the next one
  kernels::Plane plane;
  bool seen = false;  // from the point that is being added
};

class GrowingHull {
 public:
  explicit GrowingHull(std::span<const Vector> points) : points_(points), fan_(points.size()) {}

  std::vector<HullTriangle> of(std::vector<Index> ids) {
    start(ids);
    for (std::size_t i = 4; i < ids.size(); ++i) add(ids[i]);
    std::vector<HullTriangle> triangles;
    triangles.reserve(faces_.size());
    for (const Face& face : faces_) triangles.push_back(face.corners);
    return triangles;
  }

 private:
  struct HorizonEdge {
    Index from, to, beyond;
  };

  [[nodiscard]] Face face(const HullTriangle& t) const { return {t, {}, kernels::Plane(points_, t[0], t[1], t[2])}; }

  /// Brings four points to the front that do not lie in one plane.
  void start(std::vector<Index>& ids) {
    const auto off_line = [&](Index r) { return !kernels::Plane(points_, ids[0], ids[1], r).degenerate(); };
    std::iter_swap(ids.begin() + 2, std::find_if(ids.begin() + 2, ids.end(), off_line));
    const kernels::Plane plane(points_, ids[0], ids[1], ids[2]);
    const auto off_plane = [&](Index s) { return plane.side(s) != kernels::Sign::zero; };
    std::iter_swap(ids.begin() + 3, std::find_if(ids.begin() + 3, ids.end(), off_plane));
    if (plane.side(ids[3]) == kernels::Sign::positive) std::swap(ids[1], ids[2]);
    const auto [a, b, c, d] = std::array{ids[0], ids[1], ids[2], ids[3]};
    faces_ = {face({a, b, c}), face({a, d, b}), face({b, d, c}), face({c, d, a})};
    faces_[0].across = {1, 2, 3};
    faces_[1].across = {3, 2, 0};
    faces_[2].across = {1, 3, 0};
    faces_[3].across = {2, 1, 0};
  }

  void add(Index point) {
    horizon_.clear();
    free_.clear();
    for (Index f = 0; f < faces_.size(); ++f) {
      faces_[f].seen = faces_[f].plane.side(point) == kernels::Sign::positive;
      if (faces_[f].seen) free_.push_back(f);
    }
    for (const Index f : free_)
      for (std::size_t k = 0; k < 3; ++k)
        if (const Index beyond = faces_[f].across[k]; !faces_[beyond].seen)
          horizon_.push_back({faces_[f].corners[k], faces_[f].corners[next(k)], beyond});
    for (const HorizonEdge& edge : horizon_) put(edge, point);
    for (const HorizonEdge& edge : horizon_) {
      const Index mine = fan_[edge.from], following = fan_[edge.to];
      faces_[mine].across[1] = following;
      faces_[following].across[2] = mine;
    }
    drop_free();
  }

  /// The triangle from the edge to the point, where a seen one was if there is one left.
  void put(const HorizonEdge& edge, Index point) {
    Face fresh = face({edge.from, edge.to, point});
    fresh.across[0] = edge.beyond;
    Index place = static_cast<Index>(faces_.size());
    if (free_.empty()) {
      faces_.push_back(std::move(fresh));
    } else {
      place = free_.back();
      free_.pop_back();
      faces_[place] = std::move(fresh);
    }
    Face& beyond = faces_[edge.beyond];
    for (std::size_t k = 0; k < 3; ++k)
      if (beyond.corners[k] == edge.to && beyond.corners[next(k)] == edge.from) beyond.across[k] = place;
    fan_[edge.from] = place;
  }

  /// Fills the places that were not taken again from the end.
  void drop_free() {
    std::ranges::sort(free_, std::greater());
    for (const Index place : free_) {
      const auto last = static_cast<Index>(faces_.size() - 1);
      if (place != last) {
        faces_[place] = std::move(faces_[last]);
        for (std::size_t k = 0; k < 3; ++k) {
          std::array<Index, 3>& back = faces_[faces_[place].across[k]].across;
          std::ranges::replace(back, last, place);
        }
      }
      faces_.pop_back();
    }
  }

  kernels::BoxedPoints points_;
  std::vector<Face> faces_;
  std::vector<HorizonEdge> horizon_;
  std::vector<Index> free_;  // places of faces that are seen
  std::vector<Index> fan_;   // of each point on the horizon: the new face whose edge on the horizon begins there
};

// CGAL's quickhull over indices of points. Its questions go to kernels/filters/plane.hpp, so there
// is one path for small and for enormous integers, and the triangles come back with the ids of the
// input.
//
// CGAL counts a facet as visible from the points of its plane, so a facet with k corners would be
// torn down and rebuilt k times. Here a point counts as moved inward by an infinitesimal whenever
// it lies on the plane in question: facets grow, and k corners cost O(k).
//
// What this relies on and no manual of CGAL promises, the first triangle, the fourth corner, who
// decides what a point sees, and which way round triangles come back, is pinned by
// tests/polytope/quickhull_behaviour_test.cpp.
//
// CGAL's ready-made kernel for doubles is passed by: there convex_hull_3 compares with a static
// error bound, derived for rounding to nearest, while it rounds upward, where each operation may
// err by twice as much.

/// CGAL's ConvexHullTraits_2 on indices: the points as `turn` sees them along coordinate `axis`.
struct PlanarTraits {
  const kernels::BoxedPoints* points;
  int axis;

  [[nodiscard]] bool less(Index p, Index q, int major, int minor) const {
    const auto at = [&](Index i, int c) -> const mpz_class& {
      return kernels::coordinate(points->exact(i), (axis + c) % 3);
    };
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
    return [view = *this](Index p, Index q, Index r) {
      return kernels::turn(*view.points, view.axis, p, q, r) == kernels::Sign::positive;
    };
  }
  [[nodiscard]] Orientation_2 orientation_2_object() const {
    return [view = *this](Index p, Index q, Index r) {
      return static_cast<CGAL::Orientation>(kernels::turn(*view.points, view.axis, p, q, r));
    };
  }
};

/// A point that lies in the interior of every intermediate hull: just off the centroid of CGAL's
/// first triangle, on the side where the fourth corner of its first tetrahedron lies.
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
    bool operator()(Index p, Index q, Index r, Index s) const {
      return kernels::Plane(*points, p, q, r).side(s) == kernels::Sign::zero;
    }
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
      if (const kernels::Sign side = h.plane.side(s); side != kernels::Sign::zero)
        return side == kernels::Sign::positive;
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

/// Moves three points that are not on one line to the front: there convex_hull_3 takes its first
/// triangle. The fourth corner it takes from the triangle's negative side if any point lies there.
Heart choose_heart(const kernels::BoxedPoints& points, std::vector<Index>& order) {
  const auto off_line = [&](Index r) { return !kernels::Plane(points, order[0], order[1], r).degenerate(); };
  std::iter_swap(order.begin() + 2, std::find_if(order.begin() + 2, order.end(), off_line));
  const kernels::Plane plane(points, order[0], order[1], order[2]);
  const bool below = std::ranges::any_of(order, [&](Index s) { return plane.side(s) == kernels::Sign::negative; });
  return {order[0], order[1], order[2], below ? -1 : 1};
}

/// Four points come back from CGAL inside out, more come back right. Asks one triangle and turns
/// all.
void orient_outward(const kernels::BoxedPoints& points, std::span<const Index> corners,
                    std::vector<HullTriangle>& triangles) {
  const kernels::Plane plane(points, triangles[0][0], triangles[0][1], triangles[0][2]);
  const auto off_plane = std::ranges::find_if(corners, [&](Index v) { return plane.side(v) != kernels::Sign::zero; });
  if (plane.side(*off_plane) == kernels::Sign::negative) return;
  for (HullTriangle& t : triangles) std::swap(t[0], t[1]);
}

}  // namespace

std::vector<HullTriangle> hull_triangles_of_few(std::span<const Vector> points, std::span<const std::uint32_t> ids) {
  return GrowingHull(points).of({ids.begin(), ids.end()});
}

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
