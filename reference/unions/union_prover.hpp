// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two unions that penetrate.
// Output  the proof of their depth, as plain data.                                                               [proofs/unions_search.md]
#pragma once

#include "fathom/union.hpp"
#include "kernels/context.hpp"
#include "reference/unions/union_proof.hpp"
#include "reference/unions/union_search.hpp"

namespace fathom::unions {

/// Proves the answer of a search that has run to its end; its polytopes grow where that makes the proof shorter. Throws std::logic_error if
/// the answer is not true, and Interrupted.
UnionProof prove(kernels::Context& context, const PlacedPieces& pieces, UnionSearch& search);

/// Searches, and proves what it finds. Throws std::invalid_argument as union_depth does and if the unions do not penetrate; Interrupted.
UnionProof prove_union_depth(kernels::Context& context, const Pieces& a, const Pieces& b);

}  // namespace fathom::unions
