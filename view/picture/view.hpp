// SPDX-License-Identifier: GPL-3.0-or-later
// An orthographic look at exact points, across a way: what lies along it keeps its true length, and planes across it are seen from the
// edge. Pictures decide nothing, so the directions of a look are rounded; but places are found by an exact linear map, so that a close-up
// of bodies that lie far away, or whose depth is tiny, is as true as any, and no place overflows.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>

#include "kernels/vector.hpp"

namespace fathom::picture {

/// A place in the plane of a picture, exactly; y points up.
struct Spot {
  mpq_class x, y;
};

/// A place in pixels, y points down; or one in the plane, y points up, before it is fitted.
struct Dot {
  double x = 0, y = 0;
};

/// v / |v| to within a few roundings, for any size of v; zero for the zero vector.
Vec3<double> unit_vector(const Point& v);
Point exact_point(const Vec3<double>& v);

class View {
 public:
  /// Looks across `along`, which becomes the x axis, with `second` in the picture's plane too if it is there and not parallel to it.
  /// Without it from a little above, so turned that none of the `edges` is seen end on if that can be. `along` must not be zero.
  View(const Point& along, const std::optional<Point>& second, std::span<const Point> edges = {});

  /// Where p is, if the origin is at 0. Lengths are kept to within a few roundings, all by the same factor, and points of one plane across
  /// `along` are exactly above each other.
  [[nodiscard]] Spot place(const Point& p) const;
  /// Where p is, with `centre` at 0, in multiples of `unit` > 0.
  [[nodiscard]] Dot project(const Point& p, const Point& centre, const mpq_class& unit) const;
  /// Whether a facet with this outward normal is seen, be it from its edge.
  [[nodiscard]] bool faces_us(const Vector& normal) const;
  [[nodiscard]] bool sees(const Vec3<double>& unit_normal) const;
  /// From the picture to who looks at it: a unit vector.
  [[nodiscard]] const Vec3<double>& towards() const { return towards_; }
  /// A multiple of it, exactly along what is seen as one place.
  [[nodiscard]] const Point& look() const { return look_; }

 private:
  Point right_, up_;  // exact multiples of along, and of a vector that is nearly across it; their lengths are nearly 1
  Vec3<double> towards_;
  Point look_;
};

}  // namespace fathom::picture
