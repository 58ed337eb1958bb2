// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the page about unions, as parts.hpp: each is HTML.
#pragma once

#include <string>

#include "view/page/parts.hpp"
#include "view/stages/union_stages.hpp"

namespace fathom::page {

/// "A overlaps B by 0.25", without markup.
std::string union_sentence(const Data& depth);
std::string union_subtitle(const Data& depth);
/// Decimals first, exact numbers on demand; bounds beside the depth.
std::string union_facts(const Data& depth, const stages::UnionStages& stages);
/// What touches once A has moved, by pieces; and all optima if there are several.
std::string union_contacts(const Data& depth);

/// The differences of pieces that reach into the ball, with how far O is from their boundary.
std::string piece_sums(const stages::UnionStages& stages);
std::string lead_of_sums(const stages::UnionStages& stages);

}  // namespace fathom::page
