// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle of a picture's plane, shown as a rectangle of pixels. Shifts and scales are exact, so that what is shown is right whatever
// the numbers are, and what lies far outside is cut exactly.
#pragma once

#include <gmpxx.h>

#include <string>
#include <vector>

#include "view/picture/view.hpp"

namespace fathom::picture {

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
  /// The box fits, with a margin; a box of one place gets some room around it. If it is over 100 times as wide as high, or as high as wide,
  /// the axes are scaled apart, so that both can be seen.
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

  /// What can be seen of a segment, or of the convex hull of points, moved by `by`, with some room around it. May be empty.
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

}  // namespace fathom::picture
