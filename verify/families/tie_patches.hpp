// SPDX-License-Identifier: GPL-3.0-or-later
// Crossed fans whose n^2 pairs of chain edges, one of each body, all have nearly the same distance: the worst that can happen to a
// search for the closest lines. `n` is the number of edges of each chain.
//
// In the chart (x, y) of the direction of the patch A's chain edges lie on the lines x = x_i and B's on y = y_j, with slopes in [-w, w],
// one at random in each of n equal parts. Their distance is (1 + g(x) + g(y)) / sqrt(1 + x^2 + y^2). A fan's support function g can depend
// on one variable only, so x^2 y^2 / 4 cannot be matched; g = (1 - w^2/4) x^2 / 2 - x^4 / 8 comes nearest and leaves, up to terms of
// sixth order, the saddle (x^2 - w^2/2) (y^2 - w^2/2) / 4: a spread of w^4 / 8, with maxima at the centre and in the four corners, and
// four minima, at (+-w, 0) and (0, +-w). Beyond the patch both chains run straight on, so no other part of P is as near to O.
// No arc is upright or level in the chart of (0, 0, 1), and no two ties are exact by symmetry.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// w = 1/32: whatever n, the distances agree to about 1.2e-7, relatively. Neighbouring distances come closer as n grows.
/// Coordinates are binary64 numbers below n = 2^19.
Bodies crossed_ties(Random& random, unsigned n);

/// w = (2n)^(-1/2): the distances agree to about 1/(32 n^2), while slopes are n^(-3/2) apart. Coordinates are binary64 numbers up to
/// n = 2^15, and multiples of 2^-63 at n = 10^6.
Bodies crossed_shrinking_ties(Random& random, unsigned n);

/// w = 1/n: the distances agree to about 1/(8 n^4), rounding included to 1/(2 n^4) or to 2^-47 if that is more. This is less than the
/// square of the gap between neighbouring slopes. Coordinates are binary64 numbers up to n = 2^11, and multiples of 2^-83 at n = 10^6.
Bodies crossed_vanishing_ties(Random& random, unsigned n);

/// The same with corners rounded to multiples of 2^-k, for a random k between 50 and 90: smooth ties with noise at 2^-k, above or below
/// them. Where that would not keep a chain convex it is rounded less, as crossed_vanishing_ties is.
Bodies crossed_noisy_ties(Random& random, unsigned n);

}  // namespace fathom::families
