// SPDX-License-Identifier: GPL-3.0-or-later
// A body as it is drawn: a polytope by its edges, any other shape by its outline and rims, a half-space up to its plane; a union by the
// edges of its pieces and the outline of all.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

inline constexpr std::size_t most_hidden = 200;  ///< edges of a body that shows those behind it too
inline constexpr std::size_t most_edges = 600;   ///< of one that shows more than its outline

/// A polytope. Bodies of up to most_hidden edges have all of them, larger ones those that are seen, and those of over most_edges the edges
/// of the outline. Without edges if the hull would take too much memory.
struct Wires {
  struct Wire {
    Point from, to;
    bool hidden;
  };
  std::vector<Wire> wires;
  std::vector<Point> corners;  ///< their hull is the body
};

/// A part of an edge that is no segment: where an end face of a cylinder, a cone or the like meets the side. Sampled.
struct Rim {
  std::vector<Point> path;
  bool hidden;
};

/// Discs, balls and what is rounded: the outline is sampled.
struct Curved {
  std::vector<Term> terms;
  mpq_class radius;
  std::vector<Rim> rims;
};

/// The union of polytopes.
struct Compound {
  std::vector<Wires> pieces;     ///< at least one; without edges if those of all are too many
  std::vector<bool> in_contact;  ///< of each piece; none of bodies that are apart
};

using Drawn = std::variant<Wires, Curved, HalfSpace, Compound>;

Wires wires_of(const std::vector<Point>& points, const View& view);
/// A half-space with a radius is moved by it, to within a rounding.
Drawn drawn_shape(const Shape& shape, const View& view);

/// Edges of all pieces together are drawn up to the numbers that hold for those of one polytope. What other pieces hide of an edge is
/// hidden, as is what lies inside them.
Compound compound_of(const std::vector<std::vector<Point>>& pieces, const View& view);

/// Where the body is in the plane; nullopt of a half-space. Of curved bodies to within a few roundings.
std::optional<Bounds2> box_of(const Drawn& body, const View& view);

/// The outline of the body moved by `by`, as far as it is near the window; may be empty. Of half-spaces whose normal lies along the view's
/// x axis. Of a union that of each piece; of any other body there is one.
std::vector<std::vector<Dot>> silhouettes(const Drawn& body, const Window& window, const Point& by = {});

/// A point of the shape, which is no half-space, that is farthest in the direction u, to within a few roundings.
Point farthest(const Shape& shape, const Point& u);

}  // namespace fathom::picture
