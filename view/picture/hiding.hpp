// SPDX-License-Identifier: GPL-3.0-or-later
// What a convex body hides of an edge behind it, or inside it. The edge and the looks from it to us span a strip of a plane, which a body
// meets in a convex polygon: so a body hides one part of an edge, and its ends are where two of the body's facets are equally far.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include "reference/polytope/polytope.hpp"
#include "view/picture/drawn.hpp"

namespace fathom::picture {

/// Of the segment p + t (q - p) what is between these t: 0 <= from < to <= 1.
struct HiddenPart {
  mpq_class from, to;
};

/// A convex body that may stand before edges. Exact, but for a facet that is seen from its edge: that is taken to lie along the look.
class Cover {
 public:
  /// `hull` is that of the points, or of their multiples. One without interior hides nothing.
  Cover(const std::vector<Point>& points, const polytope::Polytope& hull, const View& view);

  /// The part of the segment whose looks to us enter the interior. What lies on a facet that is seen is not hidden by it.
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

/// The wires in their order, each cut where its being hidden by the covers begins or ends. Those that are hidden stay as they are.
std::vector<Wires::Wire> behind(const std::vector<Wires::Wire>& wires, const std::vector<const Cover*>& covers);

}  // namespace fathom::picture
