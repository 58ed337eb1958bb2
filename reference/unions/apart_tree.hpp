// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the pieces of two unions, in an order in which pieces near one another are near, and a
//         point that lies in no interior of a P_ij; or a distance of the two unions.
// Output  a proof: blocks of pairs, each with a direction that shows it for all its pairs at once.
//                                                                       [proofs/unions.md, "Blocks"]
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fathom/union.hpp"
#include "kernels/context.hpp"
#include "reference/unions/pieces.hpp"

namespace fathom::unions {

/// A block of pairs: a range of A's pieces times one of B's. The first one is of all pairs. One
/// that is halved stands before its two halves, the lower pieces first, each with all below it; a
/// range [low, high) is cut at the floor of (low + high) / 2.
struct ApartBlock {
  enum class Kind {
    halves_of_a,
    halves_of_b,
    apart  ///< `direction` shows it for all pairs of the block
  };
  Kind kind = Kind::apart;
  Vector direction;  ///< u other than O, primitive
};

/// With h(u) the largest h_ij(u) of a block's pairs: <u, p> >= h(u) for each direction. `known` are
/// directions to be tried: those of contacts. Throws std::logic_error if p lies in the interior of
/// some P_ij, and Interrupted.
std::vector<ApartBlock> apart_tree(kernels::Context& context, const PlacedPieces& pieces,
                                   const kernels::RationalPoint& p, std::span<const Vector> known);

/// The same for unions at a distance, whose square is q > 0: h(u) < 0 and h(u)^2 >= q <u,u>.
/// Throws std::logic_error if two pieces are nearer.
std::vector<ApartBlock> distance_tree(kernels::Context& context, const PlacedPieces& pieces, const mpq_class& squared,
                                      std::span<const Vector> known);

}  // namespace fathom::unions
