// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a solid as it lists them: what the mesh goes around several times is listed as
// often, one piece after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fathom/solid.hpp"
#include "kernels/messages.hpp"

namespace fathom::solids {

/// The points that the facets of a piece name, ascending: those of the piece of pieces_of(solid).
std::vector<std::uint32_t> corners_of(const Solid::Piece& piece);

/// Whether piece i is the one before once more.
bool is_repeated(const Solid& solid, std::size_t i);

// Whether the pieces of a solid tile it: the naive twin of all cutting, which knows nothing of
// cuts.

/// Returns what is wrong: a point that is there twice; a piece that is not convex, or not closed;
/// or a flag of a point, a line and a plane, at which the facets of the pieces and the triangles of
/// the mesh do not sum to the same. If nothing is, the winding number of the mesh is the number of
/// pieces around a point, for almost all points. In rationals throughout.        [proofs/solids.md]
kernels::Report validate(const Solid& solid);

}  // namespace fathom::solids
