// SPDX-License-Identifier: GPL-3.0-or-later
// The look of every page and picture: one set of colours, for light, dark and paper, and the rules
// that pictures are drawn by. Of the colours for A, B, what is true and what is claimed, any two
// can be told apart by the colour-blind; and no meaning hangs on colour alone: A is toned, B is
// hatched, what is claimed is dashed.
#pragma once

#include <string>
#include <string_view>

namespace fathom::picture {

/// The colours as custom properties of the root: --ground, --ink, --soft, --line, --shade, --a,
/// --b, --true, --claimed, --link, --lit. By prefers-color-scheme; print is light. Chooses nothing
/// else.
std::string colour_style();

/// The rules for what scrolls sideways by itself, of class "wide": at an edge a shadow says that
/// more lies beyond it, as a phone shows no bar.
std::string_view scroll_style();

/// The rules, in which "@name" stands for a colour of that name, with custom properties in their
/// place; `plain`: each after the light colour, which stays where var() is unknown.
std::string coloured(std::string_view rules, bool plain);

/// The rules for what scene_panels and scene_document make, by the colours of colour_style.
std::string picture_style();

/// Both, for an SVG file. Programs that know no custom properties draw it in light colours.
std::string document_style();

}  // namespace fathom::picture
