// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two unions that penetrate, and the optima.
// Output  the proof of their depth, as plain data.                                                               [proofs/unions.md]
#pragma once

#include "fathom/union.hpp"
#include "kernels/context.hpp"
#include "reference/unions/placed_pieces.hpp"
#include "reference/unions/union_proof.hpp"
#include "reference/unions/union_search.hpp"

namespace fathom::unions {

/// For each pair of pieces a direction u other than 0 with <u, p> >= h_ij(u), as in ProofOptimum. Throws std::logic_error if p is not free.
std::vector<Vector> separations(const UnionSearch& search, const kernels::RationalPoint& p);

/// Proves that these are the optima of unions that penetrate, translations of A in the unit of the input. Throws std::logic_error if they
/// are not, and Interrupted.
UnionProof prove(kernels::Context& context, const PlacedPieces& pieces, const std::vector<UnionOptimum>& optima);

}  // namespace fathom::unions
