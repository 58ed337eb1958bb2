// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies constructed from their answer: flat lenses, one in the other, that come apart soonest in two opposite directions. The
// features that meet there and the distances are chosen first.                                                           [docs/golden.md]
#pragma once

#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

/// The features of A and of B that meet in one direction. A vertex and a vertex, or a vertex and an edge, span no facet of P.
struct Meeting {
  FeatureKind a, b;
};

/// One of the six kinds of facets of P.
Meeting random_meeting(Random& random);

/// B lies between the planes through b_bottom n and b_top n that are orthogonal to n, A between those through a_bottom n and a_top n.
/// In direction n the distance is (b_top - a_bottom) |n|, in direction -n it is (a_top - b_bottom) |n|, which gives the bodies their size.
struct Lenses {
  Vector n;                                    ///< not zero
  Meeting above, below;                        ///< what meets in direction n: A's bottom and B's top; and in direction -n
  mpq_class b_top, b_bottom, a_top, a_bottom;  ///< each body's top above its bottom
};

/// The two bodies, with about `points` points each. Let r be the distance in direction -n, that in direction n at most r, and
/// each body's thickness between a quarter and three quarters of the sum of both. Then all facets of P in other directions are farther
/// than r (1 + 2^-8), and the two facets, if the features that meet span them, hold the foot points of O; if the distance in direction n
/// is negative, it is the distance of the bodies. Coordinates are multiples of powers of 2 with about 20 bits, except for the four numbers
/// times n.
Bodies lenses(const Lenses& plan, Random& random, unsigned points);

/// The binary logarithm of |x|, to within 1; x is not 0.
long binary_logarithm(const mpq_class& x);

/// A random integer direction with components up to `bound`.
Vector random_integer_direction(Random& random, long bound);

/// The quotient sqrt(square) / sqrt(other), rounded down to a multiple of 2^-bits; both positive.
mpq_class quotient_of_roots(const mpq_class& square, const mpq_class& other, long bits);

}  // namespace fathom::families
