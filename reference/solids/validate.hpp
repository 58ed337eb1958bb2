// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the pieces of a solid tile it: the naive twin of all cutting, which knows nothing of
// cuts.
#pragma once

#include "fathom/solid.hpp"
#include "kernels/report.hpp"

namespace fathom::solids {

/// Returns what is wrong: a point that is there twice; a piece that is not convex, or not closed;
/// or a flag of a point, a line and a plane, at which the facets of the pieces and the triangles of
/// the mesh do not sum to the same. If nothing is, the winding number of the mesh is the number of
/// pieces around a point, for almost all points. In rationals throughout.        [proofs/solids.md]
kernels::Report validate(const Solid& solid);

}  // namespace fathom::solids
