// SPDX-License-Identifier: GPL-3.0-or-later
// The files that are part of every page, as the build put them together.                                       [view/page/assemble.cmake]
#pragma once

#include <string_view>

namespace fathom::page {

/// The HTML, with {{names}} where a page puts its own.
std::string_view shell();
/// What <main> holds: of two convex bodies, and of two unions.
std::string_view pair_sections();
std::string_view union_sections();
/// The style sheet.
std::string_view style();
/// three.js and the page's own modules, as one script.
std::string_view script();

}  // namespace fathom::page
