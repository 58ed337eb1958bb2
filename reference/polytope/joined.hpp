// SPDX-License-Identifier: GPL-3.0-or-later
// The points whose hull holds a union: all of all its pieces.
#pragma once

#include <vector>

#include "fathom/body.hpp"

namespace fathom::polytope {

/// Piece after piece, each in its order; none if there are no pieces. Who has pieces from outside asks for their laws first.
inline std::vector<Point> joined(const Pieces& pieces) {
  std::vector<Point> all;
  for (const std::vector<Point>& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

}  // namespace fathom::polytope
