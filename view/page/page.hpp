// SPDX-License-Identifier: GPL-3.0-or-later
// Input   what is known of a pair: its answer, its stages, the case itself; and a picture of the bodies.
// Output  one HTML page that shows why the depth is what it is. It holds all of the input, its script and its style, and needs no network.
// The tables, the pictures and the answer are there without scripts; with them the pictures turn, and a choice in one is lit in all.
#pragma once

#include <string>
#include <vector>

#include "view/stages/stages.hpp"

namespace fathom::page {

/// What a page is made of.
struct Sheet {
  std::string version;             ///< of fathom
  std::string depth;               ///< a line of `fathom depth --json`
  const stages::Stages& stages;    ///< of the same pair
  std::string pair;                ///< a line of fathom/case/1
  std::vector<std::string> notes;  ///< what a reader must know before any number: bodies that are not convex, sizes that look wrong
  std::string picture;             ///< both bodies as SVG, ready to stand in HTML with the style of picture_style; empty: there is none
};

/// The page. Well-formed whatever ids hold. Throws std::invalid_argument if `depth` is no JSON object.
std::string html_page(const Sheet& sheet);

}  // namespace fathom::page
