// SPDX-License-Identifier: GPL-3.0-or-later
// An orthographic look at exact points: what lies in the plane that a penetration and a claim about it span keeps its true length.
// Pictures decide nothing, so they are drawn in binary64; but places are found by an exact linear map, so that a close-up of bodies
// that lie far away, or whose depth is tiny, is as true as any.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::picture {

/// A place in a picture. Before it is fitted, y points up.
struct Dot {
  double x = 0, y = 0;
};

/// v / |v| to within a few roundings, for any size of v; zero for the zero vector.
Vec3<double> unit_vector(const Point& v);
Point point_of(const Vector& v);

class View {
 public:
  /// Looks across `along`, which becomes the x axis, with `second` in the picture's plane too if it is there and not parallel to it.
  /// `along` must not be zero.
  View(const Point& along, const std::optional<Point>& second);

  /// Where p is, with `centre` at the origin, in multiples of `unit` > 0. Points of one plane across `along` are exactly above each other.
  [[nodiscard]] Dot project(const Point& p, const Point& centre, const mpq_class& unit) const;
  /// Whether a facet with this outward normal is seen.
  [[nodiscard]] bool faces_us(const Vector& normal) const;

 private:
  Point right_, up_;  // right is exact, its greatest component 1 or -1; up is nearly across it, its length nearly 1
  double right_length_;
  Vec3<double> towards_;
};

/// The part of a path, or of a closed convex polygon, that lies in the box [-limit, limit]^2 around `centre`. Of an open path a segment
/// is expected.
std::vector<Dot> clipped(std::vector<Dot> path, bool closed, Dot centre, Dot limit);

/// The corners of the convex hull, in order. For filling: rounding may keep or lose a corner that is almost flat.
std::vector<Dot> outline(std::vector<Dot> dots);

}  // namespace fathom::picture
