// SPDX-License-Identifier: GPL-3.0-or-later
// A convex body as it is drawn: a polytope by its edges, any other shape by its outline, a half-space up to its plane.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "view/picture/window.hpp"

namespace fathom::picture {

/// A polytope. Bodies of up to 200 edges have all of them, larger ones those that are seen, and those of over 600 the edges of the outline.
/// Without edges if the hull would take too much memory.
struct Wires {
  struct Wire {
    Point from, to;
    bool hidden;
  };
  std::vector<Wire> wires;
  std::vector<Point> corners;  ///< their hull is the body
};

/// Discs, balls and what is rounded: the outline is sampled.
struct Curved {
  std::vector<Term> terms;
  mpq_class radius;
};

using Drawn = std::variant<Wires, Curved, HalfSpace>;

Wires wires_of(const std::vector<Point>& points, const View& view);
/// A half-space with a radius is moved by it, to within a rounding.
Drawn drawn_shape(const Shape& shape, const View& view);

/// Where the body is in the plane; nullopt of a half-space. Of curved bodies to within a few roundings.
std::optional<Bounds2> box_of(const Drawn& body, const View& view);

/// The outline of the body moved by `by`, as far as it is near the window; may be empty. Of half-spaces whose normal lies along the view's x
/// axis.
std::vector<Dot> silhouette(const Drawn& body, const Window& window, const Point& by = {});

/// A point of the shape, which is no half-space, that is farthest in the direction u, to within a few roundings.
Point farthest(const Shape& shape, const Point& u);

}  // namespace fathom::picture
