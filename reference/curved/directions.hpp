// SPDX-License-Identifier: GPL-3.0-or-later
// Directions in which people put shapes on, beside and into each other: there the support is rational, and the bounds can meet.
#pragma once

#include <vector>

#include "reference/curved/lattice.hpp"

namespace fathom::curved {

/// Returns the few directions with the least h(u)/|u|, as binary64 sees it, best first, of: the axes of the coordinates and of the atoms;
/// normals of discs, and normals of two of them; normals of facets of terms of few points; the direction between the centers, and its part
/// orthogonal to a disc's normal. All are primitive.
std::vector<Vector> likely_directions(const Lattice& lattice, std::size_t most);

/// Returns directions near n whose components have short ratios, in the coordinates or in the frame of some atom's axes: the first
/// fractions to which n is much nearer than to others of their length. Most directions have none. All are primitive, and other than n.
std::vector<Vector> short_directions(const Lattice& lattice, const Vector& n);

}  // namespace fathom::curved
