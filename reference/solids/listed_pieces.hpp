// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a solid as it lists them: what the mesh goes around several times is listed as
// often, one piece after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fathom/solid.hpp"

namespace fathom::solids {

/// The points that the facets of a piece name, ascending: those of the piece of pieces_of(solid).
std::vector<std::uint32_t> corners_of(const Solid::Piece& piece);

/// Whether piece i is the one before once more.
bool is_repeated(const Solid& solid, std::size_t i);

}  // namespace fathom::solids
