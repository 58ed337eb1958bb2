// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a scene, for pages and as a file of its own.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "view/picture/paint.hpp"
#include "view/picture/scene.hpp"

namespace fathom::picture {

/// A panel on a page.
inline constexpr PixelSize on_pages{420, 300};

/// What the arrow and the dashed outline are, in one sentence or two.
std::string description_of(const PairScene& scene);

/// One or two SVG elements, ready to stand in an HTML page that has picture_style: the whole scene, and a close-up of the ways where they
/// are short. `name` begins the ids of its elements, and `label` its title; both are markup already.
std::string scene_panels(const PairScene& scene, const std::string& name, const std::string& label, const std::vector<Mark>& marks = {});

/// An SVG file: the scene, a title above, and lines of text below. It needs nothing else. Texts are escaped here.
std::string scene_document(const PairScene& scene, const std::string& title, std::span<const std::string> caption);

}  // namespace fathom::picture
