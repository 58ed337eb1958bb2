// SPDX-License-Identifier: GPL-3.0-or-later
// Input   what is known of a pair: its answer, its stages, the case itself; and a picture of the
//         bodies.
// Output  one HTML page that shows why the depth is what it is. It holds all of the input, its
//         script and its style, and needs no network. The tables, the pictures and the answer are
//         there without scripts; with them the pictures turn, and a choice in one is lit in all.
#pragma once

#include <string>
#include <vector>

#include "view/stages/stages.hpp"
#include "view/stages/union_stages.hpp"

namespace fathom::page {

/// What a page is made of.
struct Sheet {
  std::string version;           ///< of fathom
  std::string depth;             ///< a line of `fathom depth --json`
  const stages::Stages& stages;  ///< of the same pair
  std::string pair;              ///< a line of fathom/case/1
  /// what a reader must know before any number: bodies that are not convex, sizes that look wrong
  std::vector<std::string> notes;
  /// both bodies as SVG, ready to stand in HTML with the style of picture_style; empty: there is
  /// none
  std::string picture;
};

/// The page. Well-formed whatever ids hold. Throws std::invalid_argument if `depth` is no JSON
/// object.
std::string html_page(const Sheet& sheet);

// Input   what is known of two unions of convex pieces: the answer, and what pictures of them show.
// Output  one HTML page as that of page.hpp, with the sections that unions have: what happens, and
//         why no shorter way.

/// What a page about unions is made of.
struct UnionSheet {
  std::string version;                ///< of fathom
  std::string depth;                  ///< the line of `fathom depth --pieces --json`
  const stages::UnionStages& stages;  ///< of the same bodies
  std::string pair;                   ///< a line of fathom/case/1
  std::vector<std::string> notes;     ///< as in Sheet
  std::string picture;                ///< both bodies as SVG, as in Sheet
};

/// The page. Well-formed whatever ids hold. Throws std::invalid_argument if `depth` is no JSON
/// object.
std::string html_page(const UnionSheet& sheet);

}  // namespace fathom::page
