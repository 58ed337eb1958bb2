// SPDX-License-Identifier: GPL-3.0-or-later
// Rounded edges across each other, as meshes of machined parts have them.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// Two bars, bent to an arc, with the edge along the arc rounded off: each body is the hull of a chain of about n / 2 edges swept along the
/// three corners of a fillet's cross-section, and of two points far below. The three copies of a chain edge are parallel, and their arcs in
/// the Gaussian diagram follow one another; the faces between them are parallelograms, exactly plane. The bars cross at the angle with the
/// cosine 3/5: K = Theta(n^2), in several grids, with some crossings of chain edges and cross-section edges beside them.
/// Along one bisector of the angle P bends less than a sphere about O, along the other more: the distance has a saddle in the middle and
/// two separate minima of about 0.98, one on each side. They tie except for a shift of O by at most 2^-16 and for the random places of the
/// edges: to about 2^-16 + 1 / n^2. Coordinates are binary64 numbers.
Bodies crossed_fillets(Random& random, unsigned n);

}  // namespace fathom::families
