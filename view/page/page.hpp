// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the answer about a pair, its stages, the case itself; and a picture of the bodies.
// Output  one HTML page that shows why the depth is what it is. It contains all of the input, its
//         script and its style, and needs no network. The tables, the pictures and the answer are
//         visible without scripts; with scripts the pictures can be turned, and a choice in one of
//         them is highlighted in all.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/messages.hpp"
#include "reference/text/json_value.hpp"
#include "view/stages/stages.hpp"

namespace fathom::page {

/// The depth while the bodies move.
struct Motions {
  /// An array with, for each motion, its "name"; "derivative", as in the answer; and "path", the
  /// output of `fathom depth --along --json`.
  std::string json = "[]";
  /// For each motion the bodies that move and how, its chart as SVG, and the command of `fathom
  /// depth` for it.
  struct Chart {
    std::string name, svg, repeated;
  };
  std::vector<Chart> charts;
  std::string why_none;  ///< a sentence, if there are no charts
  bool of_b = false;     ///< whether B moves, with or without A
};

/// The contents of a page.
struct Sheet {
  std::string version;           ///< of fathom
  std::string depth;             ///< a line of `fathom depth --patch --json`
  const stages::Stages& stages;  ///< of the same pair
  std::string pair;              ///< a line of fathom/case/1
  /// Warnings that concern all numbers: bodies that are not convex, suspicious sizes.
  std::vector<std::string> notes;
  /// Both bodies as an SVG element for HTML with the style of picture_style; or "".
  std::string picture;
  std::string beside = {};  ///< names of its green parts
  Motions motions = {};
  std::string opens = {};  ///< the id of the section shown first; empty: the top
};

/// Returns the page. Well-formed for any ids. Throws std::invalid_argument if `depth` is no JSON
/// object.
std::string html_page(const Sheet& sheet);

// Input   the answer about two unions of convex pieces, and its data for pictures.
// Output  one HTML page like that of a pair, with the sections for unions: what happens, and why
//         no shorter way.

/// The contents of a page about unions.
struct UnionSheet {
  std::string version;                ///< of fathom
  std::string depth;                  ///< the line of `fathom depth --pieces --patch --json`
  const stages::UnionStages& stages;  ///< of the same bodies
  std::string pair;                   ///< a line of fathom/case/1
  std::vector<std::string> notes;     ///< as in Sheet
  std::string picture, beside = {};   ///< both bodies as SVG, and names of its green parts, as in Sheet
};

/// Returns the page. Well-formed for any ids. Throws std::invalid_argument if `depth` is no JSON
/// object.
std::string html_page(const UnionSheet& sheet);

// ---- the parts of pages ----

using Data = text::JsonValue;
using kernels::counted;

/// Returns the text with each {{name}} replaced by the value of that name, once: a {{name}} within
/// a value is kept. Throws std::logic_error if a name has no value.
std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

// The files that are part of every page, as the build combines them: see view/page/assemble.cmake.

/// Returns the HTML with {{names}} for the parts of a page.
std::string_view shell();
/// Return the content of <main>: for two convex bodies; for two unions, and bodies of the plane.
std::string_view pair_sections();
std::string_view union_sections();
/// Returns the section of unions of space on the differences of their pieces.
std::string_view sum_section();
/// Returns the style sheet.
std::string_view style();
/// Returns three.js and the page's own modules, as one script.
std::string_view script();

// Small pieces of HTML over JSON values.

/// Returns a number, a word, or (1, 2, 3) for an array, as escaped text; "-" for null. Cuts very
/// long texts, and marks the cut.
std::string shown(const Data& value);

// The parts of the page that depend on its data: each returns HTML, and escapes foreign texts.
// Numbers of the answer are copied unchanged from its JSON.

/// Returns "A overlaps B by 0.25", without markup.
std::string answer_sentence(const Data& depth);
/// Returns whether the answer is about bodies of the plane.
bool is_of_plane(const Data& depth);
/// Returns the line below the answer: ties, the kind of contact.
std::string subtitle(const Data& depth);
/// Returns the facts: decimals, with exact numbers folded.
std::string facts(const Data& depth);

// The same for unions.

/// Returns "A overlaps B by 0.25", without markup.
std::string union_sentence(const Data& depth);
std::string union_subtitle(const Data& depth);
/// Returns the facts: decimals, with exact numbers folded; bounds beside the depth.
std::string union_facts(const Data& depth, const stages::UnionStages& stages);
/// Returns all shortest ways out, if there are several.
std::string union_optima(const Data& depth);

}  // namespace fathom::page
