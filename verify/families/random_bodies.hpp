// SPDX-License-Identifier: GPL-3.0-or-later
// Random bodies, and pairs of them in random poses. `n` is the number of points of each body.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// Uniform in the unit ball, multiples of 2^-20.
Body random_ball_body(Random& random, unsigned n);
/// Near the unit sphere (within 2^-20), multiples of 2^-20: all points are extreme unless two fall together.
Body random_sphere_body(Random& random, unsigned n);
/// Integer points of {0..side}^3; duplicates, collinear and coplanar points abound.
Body random_lattice_body(Random& random, unsigned n, long side = 3);

Bodies random_ball(Random& random, unsigned n);
Bodies random_sphere(Random& random, unsigned n);
Bodies random_lattice(Random& random, unsigned n);
/// Two balls with O well outside their difference.
Bodies random_disjoint(Random& random, unsigned n);

/// Rational half extents in [1/4, 2], rational rotations.
Bodies boxes_posed(Random& random, unsigned n);
/// The same, both moved by one vector of integers from 10^3 to 9 10^6, as a world with one origin has them: binary32 is coarse there.
Bodies far_boxes(Random& random, unsigned n);
Bodies far_sphere(Random& random, unsigned n);
/// Integer corners in {0..4}^3, axes parallel to the coordinates': coplanar facets and parallel edges.
Bodies boxes_aligned(Random& random, unsigned n);
/// Two of the five platonic solids, each turned and scaled.
Bodies platonic_posed(Random& random, unsigned n);
/// The same without turning: many symmetries survive.
Bodies platonic_aligned(Random& random, unsigned n);
/// A prism or antiprism each, n vertices or one more, turned at random.
Bodies prisms_posed(Random& random, unsigned n);

/// Extents 1, 2^-20, 2^-20, both about O.
Bodies needles(Random& random, unsigned n);
/// Extents 1, 1, 2^-20, both about O.
Bodies plates(Random& random, unsigned n);
Bodies needle_and_plate(Random& random, unsigned n);

}  // namespace fathom::families
