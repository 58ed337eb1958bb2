// SPDX-License-Identifier: GPL-3.0-or-later
// What a Workspace holds.
#pragma once

#include "fathom/depth.hpp"
#include "kernels/filters/support.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom {

struct Workspace::Parts {
  expanding::Memory<polytope::NarrowInteger> narrow;
  expanding::Memory<mpz_class> wide;
  kernels::ScanMemory scan;
  polytope::NarrowPair pair;  ///< for the caller of an expansion, which leaves it alone
};

}  // namespace fathom
