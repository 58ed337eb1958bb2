// SPDX-License-Identifier: GPL-3.0-or-later
// Input   what is known of a pair: its answer, its stages, the case itself; and a picture of the
//         bodies.
// Output  one HTML page that shows why the depth is what it is. It holds all of the input, its
//         script and its style, and needs no network. The tables, the pictures and the answer are
//         there without scripts; with them the pictures turn, and a choice in one is lit in all.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/messages.hpp"
#include "reference/text/json_value.hpp"
#include "view/stages/stages.hpp"

namespace fathom::page {

/// How the depth changes while the bodies move.
struct Motions {
  /// An array: of each motion its "name"; "derivative", as in the answer; and "path", what `fathom
  /// depth --along --json` prints.
  std::string json = "[]";
  /// of each what moves and how, its chart as SVG, and how `fathom depth` repeats it
  struct Chart {
    std::string name, svg, repeated;
  };
  std::vector<Chart> charts;
  std::string why_none;  ///< a sentence, if there are none
  bool of_b = false;     ///< whether B moves too, or alone
};

/// What a page is made of.
struct Sheet {
  std::string version;           ///< of fathom
  std::string depth;             ///< a line of `fathom depth --patch --json`
  const stages::Stages& stages;  ///< of the same pair
  std::string pair;              ///< a line of fathom/case/1
  /// what a reader must know before any number: bodies that are not convex, sizes that look wrong
  std::vector<std::string> notes;
  /// both bodies as SVG, ready to stand in HTML with the style of picture_style; empty: there is
  /// none
  std::string picture;
  std::string beside = {};  ///< what is green in it, in words
  Motions motions = {};
  std::string opens = {};  ///< the id of the section that is seen first; empty: the top
};

/// The page. Well-formed whatever ids hold. Throws std::invalid_argument if `depth` is no JSON
/// object.
std::string html_page(const Sheet& sheet);

// Input   what is known of two unions of convex pieces: the answer, and what pictures of them show.
// Output  one HTML page as that of a pair, with the sections that unions have: what happens, and
//         why no shorter way.

/// What a page about unions is made of.
struct UnionSheet {
  std::string version;                ///< of fathom
  std::string depth;                  ///< the line of `fathom depth --pieces --patch --json`
  const stages::UnionStages& stages;  ///< of the same bodies
  std::string pair;                   ///< a line of fathom/case/1
  std::vector<std::string> notes;     ///< as in Sheet
  std::string picture, beside = {};   ///< both bodies as SVG, and what is green, as in Sheet
};

/// The page. Well-formed whatever ids hold. Throws std::invalid_argument if `depth` is no JSON
/// object.
std::string html_page(const UnionSheet& sheet);

// ---- what pages are put together from ----

using Data = text::JsonValue;
using kernels::counted;

/// Returns the text with each {{name}} replaced by the value of that name, which is put in as it
/// is: a gap in a value is none. Throws std::logic_error if a name has no value.
std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

// The files that are part of every page, as the build put them together: see
// view/page/assemble.cmake.

/// The HTML, with {{names}} where a page puts its own.
std::string_view shell();
/// What <main> holds: of two convex bodies, and of two unions.
std::string_view pair_sections();
std::string_view union_sections();
/// The style sheet.
std::string_view style();
/// three.js and the page's own modules, as one script.
std::string_view script();

// Small pieces of HTML over JSON values.

/// A number, a word, or (1, 2, 3) of an array, as text that is escaped; "-" for null. Very long
/// texts are cut, and say so.
std::string shown(const Data& value);

// The parts of the page that are made of its data: each is HTML, and texts of others are escaped in
// it. Numbers of the answer are copied as they stand in its JSON.

/// "A overlaps B by 0.25", without markup.
std::string answer_sentence(const Data& depth);
/// Below the answer: ties, the kind of contact.
std::string subtitle(const Data& depth);
/// Decimals first, exact numbers on demand.
std::string facts(const Data& depth);

// The same about unions.

/// "A overlaps B by 0.25", without markup.
std::string union_sentence(const Data& depth);
std::string union_subtitle(const Data& depth);
/// Decimals first, exact numbers on demand; bounds beside the depth.
std::string union_facts(const Data& depth, const stages::UnionStages& stages);
/// All shortest ways out, if there are several.
std::string union_optima(const Data& depth);

}  // namespace fathom::page
