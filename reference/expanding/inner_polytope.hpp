// SPDX-License-Identifier: GPL-3.0-or-later
// The form in which an expansion proves how far O is from the boundary of P: a polytope inside P.
#pragma once

#include "fathom/depth.hpp"

namespace fathom::expanding {

class Surface;

/// The facets of a surface: coplanar triangles become one polygon, corners inside facets or edges are dropped.
InnerPolytope inner_polytope(Surface& surface);

}  // namespace fathom::expanding
