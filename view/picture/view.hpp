// SPDX-License-Identifier: GPL-3.0-or-later
// An orthographic look at exact points, across a way: what lies along it keeps its true length, and
// planes across it are seen from the edge. Pictures decide nothing, so the directions of a look are
// rounded; but places are found by an exact linear map, so that a close-up of bodies that lie far
// away, or whose depth is tiny, is as true as any, and no place overflows.
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

/// The largest |coordinate|.
mpq_class largest(const Point& p);

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
inline double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }
Point exact_point(const Vec3<double>& v);

class View {
 public:
  /// Looks across `along`, which becomes the x axis, with `second` in the picture's plane too if it
  /// is there and not parallel to it. Without it from a little above, so turned that none of the
  /// `edges` is seen end on if that can be. `along` must not be zero.
  View(const Point& along, const std::optional<Point>& second, std::span<const Point> edges = {});

  /// Where p is, if the origin is at 0. Lengths are kept to within a few roundings, all by the same
  /// factor, and points of one plane across `along` are exactly above each other.
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

// A rectangle of a picture's plane, shown as a rectangle of pixels. Shifts and scales are exact, so
// that what is shown is right whatever the numbers are, and what lies far outside is cut exactly.

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
  /// The box of all sums of a place of each.
  [[nodiscard]] Bounds2 plus(const Bounds2& box) const;
  [[nodiscard]] mpq_class width() const { return high.x - low.x; }
  [[nodiscard]] mpq_class height() const { return high.y - low.y; }
};

class Window {
 public:
  /// The box fits, with a margin; a box of one place gets some room around it. If it is over 100
  /// times as wide as high, or as high as wide, the axes are scaled apart, so that both can be
  /// seen.
  static Window around(const View& view, const Bounds2& box, const PixelSize& size);
  /// `scale` pixels for one unit, with `centre` in the middle.
  static Window close(const View& view, const Spot& centre, const mpq_class& scale, const PixelSize& size);

  [[nodiscard]] const View& view() const { return *view_; }
  [[nodiscard]] const PixelSize& size() const { return size_; }
  [[nodiscard]] bool apart() const { return scale_.x != scale_.y; }
  /// Pixels for one unit along the axes; y, too, is positive.
  [[nodiscard]] const Spot& scale() const { return scale_; }

  /// Where p is, in pixels: as a dot infinite beyond the range of doubles.
  [[nodiscard]] Spot pixels(const Point& p) const;
  [[nodiscard]] Dot dot(const Point& p) const;
  /// A vector in pixels.
  [[nodiscard]] Dot shift(const Point& v) const;

  /// What can be seen of a segment, or of the convex hull of points, moved by `by`, with some room
  /// around it. May be empty.
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

/// The "d" of a path: "M1 2L3 4"; closed ones end in "Z". Empty if there are no dots.
std::string path_data(const std::vector<Dot>& dots, bool closed);

// How long things in a picture are: a bar of a round length, whose number is exact.

/// A length of one digit, 1, 2 or 5, and a power of ten.
struct RoundLength {
  mpq_class value;
  std::string text;  ///< "0.05", "200"; "2e-7" where that is shorter
};

/// The greatest that is not above `most` > 0.
RoundLength round_length(const mpq_class& most);

// Paths and convex polygons of a picture: cut at a box, and around dots. For doubles, and for exact
// places where doubles would not do.

/// The part of a path, or of a closed convex polygon, that lies between `low` and `high`. Of an
/// open path a segment is expected. Empty if a place is not finite.
std::vector<Dot> clipped(std::vector<Dot> path, bool closed, const Dot& low, const Dot& high);
std::vector<Spot> clipped(std::vector<Spot> path, bool closed, const Spot& low, const Spot& high);

/// The corners of the convex hull, in order. Of doubles for filling: rounding may keep or lose a
/// corner that is almost flat.
std::vector<Dot> outline(std::vector<Dot> dots);
std::vector<Spot> outline(std::vector<Spot> places);

/// The boundary of the union of convex polygons, each in the order that `outline` gives, as
/// segments: of each side what lies in no other polygon and is not the seam between two. For
/// drawing.
std::vector<std::pair<Dot, Dot>> united_outline(const std::vector<std::vector<Dot>>& polygons);

}  // namespace fathom::picture
