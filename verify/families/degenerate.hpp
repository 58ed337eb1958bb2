// SPDX-License-Identifier: GPL-3.0-or-later
// The degenerate catalogue: ties, shared features, lower-dimensional bodies, extreme coordinates.
#pragma once

#include "verify/families/solids.hpp"

namespace fathom::families {

/// A solid against itself (platonic, prism or box; turned): P is symmetric about O, so every optimum has a twin, and most have more.
Bodies exact_ties(Random& random, unsigned n);
/// The same, with B moved by a small integer vector times 2^-k, 10 <= k <= 200: the ties are broken by about 2^-k.
Bodies near_ties(Random& random, unsigned n);
/// Boxes along the axes with depths 1, 1 + 2^-k, 1 + 2^-j along three axes, turned.
Bodies near_tie_boxes(Random& random, unsigned n);

/// A random body against itself: the depth is its width, and every node and arc of the two diagrams occurs twice (A's opposite B's).
Bodies identical(Random& random, unsigned n);
/// B = -A: all nodes, arcs and faces of the two Gaussian diagrams coincide.
Bodies mirrored(Random& random, unsigned n);
/// B = A scaled by a factor in [1/4, 3/4] and moved a little: B inside A, or nearly.
Bodies nested(Random& random, unsigned n);
/// B = a scaled and moved copy of -A (common normals on one side) or of A (opposite normals).
Bodies common_normals(Random& random, unsigned n);
/// Prisms with one common axis: many parallel edges, coinciding arcs, facets of kind facet-facet.
Bodies parallel_edges(Random& random, unsigned n);
/// Random bodies with repeated points, points on edges, in facets and in the interior added.
Bodies redundant_points(Random& random, unsigned n);

/// Bodies of the given ranks (0 point, 1 segment, 2 polygon, 3 solid) with small half-integer coordinates. Three in four have a common
/// point, at a vertex or halfway between two; half of the segments and polygons are parallel to each other.
Bodies flat(int rank_a, int rank_b, Random& random, unsigned n);

/// random_sphere at the scale 1e-300, at 1e300, and with extents 1e300, 1, 1e-300.
Bodies tiny_coordinates(Random& random, unsigned n);
Bodies huge_coordinates(Random& random, unsigned n);
Bodies uneven_coordinates(Random& random, unsigned n);
/// Each coordinate has a random sign and a random exponent between 1e-300 and 1e300.
Bodies wild_coordinates(Random& random, unsigned n);

}  // namespace fathom::families
