// SPDX-License-Identifier: GPL-3.0-or-later
// The style of every page and picture: one set of colours, for light, dark and paper, and the rules
// for drawing pictures. The colours for A, B, the truth and the claim can be distinguished by the
// colour-blind, and each has a second sign: A is toned, B is hatched, the claim is dashed.
#pragma once

#include <string>
#include <string_view>

namespace fathom::picture {

/// Returns the colours as custom properties of the root: --ground, --ink, --soft, --line, --shade,
/// --a, --b, --true, --claimed, --link, --lit. They depend on prefers-color-scheme; print is light.
/// Has no other rules.
std::string colour_style();

/// Returns the rules for elements of class "wide", which scroll sideways: a shadow at an edge shows
/// that there is more beyond it, because phones show no scroll bar.
std::string_view scroll_style();

/// Returns the rules with each "@name" replaced by the custom property of that colour; `plain`:
/// each property twice, first with the light colour, for programs without var().
std::string coloured(std::string_view rules, bool plain);

/// Returns the rules for the output of scene_panels and scene_document, in the colours of
/// colour_style.
std::string picture_style();

/// Returns both, for an SVG file. Programs without custom properties draw it in light colours.
std::string document_style();

}  // namespace fathom::picture
