// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs whose Gaussian diagrams cross like a grid: K = Theta(mn) facets of P, the worst case of AGHRS.
// A fan is a convex chain in a vertical plane, closed by two points below, one on each side of the plane: the arcs of the chain's
// edges are long and nearly parallel. A's fan opens downwards in the xz-plane, B's upwards in the yz-plane, so every arc of the one
// crosses every arc of the other, and near its top P is the sum of the two chains. `n` is the number of points of each chain.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// Chains on circles of radius 1 (random angles in +-45 degrees), O at a depth below 1: one clear optimum.
Bodies crossed_fans(Random& random, unsigned n);

/// Chains on the parabola z = -t^2 at integer multiples of a unit: the top of P is a paraboloid of revolution with O on its axis, beyond
/// the centre of curvature, so the minimum runs along a whole circle. Facets (i, j) and (i', j') are equally far if
/// (2i+1)^2 + (2j+1)^2 = (2i'+1)^2 + (2j'+1)^2: exact ties. Integer coordinates.
Bodies crossed_parabolas(Random& random, unsigned n);

/// The same with chains at random places on the parabola: near ties along a circle. Coordinates are binary64 numbers.
Bodies crossed_random_parabolas(Random& random, unsigned n);

/// Chains on the twisted cubics (t^3 / 16, t, -t^2) and (t, t^3 / 16, -t^2), |t| <= 1, at random places: the directions of no three edges
/// of a chain lie in one plane, and no arc is upright or level. As x y (x^2 + y^2) / 128 breaks its circle of minima, P has two separate
/// minima, near (1, -1) and (-1, 1) in the chart. They tie up to the random places of the edges, to about 1 / n^2. Coordinates are
/// binary64 numbers.
Bodies crossed_twists(Random& random, unsigned n);

/// Chains on circles of radius 1 over a small patch, O at depth 1: the distances of all (n-3)^2 facets of the patch agree to about w^4 / 4,
/// where w = 1/64 is the patch's half width, that is to about 1.5e-8. Not random.
Bodies crossed_patch(Random& random, unsigned n);

/// Near-regular n-gonal prisms of radius 1 along the y-axis and the x-axis; O close to the part of P that their rims make.
Bodies crossed_prisms(Random& random, unsigned n);

/// The same with corners at random angles (except for eight), and with random heights of the prisms. Coordinates are binary64 numbers.
Bodies crossed_random_prisms(Random& random, unsigned n);

/// Points of thin bands around full circles in the xz-plane and the yz-plane.
Bodies crossed_bands(Random& random, unsigned n);

}  // namespace fathom::families
