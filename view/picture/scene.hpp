// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of a picture: two bodies, the way out of A, the contact; the view; and the scene in
// frames, as SVG.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"
#include "view/picture/drawn.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

/// The answer about two bodies in the form that pictures need. All places are exact if the answer
/// is.
struct PairScene {
  std::optional<Status> status;  ///< nullopt if the bounds leave it open
  View view;                     ///< across the way out
  Drawn a, b;
  Point anchor;  ///< the start of the ways: a point of A
  Point way;     ///< of A: the shortest until the interiors are disjoint, or until the bodies touch; may be zero
  std::optional<Point> claimed;  ///< a claimed translation, shortened if it is out of proportion
  bool cut = false;              ///< whether it was shortened
  /// The faces in contact: for each the points that span it, or one point.
  std::vector<std::vector<Point>> touch_a, touch_b;
  /// Contact patches to be shown, by their corners: on A, and on B.
  std::vector<std::vector<Point>> patches = {};
  bool enclosed = false;  ///< whether only bounds of the way are known
  bool plane = false;     ///< whether these are bodies of the plane, seen from above

  [[nodiscard]] bool approximate() const;  ///< whether an outline is sampled
  [[nodiscard]] bool moves() const;        ///< whether `way` is not zero
  [[nodiscard]] bool has_edges() const;    ///< whether a body has edges or rims, of which hidden ones are dashed
  [[nodiscard]] bool of_unions() const;    ///< whether a body is the union of pieces
  /// Returns the meaning of the dot for a way that is zero: "where they touch", or are nearest, or
  /// would touch.
  [[nodiscard]] std::string_view dot_text() const;
};

/// Two bodies and the answer about them. `plane`, here and below: they are bodies of the plane,
/// seen from above, with x to the right and y up.
struct Pair {
  const GivenPoints& a;
  const GivenPoints& b;
  const Depth& depth;
  bool plane = false;
};

/// Makes the scene of hulls of points. `claimed`: another way to be shown, in the picture's plane
/// too.
PairScene scene_of(const Pair& pair, const std::optional<Point>& claimed = std::nullopt);

/// Makes the scene of unions of convex pieces `a` and `b`, whose search was complete, with one of
/// its optima and the pieces in contact after it. With several contacts two of the planes between
/// pieces are seen from their edges. `claimed` is another way, which is then in the picture's
/// plane.
PairScene scene_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, std::size_t optimum = 0,
                   const std::optional<Point>& claimed = std::nullopt, bool plane = false);

/// Makes the scene of shapes, of which one at most is a half-space; `depth` is theirs.
PairScene scene_of(const Shape& a, const Shape& b, const SignedDepth& depth,
                   const std::optional<Point>& claimed = std::nullopt, bool plane = false);

/// Makes the scene of two bodies of any kinds, in space or in the plane, by the answer about them.
PairScene scene_of(const Body& a, const Body& b, const Answer& answer,
                   const std::optional<Point>& claimed = std::nullopt);

// ---- paint.cpp, page_document.cpp: SVG ----

/// A window of a scene.
struct Panel {
  Window window;
  bool close = false;  ///< a close-up of the ways
};

/// Returns the whole scene, and a close-up of the ways if they are short in it. Curved bodies that
/// are 10^9 times as large have no close-up, because their sampled outlines would be wrong in it.
/// The scene must outlive the panels.
std::vector<Panel> panels_of(const PairScene& scene, const PixelSize& size);

/// Returns the content of a panel's <svg>. `name` begins the ids of elements that it refers to.
std::string painted(const PairScene& scene, const Panel& panel, const std::string& name);

// The picture of a scene, for pages and as a file of its own.

/// The size of a panel on a page.
inline constexpr PixelSize on_pages{420, 300};

/// Returns the meaning of the arrow and the dashed outline, in one sentence or two.
std::string description_of(const PairScene& scene);

/// Returns one or two SVG elements, for an HTML page that has picture_style: the whole scene, and a
/// close-up of the ways if they are short. `name` begins the ids of its elements, and `label` its
/// title; both are markup.
std::string scene_panels(const PairScene& scene, const std::string& name, const std::string& label);

/// Returns a self-contained SVG file: the scene, a title above, and lines of text below. Texts are
/// escaped here.
std::string scene_document(const PairScene& scene, const std::string& title, std::span<const std::string> caption);

}  // namespace fathom::picture
