// SPDX-License-Identifier: GPL-3.0-or-later
// A scene in frames, as SVG.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "view/picture/scene.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {

/// A feature of a body that a page may light: a vertex, an edge or a facet by the points that span
/// it. Seen only where the page's style says so.
struct Mark {
  bool of_a = true;
  std::vector<Point> points;
  std::string id;  ///< of its element; markup already
};

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
std::string painted(const PairScene& scene, const Panel& panel, const std::string& name,
                    const std::vector<Mark>& marks = {});

// The picture of a scene, for pages and as a file of its own.

/// A panel on a page.
inline constexpr PixelSize on_pages{420, 300};

/// What the arrow and the dashed outline are, in one sentence or two.
std::string description_of(const PairScene& scene);

/// One or two SVG elements, ready to stand in an HTML page that has picture_style: the whole scene,
/// and a close-up of the ways where they are short. `name` begins the ids of its elements, and
/// `label` its title; both are markup already.
std::string scene_panels(const PairScene& scene, const std::string& name, const std::string& label,
                         const std::vector<Mark>& marks = {});

/// An SVG file: the scene, a title above, and lines of text below. It needs nothing else. Texts are
/// escaped here.
std::string scene_document(const PairScene& scene, const std::string& title, std::span<const std::string> caption);

}  // namespace fathom::picture
