// SPDX-License-Identifier: GPL-3.0-or-later
// The drawable form of a body: for a polytope its edges, for any other shape its outline and rims,
// for a half-space its boundary plane; for a union the edges of its pieces and the outline of all.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "reference/polytope/polytope.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

inline constexpr std::size_t most_hidden = 200;  ///< the most edges of a body whose hidden edges are drawn
inline constexpr std::size_t most_edges = 600;   ///< the most edges of a body of which more than the outline is drawn

/// A polytope. With up to most_hidden edges it has all of them, with more those that are seen, and
/// with over most_edges those of the outline. It has no edges if the hull would take too much
/// memory.
struct Wires {
  struct Wire {
    Point from, to;
    bool hidden;
  };
  std::vector<Wire> wires;
  std::vector<Point> corners;  ///< their hull is the body
};

/// A part of a curved edge: where an end face of a cylinder, a cone or the like meets the side.
/// Sampled.
struct Rim {
  std::vector<Point> path;
  bool hidden;
};

/// A body with discs, balls or a radius: its outline is sampled.
struct Curved {
  std::vector<Term> terms;
  mpq_class radius;
  std::vector<Rim> rims;
};

/// The union of polytopes.
struct Compound {
  std::vector<Wires> pieces;     ///< at least one; without edges if all together have too many
  std::vector<bool> in_contact;  ///< for each piece, after A has moved; empty: none
};

using Drawn = std::variant<Wires, Curved, HalfSpace, Compound>;

Wires wires_of(const std::vector<Point>& points, const View& view);
/// Returns the form of a shape. A half-space with a radius is moved by it, to within a rounding.
Drawn drawn_shape(const Shape& shape, const View& view);

/// Returns the form of a union. The limits on edges apply to those of all pieces together. Edges
/// are hidden where other pieces hide them, and inside other pieces.
Compound compound_of(const std::vector<std::vector<Point>>& pieces, const View& view);

/// Returns the bounding box of the body in the plane; nullopt for a half-space. For curved bodies
/// to within a few roundings.
std::optional<Bounds2> box_of(const Drawn& body, const View& view);

/// Returns the outline of the body moved by `by`, clipped near the window; may be empty. For
/// half-spaces, whose normal must lie along the view's x axis, or in the plane. For a union,
/// returns the outline of each piece; for other bodies one outline.
std::vector<std::vector<Dot>> silhouettes(const Drawn& body, const Window& window, const Point& by = {});

/// Returns a bound of the distance, in each coordinate, of points of the sum of these terms from
/// the sum of their first atoms' centers.
mpq_class reach_of(const std::vector<Term>& terms);

/// Returns a point of the shape, which must not be a half-space, that is farthest in the direction
/// u, to within a few roundings.
Point farthest(const Shape& shape, const Point& u);

// The part of an edge behind or inside a convex body that the body hides. The edge and the lines of
// sight from it span a strip of a plane, which a body intersects in a convex polygon: so a body
// hides one part of an edge, which ends where two of the body's facets are at the same distance.

/// The part of the segment p + t (q - p) between these t: 0 <= from < to <= 1.
struct HiddenPart {
  mpq_class from, to;
};

/// A convex body that may hide edges. Exact, except that a facet that is seen from its edge is
/// taken to contain the line of sight.
class Cover {
 public:
  /// `hull` is that of the points, or of multiples of them. A body without interior hides nothing.
  Cover(const std::vector<Point>& points, const polytope::Polytope& hull, const View& view);

  /// Returns the part of the segment whose lines of sight enter the interior. A facet that is seen
  /// does not hide points on it.
  [[nodiscard]] std::optional<HiddenPart> hides(const Point& p, const Point& q) const;

 private:
  /// The half-space <normal, x> <= offset, which contains the body.
  struct Side {
    Point normal;
    mpq_class offset, towards;  ///< towards: of its normal along the line of sight; 0 if it is seen from its edge
  };

  [[nodiscard]] bool may_hide(const Point& p, const Point& q) const;

  const View* view_;
  std::vector<Side> sides_;
  Bounds2 box_;        // in the picture's plane
  mpq_class nearest_;  // along the line of sight
};

/// Returns the wires in their order, each split where its hidden part begins or ends. Wires that
/// are hidden already are unchanged.
std::vector<Wires::Wire> behind(const std::vector<Wires::Wire>& wires, const std::vector<const Cover*>& covers);

// The outline of a curved body: the hull of its farthest points in many directions of the picture's
// plane. It lies inside the true outline, by a fraction of a pixel if the body is no larger than
// the picture.

Bounds2 curved_box(const Curved& body, const View& view);
std::vector<Dot> curved_outline(const Curved& body, const Window& window, const Point& by);

// The rims of cylinders, cones, frusta and the like: where a flat end meets the side. Without them
// a cylinder could not be recognised.

/// Returns the circles, or ellipses, that are edges of the sum of the terms, divided into seen and
/// hidden parts. Sampled, in binary64.
std::vector<Rim> rims_of(const std::vector<Term>& terms, const View& view);

}  // namespace fathom::picture
