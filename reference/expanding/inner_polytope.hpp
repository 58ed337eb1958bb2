// SPDX-License-Identifier: GPL-3.0-or-later
// A polytope Q inside P: the form in which an expansion proves how far O is from the boundary of P.                [proofs/certificate.md]
#pragma once

#include <cstdint>
#include <vector>

#include "reference/polytope/position_search.hpp"

namespace fathom {

class Surface;

/// Convex, with O in its interior. Each corner is a corner of at least three facets, no two facets lie in one plane.
struct InnerPolytope {
  std::vector<Difference> vertices;                ///< each stands for the difference of a point of B (second) and one of A (first)
  std::vector<std::vector<std::uint32_t>> facets;  ///< corners, counter-clockwise seen from outside, none on a line with its neighbours
};

/// The facets of a surface: coplanar triangles become one polygon, corners inside facets or edges are dropped.
InnerPolytope inner_polytope(Surface& surface);

}  // namespace fathom
