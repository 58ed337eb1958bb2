// SPDX-License-Identifier: GPL-3.0-or-later
// An orthographic view of exact points, across a way: vectors along the way keep their true length,
// and planes across it are seen from the edge. Pictures decide nothing, so the directions of a view
// are rounded; but places are found by an exact linear map, so that a close-up of bodies far from
// O, or of a tiny depth, is as accurate as any, and no place overflows.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::picture {

/// Returns the largest |coordinate|.
mpq_class largest(const Point& p);

/// A place in the plane of a picture, exact; y points up.
struct Spot {
  mpq_class x, y;
};

/// A place in pixels, y points down; or one in the plane, y points up, before it is fitted.
struct Dot {
  double x = 0, y = 0;
};

/// Returns v / |v| to within a few roundings, for any size of v; zero for the zero vector.
Vec3<double> unit_vector(const Point& v);
inline double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }
Point exact_point(const Vec3<double>& v);

class View {
 public:
  /// Views the scene across `along`, which becomes the x axis, with `second` in the picture's plane
  /// too if it is given and not parallel to it. Otherwise from slightly above, turned so that none
  /// of the `edges` is seen end on if possible. `along` must not be zero.
  View(const Point& along, const std::optional<Point>& second, std::span<const Point> edges = {});

  /// Returns the place of p, with the origin at 0. Lengths are kept to within a few roundings, all
  /// by the same factor, and points of one plane across `along` are exactly above each other.
  [[nodiscard]] Spot place(const Point& p) const;
  /// Returns the place of p, with `centre` at 0, in multiples of `unit` > 0.
  [[nodiscard]] Dot project(const Point& p, const Point& centre, const mpq_class& unit) const;
  /// Returns whether a facet with this outward normal faces the viewer, or is seen from its edge.
  [[nodiscard]] bool faces_us(const Vector& normal) const;
  [[nodiscard]] bool sees(const Vec3<double>& unit_normal) const;
  /// Returns the unit vector from the picture to the viewer.
  [[nodiscard]] const Vec3<double>& towards() const { return towards_; }
  /// Returns a multiple of it that is exact: points that differ by it have the same place.
  [[nodiscard]] const Point& look() const { return look_; }

 private:
  Point right_, up_;  // exact multiples of along, and of a vector that is nearly across it; their lengths are nearly 1
  Vec3<double> towards_;
  Point look_;
};

// A rectangle of a picture's plane, shown as a rectangle of pixels. Shifts and scales are exact, so
// that the picture is right for any numbers, and parts far outside are cut exactly.

/// In pixels.
struct PixelSize {
  double width = 0, height = 0;
};

/// A box in the plane.
struct Bounds2 {
  Spot low, high;

  static Bounds2 of(const Spot& p) { return {p, p}; }
  void add(const Spot& p);
  void add(const Bounds2& box);
  /// Returns the box of all sums of a place of each.
  [[nodiscard]] Bounds2 plus(const Bounds2& box) const;
  [[nodiscard]] mpq_class width() const { return high.x - low.x; }
  [[nodiscard]] mpq_class height() const { return high.y - low.y; }
};

class Window {
 public:
  /// Makes a window into which the box fits, with a margin; a box of one place gets some room
  /// around it. If the ratio of width and height exceeds 100, the axes are scaled differently, so
  /// that both can be seen.
  static Window around(const View& view, const Bounds2& box, const PixelSize& size);
  /// Makes a window with `scale` pixels for one unit, and `centre` in the middle.
  static Window close(const View& view, const Spot& centre, const mpq_class& scale, const PixelSize& size);

  [[nodiscard]] const View& view() const { return *view_; }
  [[nodiscard]] const PixelSize& size() const { return size_; }
  [[nodiscard]] bool apart() const { return scale_.x != scale_.y; }
  /// Returns the pixels for one unit along each axis, both positive.
  [[nodiscard]] const Spot& scale() const { return scale_; }

  /// Returns the place of p in pixels; beyond the range of doubles, its dot is infinite.
  [[nodiscard]] Spot pixels(const Point& p) const;
  [[nodiscard]] Dot dot(const Point& p) const;
  /// Returns a vector in pixels.
  [[nodiscard]] Dot shift(const Point& v) const;

  /// Return the part of a segment, or of the convex hull of points moved by `by`, that is in the
  /// window or near it. May be empty.
  [[nodiscard]] std::vector<Dot> segment(const Point& from, const Point& to) const;
  [[nodiscard]] std::vector<Dot> hull(const std::vector<Point>& points, const Point& by = {}) const;
  [[nodiscard]] std::vector<Dot> cut(std::vector<Dot> dots, bool closed) const;

 private:
  Window(const View& view, Spot middle, Spot scale, const PixelSize& size)
      : view_(&view), middle_(std::move(middle)), scale_(std::move(scale)), size_(size) {}
  [[nodiscard]] std::vector<Dot> cut(std::vector<Spot> places, bool closed) const;

  const View* view_;
  Spot middle_, scale_;
  PixelSize size_;
};

/// Returns the "d" of a path: "M1 2L3 4"; closed ones end in "Z". Empty if there are no dots.
std::string path_data(const std::vector<Dot>& dots, bool closed);

// The scale of a picture: a bar of a round length, whose number is exact.

/// A length of one digit, 1, 2 or 5, and a power of ten.
struct RoundLength {
  mpq_class value;
  std::string text;  ///< "0.05", "200"; "2e-7" if that is shorter
};

/// Returns the greatest such length that is at most `most` > 0.
RoundLength round_length(const mpq_class& most);

// Paths and convex polygons of a picture: clipped to a box, and hulls of dots. For doubles, and for
// exact places if doubles would not suffice.

/// Returns the part of a path, or of a closed convex polygon, that lies between `low` and `high`.
/// An open path must be a segment. Empty if a place is not finite.
std::vector<Dot> clipped(std::vector<Dot> path, bool closed, const Dot& low, const Dot& high);
std::vector<Spot> clipped(std::vector<Spot> path, bool closed, const Spot& low, const Spot& high);

/// Returns the part of a closed convex polygon on one side of a line through `on`: where the cross
/// product of `along` and a place less `on` is not negative.
std::vector<Dot> beside(const std::vector<Dot>& polygon, const Dot& on, const Dot& along);

/// Returns the corners of the convex hull, in order. In doubles, for filling: rounding may keep or
/// lose a corner that is almost flat.
std::vector<Dot> outline(std::vector<Dot> dots);
std::vector<Spot> outline(std::vector<Spot> places);

/// Returns the boundary of the union of convex polygons, each in the order of `outline`, as
/// segments: the part of each side that lies in no other polygon and is not a seam between two. For
/// drawing.
std::vector<std::pair<Dot, Dot>> united_outline(const std::vector<std::vector<Dot>>& polygons);

}  // namespace fathom::picture
