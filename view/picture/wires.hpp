// SPDX-License-Identifier: GPL-3.0-or-later
// A convex body as the paths of a picture.
#pragma once

#include <string>
#include <vector>

#include "reference/polytope/polytope.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

/// The edges of a hull by input points, and which of them the body hides. Bodies with many edges keep those of their outline alone.
struct Wires {
  struct Wire {
    std::uint32_t from, to;
    bool hidden;
  };
  std::vector<Wire> wires;
  std::vector<std::uint32_t> corners;  ///< the extreme points
};

Wires wires_of(const polytope::Polytope& hull, const View& view);

/// A rectangle of the picture's plane, shown as a rectangle of pixels.
class Viewport {
 public:
  static constexpr double width = 420, height = 300;  ///< pixels

  Viewport(Dot centre, double scale) : centre_(centre), scale_(scale) {}  ///< `scale` pixels for one unit
  /// All dots fit, with a margin; of a single dot, anything around it.
  static Viewport around(const std::vector<Dot>& dots);

  [[nodiscard]] Dot pixel(const Dot& d) const { return {width / 2 + (d.x - centre_.x) * scale_, height / 2 - (d.y - centre_.y) * scale_}; }
  [[nodiscard]] double scale() const { return scale_; }

  /// The "d" of a path: "M1 2L3 4"; closed ones end in "Z". Empty if no part of it is near the frame.
  [[nodiscard]] std::string path(const std::vector<Dot>& dots, bool closed) const;

 private:
  Dot centre_;
  double scale_;
};

}  // namespace fathom::picture
