// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture shows: two bodies, the way out of A, the contact; how one looks at it; and the
// scene in frames, as SVG.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"
#include "view/picture/drawn.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

/// The answer about two bodies, as a picture needs it. All places are exact where the answer is.
struct PairScene {
  std::optional<Status> status;  ///< nullopt if the bounds leave it open
  View view;                     ///< across the way out
  Drawn a, b;
  Point anchor;  ///< where the ways begin: a point of A
  Point way;     ///< of A: the shortest until the interiors are disjoint, or until the bodies touch; may be zero
  std::optional<Point> claimed;  ///< the way that was claimed; cut where it is out of all proportion
  bool cut = false;              ///< whether it was
  /// the faces in contact: of each the points that span it, or one point
  std::vector<std::vector<Point>> touch_a, touch_b;
  /// contact patches that are to be shown, by their corners: on A, and on B
  std::vector<std::vector<Point>> patches;
  bool enclosed = false;  ///< whether the way is known by bounds only

  [[nodiscard]] bool approximate() const;  ///< whether an outline is sampled
  [[nodiscard]] bool moves() const;        ///< whether `way` is not zero
  [[nodiscard]] bool has_edges() const;    ///< whether a body has edges or rims, of which hidden ones are dashed
  [[nodiscard]] bool of_unions() const;    ///< whether a body is the union of pieces
  /// What the dot is that stands for a way that is zero: "where they touch", or are nearest, or
  /// would touch.
  [[nodiscard]] std::string_view dot_text() const;
};

/// Two bodies and what is known about them.
struct Pair {
  const GivenPoints& a;
  const GivenPoints& b;
  const Depth& depth;
};

/// Hulls of points. `claimed`: another way to be shown beside the true one, in the picture's plane
/// too.
PairScene scene_of(const Pair& pair, const std::optional<Point>& claimed = std::nullopt);

/// Unions of convex pieces, whose depth is complete, with one of its optima: both in contact with
/// it. `a` and `b` are what it is about. With several contacts two of the planes between pieces are
/// seen from their edges. `claimed` is another way, which is then in the picture's plane.
PairScene scene_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, std::size_t optimum = 0,
                   const std::optional<Point>& claimed = std::nullopt);

/// Shapes of which one at most is a half-space; `depth` is theirs.
PairScene scene_of(const Shape& a, const Shape& b, const SignedDepth& depth);

// ---- paint.cpp, page_document.cpp: SVG ----

/// A window of a scene.
struct Panel {
  Window window;
  bool close = false;  ///< whether it shows the ways alone
};

/// The whole scene, and a close-up of the ways if they are short in it. Curved bodies that are a
/// thousand million times as large get none: their sampled outlines would be wrong there. The scene
/// must outlive the panels.
std::vector<Panel> panels_of(const PairScene& scene, const PixelSize& size);

/// The content of a panel's <svg>. `name` begins the ids of what it refers to.
std::string painted(const PairScene& scene, const Panel& panel, const std::string& name);

// The picture of a scene, for pages and as a file of its own.

/// A panel on a page.
inline constexpr PixelSize on_pages{420, 300};

/// What the arrow and the dashed outline are, in one sentence or two.
std::string description_of(const PairScene& scene);

/// One or two SVG elements, ready to stand in an HTML page that has picture_style: the whole scene,
/// and a close-up of the ways where they are short. `name` begins the ids of its elements, and
/// `label` its title; both are markup already.
std::string scene_panels(const PairScene& scene, const std::string& name, const std::string& label);

/// An SVG file: the scene, a title above, and lines of text below. It needs nothing else. Texts are
/// escaped here.
std::string scene_document(const PairScene& scene, const std::string& title, std::span<const std::string> caption);

}  // namespace fathom::picture
