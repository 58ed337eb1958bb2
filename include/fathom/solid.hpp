// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a closed mesh, which need not be convex.
// Output  convex pieces whose union is its solid, exactly.                      [proofs/solids.md]
//
// The winding number of a mesh at a point is how often its surface goes around it. The mesh is
// closed if no edge is left open; its solid is the closure of the set of all points with a positive
// winding number, which must be negative nowhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fathom/body.hpp"

namespace fathom {

/// A closed mesh, and convex pieces that tile its solid.
struct Solid {
  /// A convex piece: its facets, each by its corners, counter-clockwise from outside.
  struct Piece {
    std::vector<std::vector<std::uint32_t>> facets;  ///< indices into `points`
  };

  std::vector<Point> points;  ///< each once: those of the mesh, then those that cuts made
  /// The mesh: its triangles, and of each larger face the fan from its first corner. Those without
  /// an area are left out.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Piece> pieces;   ///< a piece around which the surface goes k times is listed k times
  bool turned = false;         ///< the faces of the mesh looked inwards; `triangles` look outwards
  bool overlaps = false;       ///< the surface goes around some points more than once
  std::size_t bent_faces = 0;  ///< faces whose corners do not lie in one plane
};

}  // namespace fathom
