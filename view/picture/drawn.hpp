// SPDX-License-Identifier: GPL-3.0-or-later
// A body as it is drawn: a polytope by its edges, any other shape by its outline and rims, a
// half-space up to its plane; a union by the edges of its pieces and the outline of all.
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

inline constexpr std::size_t most_hidden = 200;  ///< edges of a body that shows those behind it too
inline constexpr std::size_t most_edges = 600;   ///< of one that shows more than its outline

/// A polytope. Bodies of up to most_hidden edges have all of them, larger ones those that are seen,
/// and those of over most_edges the edges of the outline. Without edges if the hull would take too
/// much memory.
struct Wires {
  struct Wire {
    Point from, to;
    bool hidden;
  };
  std::vector<Wire> wires;
  std::vector<Point> corners;  ///< their hull is the body
};

/// A part of an edge that is no segment: where an end face of a cylinder, a cone or the like meets
/// the side. Sampled.
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

/// Edges of all pieces together are drawn up to the numbers that hold for those of one polytope.
/// What other pieces hide of an edge is hidden, as is what lies inside them.
Compound compound_of(const std::vector<std::vector<Point>>& pieces, const View& view);

/// Where the body is in the plane; nullopt of a half-space. Of curved bodies to within a few
/// roundings.
std::optional<Bounds2> box_of(const Drawn& body, const View& view);

/// The outline of the body moved by `by`, as far as it is near the window; may be empty. Of
/// half-spaces whose normal lies along the view's x axis. Of a union that of each piece; of any
/// other body there is one.
std::vector<std::vector<Dot>> silhouettes(const Drawn& body, const Window& window, const Point& by = {});

/// How far a coordinate of the sum of these terms can be from that of the sum of their first atoms'
/// centers.
mpq_class reach_of(const std::vector<Term>& terms);

/// A point of the shape, which is no half-space, that is farthest in the direction u, to within a
/// few roundings.
Point farthest(const Shape& shape, const Point& u);

// What a convex body hides of an edge behind it, or inside it. The edge and the looks from it to us
// span a strip of a plane, which a body meets in a convex polygon: so a body hides one part of an
// edge, and its ends are where two of the body's facets are equally far.

/// Of the segment p + t (q - p) what is between these t: 0 <= from < to <= 1.
struct HiddenPart {
  mpq_class from, to;
};

/// A convex body that may stand before edges. Exact, but for a facet that is seen from its edge:
/// that is taken to lie along the look.
class Cover {
 public:
  /// `hull` is that of the points, or of their multiples. One without interior hides nothing.
  Cover(const std::vector<Point>& points, const polytope::Polytope& hull, const View& view);

  /// The part of the segment whose looks to us enter the interior. What lies on a facet that is
  /// seen is not hidden by it.
  [[nodiscard]] std::optional<HiddenPart> hides(const Point& p, const Point& q) const;

 private:
  /// <normal, x> <= offset inside.
  struct Side {
    Point normal;
    mpq_class offset, towards;  ///< towards: of its normal along the look; 0 if it is seen from its edge
  };

  [[nodiscard]] bool may_hide(const Point& p, const Point& q) const;

  const View* view_;
  std::vector<Side> sides_;
  Bounds2 box_;        // in the picture's plane
  mpq_class nearest_;  // along the look
};

/// The wires in their order, each cut where its being hidden by the covers begins or ends. Those
/// that are hidden stay as they are.
std::vector<Wires::Wire> behind(const std::vector<Wires::Wire>& wires, const std::vector<const Cover*>& covers);

// The outline of a curved body: the hull of its farthest points in many directions of the picture's
// plane. It lies inside the true one, by a fraction of a pixel where the body is no larger than the
// picture.

Bounds2 curved_box(const Curved& body, const View& view);
std::vector<Dot> curved_outline(const Curved& body, const Window& window, const Point& by);

// The rims of cylinders, cones, frusta and their like: where a flat end meets the side. Without
// them a cylinder looks like any blob.

/// The circles, or ellipses, that are edges of the sum of the terms, in parts that are seen and
/// parts that are hidden. Sampled, in binary64.
std::vector<Rim> rims_of(const std::vector<Term>& terms, const View& view);

}  // namespace fathom::picture
