// SPDX-License-Identifier: GPL-3.0-or-later
// The twin of union_depth: one template over the integers, those of fixed size where the lattice is narrow, and mpz_class anywhere.
#pragma once

#include "fathom/union.hpp"

namespace fathom::unions {

/// union_depth in integers of any size.
UnionDepth union_depth_in_mpz(const Pieces& a, const Pieces& b, const UnionOptions& options = {});

}  // namespace fathom::unions
