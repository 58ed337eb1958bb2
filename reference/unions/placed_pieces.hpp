// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the pieces of two bodies.
// Output  all their points as integers in one common unit.
#pragma once

#include <cstdint>
#include <vector>

#include "fathom/union.hpp"
#include "reference/polytope/placed_pair.hpp"

namespace fathom::unions {

/// All clouds have one exponent.
struct PlacedPieces {
  polytope::PlacedPair whole;  ///< all points of either body, piece after piece
  std::vector<kernels::PointCloud> a, b;

  [[nodiscard]] long exponent() const { return whole.exponent(); }
  /// Piece i of A and piece j of B, on the common lattice.
  [[nodiscard]] polytope::PlacedPair pair(std::uint32_t i, std::uint32_t j) const;
};

/// Throws std::invalid_argument if a body has no pieces, a piece has no points or no interior, or a coordinate is not in lowest terms.
PlacedPieces place_pieces(const Pieces& a, const Pieces& b);

}  // namespace fathom::unions
