// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue, the degradations and the approach to them, as families.
#pragma once

#include "verify/families/degrade.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

/// An entry of the catalogue; the size is ignored.
Bodies from_catalogue(Random& random, unsigned n);

/// An entry of the catalogue with at most 16 points a body, each point moved by at most 2^-k, 4 <= k <= 200; the size is ignored.
Bodies approaching_catalogue(Random& random, unsigned n);

/// random_sphere with at least 4 points, degraded in this way.
Bodies degraded(Degradation way, Random& random, unsigned n);

}  // namespace fathom::families
