// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tiers meet: interval arithmetic first, exact integers when the interval holds zero. A third, symbolic tier belongs behind the
// exact one, for signs that are exactly zero; without it zero comes back, and callers treat it as "on".        [design, section 3]
#pragma once

#include "kernels/counters.hpp"
#include "kernels/direction.hpp"
#include "kernels/predicates.hpp"

namespace fathom {

/// The exact sign, -1, 0 or 1, of each predicate of predicates.hpp.
int side_of_equator(const Direction& n, const Direction& z);
int x_order(const Direction& n1, const Direction& n2, const Direction& v);
int side_of_arc(const Direction& n, const Direction& d);
int order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n, const Direction& v);
int order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z);

/// The calls made by this thread so far.
PredicateCounts& predicate_counts();

}  // namespace fathom
