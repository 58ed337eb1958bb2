// SPDX-License-Identifier: GPL-3.0-or-later
// The points, lines and planes that cuts of a mesh meet, each once: equal ones have equal ids.
//                                                                              [proofs/solids.md]
//
// Every plane is one of the mesh's, or of a piece that it is compared with, or goes across an axis
// through a corner; every line is an edge's or where two of these planes meet, every point a corner
// or where such a line meets a plane. So numbers stay short, however many cuts follow one another.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "kernels/filters/meeting_points.hpp"
#include "kernels/id.hpp"
#include "kernels/vector.hpp"

namespace fathom::solids {

using PointId = kernels::Id<struct MeetingPointTag>;
using LineId = kernels::Id<struct MeetingLineTag>;
using PlaneId = kernels::Id<struct MeetingPlaneTag>;

/// A plane with an outside: the side that its normal points to, or the other one.
struct PlaneSide {
  PlaneId plane;
  bool reversed = false;

  [[nodiscard]] PlaneSide opposite() const { return {plane, !reversed}; }
  friend auto operator<=>(const PlaneSide&, const PlaneSide&) = default;
};

/// The line through p in `direction`, by its Pluecker coordinates: `moment` is p x direction. They
/// have no common factor, and the first component of `direction` that is not 0 is positive.
struct SpaceLine {
  Vector direction, moment;
  int axis;                   ///< of that component
  kernels::PlaneImage image;  ///< of the direction, as if it were a plane's normal
};

/// All of them. Coordinates of points are at most 2^exponent in size.
class Arrangement {
 public:
  explicit Arrangement(long exponent) : exponent_(exponent) {}

  /// The point v / w; w is not 0.
  PointId point(Vector v, mpz_class w = 1);
  /// The same of the point in this position.
  PointId point_at(const Point& position);
  /// The plane through three points, its outside where they appear counter-clockwise; nullopt if
  /// they lie on a line.
  std::optional<PlaneSide> plane(PointId p, PointId q, PointId r);
  /// The plane through a point of the mesh's lattice where coordinate `axis` is constant.
  PlaneId plane_across(int axis, PointId p);
  /// The line through two points; where two planes meet, which are not parallel.
  LineId line(PointId p, PointId q);
  LineId line(PlaneId e, PlaneId f);
  /// Where a line meets a plane to which it is not parallel.
  PointId meeting(LineId l, PlaneId e);

  [[nodiscard]] const kernels::RationalPoint& operator[](PointId p) const { return points_[p]; }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  /// 1 if the point lies on the side that the normal points to, -1 on the other one, 0 in the
  /// plane.
  [[nodiscard]] int side(PlaneId e, PointId p) const { return kernels::side(planes_[e], points_[p]); }
  /// 1 if it lies outside, -1 inside.
  [[nodiscard]] int side(PlaneSide e, PointId p) const { return e.reversed ? -side(e.plane, p) : side(e.plane, p); }
  /// The sign of p - q along coordinate `axis`.
  [[nodiscard]] int compare(PointId p, PointId q, std::size_t axis) const {
    return kernels::compare(points_[p], points_[q], static_cast<int>(axis));
  }
  /// Whether p comes before q along the direction of the line that holds both.
  [[nodiscard]] bool before(LineId l, PointId p, PointId q) const {
    return p != q && kernels::compare(points_[p], points_[q], lines_[l].axis) < 0;
  }
  /// The sign of det(n, m, d) for the outward normals of e and f and the direction of l.
  [[nodiscard]] int turn(PlaneSide e, PlaneSide f, LineId l) const;
  /// 1 if the points turn left, seen from outside the plane that holds them, -1 if they turn right.
  [[nodiscard]] int turn(PlaneSide e, PointId p, PointId q, PointId r) const;

 private:
  using Known = std::unordered_multimap<std::size_t, std::uint32_t>;  // by hashes

  PlaneId plane(const Vector& normal, const mpz_class& height);
  LineId line(Vector direction, Vector moment);

  long exponent_;
  kernels::IdVector<PointId, kernels::RationalPoint> points_;
  kernels::IdVector<LineId, SpaceLine> lines_;
  kernels::IdVector<PlaneId, kernels::OrientedPlane> planes_;
  Known known_points_, known_lines_, known_planes_;
};

}  // namespace fathom::solids
