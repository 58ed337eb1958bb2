// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the pieces of two bodies.
// Output  all their points as integers in one common unit.
#pragma once

#include <cstdint>
#include <vector>

#include "fathom/union.hpp"
#include "kernels/filters/meeting_points.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::unions {

/// All clouds have one exponent. Points of the lattice are translations of A too.
struct PlacedPieces {
  polytope::PlacedPair whole;  ///< all points of either body, piece after piece
  std::vector<kernels::PointCloud> a, b;

  [[nodiscard]] long exponent() const { return whole.exponent(); }
  /// Piece i of A and piece j of B, on the common lattice.
  [[nodiscard]] polytope::PlacedPair pair(std::uint32_t i, std::uint32_t j) const;

  /// A point of the lattice in the unit of the input, and back.
  [[nodiscard]] Point translation(const kernels::RationalPoint& p) const;
  [[nodiscard]] kernels::RationalPoint point(const Point& translation) const;
  /// A squared length on the lattice, numerator / denominator, in the unit of the input.
  [[nodiscard]] mpq_class squared(const mpz_class& numerator, const mpz_class& denominator) const;
};

/// Throws std::invalid_argument if a body has no pieces, a piece has no points or no interior, or a
/// coordinate is not in lowest terms.
PlacedPieces place_pieces(const Pieces& a, const Pieces& b);

}  // namespace fathom::unions
