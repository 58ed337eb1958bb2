// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, a polytope Q inside P = B (+) (-A) from a certificate of their depth, and a direction.
// Output  where the ray from O leaves P: no hulls are needed. Its twin is directional_depth.                      [proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <optional>

#include "fathom/depth.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::judging {

/// Returns the greatest f with f u in P, in units of the lattice: exact. Returns nullopt after `patience` support queries; only rays
/// through edges and corners may need many. u is not zero.
std::optional<mpq_class> way_out(const polytope::PlacedPair& placed, const InnerPolytope& inside, const Vector& u, unsigned patience = 200);

}  // namespace fathom::judging
