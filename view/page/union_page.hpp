// SPDX-License-Identifier: GPL-3.0-or-later
// Input   what is known of two unions of convex pieces: the answer, and what pictures of them show.
// Output  one HTML page as that of page.hpp, with the sections that unions have: what happens, and why no shorter way.
#pragma once

#include <string>
#include <vector>

#include "view/stages/union_stages.hpp"

namespace fathom::page {

/// What a page about unions is made of.
struct UnionSheet {
  std::string version;                ///< of fathom
  std::string depth;                  ///< the line of `fathom depth --pieces --json`
  const stages::UnionStages& stages;  ///< of the same bodies
  std::string pair;                   ///< a line of fathom/case/1
  std::vector<std::string> notes;     ///< as in Sheet
  std::string picture;                ///< both bodies as SVG, as in Sheet
};

/// The page. Well-formed whatever ids hold. Throws std::invalid_argument if `depth` is no JSON object.
std::string html_page(const UnionSheet& sheet);

}  // namespace fathom::page
