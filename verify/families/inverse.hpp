// SPDX-License-Identifier: GPL-3.0-or-later
// Near ties by inverse construction: the kind of the nearest facet, its direction and the gap to the next one are chosen, then the bodies
// are built around them. The next facet is of a random kind.                                                    [docs/golden.md]
#pragma once

#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

/// Lenses with one optimum, where this feature of A meets that of B; the next nearest facet of P lies opposite, farther by the factor
/// 1 + 2^-k, 8 <= k <= 200, and nothing else within 1 + 2^-8. The direction is a random integer vector.
Bodies inverse(FeatureKind a, FeatureKind b, Random& random, unsigned n);

/// The same with an exact tie of two different kinds.
Bodies inverse_tie(Random& random, unsigned n);

}  // namespace fathom::families
